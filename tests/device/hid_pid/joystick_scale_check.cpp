// SPDX-License-Identifier: Apache-2.0
#include "joystick_scale_check.hpp"

#include "device/hid_pid/joystick_scale_file.hpp"

#include <cmath>

namespace tp::test {

std::string complaint_about_joystick_scales(std::string_view bytes) {
    const auto scale = joystick_scale_in(bytes, "one");
    if (!scale)
        return {};
    if (!(scale->newtons_at_full >= least_joystick_newtons) ||
        !(scale->newtons_at_full <= greatest_joystick_newtons))
        return "a force that no stick has";
    return std::abs(scale->sign.x) == 1.0 && std::abs(scale->sign.y) == 1.0 ? "" : "a direction that is none";
}

} // namespace tp::test
