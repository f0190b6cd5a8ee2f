// SPDX-License-Identifier: Apache-2.0
#include "calibration_check.hpp"

#include "device/calibration_file.hpp"

namespace tp::test {

std::string complaint_about_calibrations(std::string_view bytes) {
    const Calibrations found = calibrations_in(bytes);
    for (const auto& [key, one] : found)
        if (!is_plausible(one.device_to_surface) || !(one.residual_mm >= 0.0 && one.residual_mm <= most_residual_mm))
            return "accepts a calibration that cannot be: " + key;
    const Calibrations again = calibrations_in(text_of(found));
    if (again.size() != found.size())
        return "loses a calibration that it has written";
    for (const auto& [key, one] : found) {
        const auto same = again.find(key);
        if (same == again.end() || same->second.device_to_surface.linear != one.device_to_surface.linear ||
            same->second.device_to_surface.offset != one.device_to_surface.offset ||
            same->second.residual_mm != one.residual_mm || same->second.used != one.used)
            return "reads another calibration than it has written";
    }
    return {};
}

} // namespace tp::test
