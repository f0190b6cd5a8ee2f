// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/touch_output/hid_haptics/haptics_reports.hpp"
#include "device/touch_output/hid_haptics/model_haptic_pad.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tp::haptics {

using Bytes = std::vector<std::uint8_t>;

/// Empty where it can be used, or why not.
inline std::string found(std::span<const std::uint8_t> descriptor, Layout& layout) {
    hid::ReportDescriptor parsed;
    if (hid::parse_report_descriptor(descriptor, parsed) != hid::DescriptorFault::none)
        return "cannot be read";
    const char* const why_not = find_layout(parsed, layout);
    return why_not == nullptr ? std::string() : why_not;
}

inline Layout of_model() {
    Layout layout;
    found(ModelHapticPad::descriptor(), layout);
    return layout;
}

} // namespace tp::haptics
