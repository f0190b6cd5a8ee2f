// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/force_feedback/event_nodes.hpp"

#include "core/files/first_line.hpp"
#include "device/told_name.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <system_error>

namespace tp {

namespace {

constexpr std::size_t game_pad_button = 0x130;       ///< BTN_GAMEPAD, which each game pad has
constexpr std::string_view wired = "0003";           ///< BUS_USB
constexpr std::string_view wireless = "0005";        ///< BUS_BLUETOOTH
constexpr std::string_view made_by_program = "0006"; ///< BUS_VIRTUAL
constexpr unsigned word_of_kernel = 8 * sizeof(long);

/// What is built in has the name of its driver, which tells a person nothing.
std::string name_for_person(const std::filesystem::path& device, bool game_pad) {
    const std::string bus = first_line(device / "id/bustype");
    const std::string name = told_name(first_line(device / "name"));
    const bool plugged = bus == wired || bus == wireless || bus == made_by_program;
    if (!name.empty() && (game_pad || plugged))
        return name;
    return game_pad ? "game pad" : "vibration motor of this machine";
}

} // namespace

std::bitset<768> kernel_bits(std::string_view text, unsigned word_bits) {
    std::bitset<768> bits;
    std::size_t shift = 0;
    while (!text.empty()) {
        const std::size_t space = text.find_last_of(' ');
        const std::string_view word = space == text.npos ? text : text.substr(space + 1);
        std::uint64_t value = 0;
        const auto read = std::from_chars(word.data(), word.data() + word.size(), value, 16);
        if (read.ec != std::errc() || read.ptr != word.data() + word.size() || shift >= bits.size())
            return {};
        bits |= std::bitset<768>(value) << shift;
        shift += word_bits;
        text = space == text.npos ? std::string_view() : text.substr(0, space);
    }
    return bits;
}

std::vector<FoundFeedback> find_feedback_below(const std::filesystem::path& inputs,
                                               const std::filesystem::path& nodes) {
    std::vector<FoundFeedback> all;
    std::error_code problem;
    for (std::filesystem::directory_iterator at(inputs, problem), end; !problem && at != end;
         at.increment(problem)) {
        const std::filesystem::path node = at->path().filename();
        const std::filesystem::path device = at->path() / "device";
        if (!node.string().starts_with("event"))
            continue;
        const auto effects = kernel_bits(first_line(device / "capabilities/ff"), word_of_kernel);
        if (effects.none())
            continue;
        const bool game_pad =
            kernel_bits(first_line(device / "capabilities/key"), word_of_kernel)[game_pad_button];
        FeedbackBits bits;
        for (std::size_t i = 0; i < bits.size(); ++i)
            bits[i] = effects[i];
        const FeedbackKind kind = feedback_kind(bits, game_pad);
        if (kind != FeedbackKind::none)
            all.push_back({(nodes / node).string(), name_for_person(device, game_pad),
                           told_name(first_line(device / "uniq")), kind});
    }
    std::sort(all.begin(), all.end(), [](const FoundFeedback& a, const FoundFeedback& b) {
        return a.path.size() != b.path.size() ? a.path.size() < b.path.size() : a.path < b.path;
    });
    return all;
}

} // namespace tp
