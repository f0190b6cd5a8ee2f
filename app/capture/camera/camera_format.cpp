// SPDX-License-Identifier: Apache-2.0
#include "app/capture/camera/camera_format.hpp"

#include "app/capture/camera/mapped_picture.hpp"

#include <tuple>

namespace tp {

namespace {

long long area(const CameraForm& form) {
    return static_cast<long long>(form.size.width()) * form.size.height();
}

/// What is greater is better.
auto worth(const CameraForm& form) {
    const bool quick = form.frames_per_s >= fewest_frames_per_s;
    const double pixels = static_cast<double>(area(form));
    return quick ? std::tuple(true, pixels, form.frames_per_s) : std::tuple(false, form.frames_per_s, pixels);
}

} // namespace

std::optional<std::size_t> best_form(const std::vector<CameraForm>& forms) {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < forms.size(); ++i) {
        if (!is_read(forms[i].pixels) || forms[i].size.isEmpty() || area(forms[i]) > most_pixels)
            continue;
        if (!best || worth(forms[i]) > worth(forms[*best]))
            best = i;
    }
    return best;
}

} // namespace tp
