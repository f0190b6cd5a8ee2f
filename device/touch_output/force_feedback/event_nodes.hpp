// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "device/touch_output/force_feedback/feedback_node.hpp"

#include <bitset>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// An input device of this machine that can play ticks.
struct FoundFeedback {
    std::string path;          ///< of its node: "/dev/input/event5"
    std::string name;          ///< as a person is told
    std::string serial_number; ///< empty where it tells none
    FeedbackKind kind = FeedbackKind::none;
};

/// Those that are plugged in or built in now, whether or not they may be opened. None but on Linux.
std::vector<FoundFeedback> find_feedback();

/// Those that a Linux kernel shows below `inputs`.
std::vector<FoundFeedback> find_feedback_below(const std::filesystem::path& inputs,
                                               const std::filesystem::path& nodes);

/// The node of one, nothing of which plays. The error says what to do.
Result<std::unique_ptr<FeedbackNode>> open_feedback(const FoundFeedback& found);

/// Bits as the kernel writes them in sysfs: words of `word_bits` in hexadecimal digits, the last one with the lowest bits.
/// None where it is something else.
std::bitset<768> kernel_bits(std::string_view text, unsigned word_bits);

} // namespace tp
