// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/touch_output/hid_haptics/haptics_reports.hpp"
#include "device/touch_output/hid_haptics/model_haptic_pad.hpp"

#include <algorithm>
#include <cstddef>
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

/// What the model says of itself.
inline Bytes model() { return {ModelHapticPad::descriptor().begin(), ModelHapticPad::descriptor().end()}; }

/// `to` instead of each `from`, which is as long, from the byte at `behind` on.
inline void put(Bytes& bytes, const Bytes& from, const Bytes& to, std::ptrdiff_t behind = 0) {
    for (auto at = bytes.begin() + behind;
         (at = std::search(at, bytes.end(), from.begin(), from.end())) != bytes.end();)
        at = std::copy(to.begin(), to.end(), at);
}

/// `more` behind the first of `behind`.
inline void add(Bytes& bytes, const Bytes& behind, const Bytes& more) {
    const auto at = std::search(bytes.begin(), bytes.end(), behind.begin(), behind.end());
    bytes.insert(at + static_cast<std::ptrdiff_t>(behind.size()), more.begin(), more.end());
}

/// The model's descriptor with `from` as `to`.
inline Bytes with(const Bytes& from, const Bytes& to) {
    Bytes bytes = model();
    put(bytes, from, to);
    return bytes;
}

/// Where the model's second finger begins.
inline constexpr std::ptrdiff_t second_finger = 77;

/// The model's descriptor with `more` fingers besides, each as its first.
inline Bytes with_more_fingers(std::size_t more) {
    Bytes bytes = model();
    const Bytes end{0xC0};
    const auto begin = bytes.begin() + 8; // behind the application and its report's number
    const Bytes finger(begin, std::search(begin, bytes.end(), end.begin(), end.end()) + 1);
    for (std::size_t i = 0; i < more; ++i)
        bytes.insert(bytes.begin() + 8, finger.begin(), finger.end());
    return bytes;
}

inline Layout of_model() {
    Layout layout;
    found(ModelHapticPad::descriptor(), layout);
    return layout;
}

} // namespace tp::haptics
