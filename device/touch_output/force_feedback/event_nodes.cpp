// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/force_feedback/event_nodes.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <system_error>

namespace tp {

namespace {

constexpr std::size_t game_pad_button = 0x130;       ///< BTN_GAMEPAD, which each game pad has
constexpr std::string_view wired = "0003";           ///< BUS_USB
constexpr std::string_view wireless = "0005";        ///< BUS_BLUETOOTH
constexpr std::string_view made_by_program = "0006"; ///< BUS_VIRTUAL
constexpr unsigned word_of_kernel = 8 * sizeof(long);

std::string told_by_kernel(const std::filesystem::path& file) {
    constexpr std::size_t most = 1024;
    std::ifstream in(file);
    std::string line(most, '\0');
    in.read(line.data(), static_cast<std::streamsize>(most));
    line.resize(static_cast<std::size_t>(in.gcount()));
    return line.substr(0, line.find('\n'));
}

/// What is built in has the name of its driver, which tells a person nothing.
std::string name_for_person(const std::filesystem::path& device, bool game_pad) {
    const std::string bus = told_by_kernel(device / "id/bustype");
    const std::string name = told_name(told_by_kernel(device / "name"));
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

std::string told_name(std::string_view text) {
    constexpr std::size_t longest = 80;
    std::string name;
    for (const char letter : text)
        if (letter >= ' ' && letter <= '~' && letter != '"' && name.size() < longest)
            name += letter;
    const std::size_t first = name.find_first_not_of(' ');
    return first == name.npos ? std::string() : name.substr(first, name.find_last_not_of(' ') + 1 - first);
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
        const auto effects = kernel_bits(told_by_kernel(device / "capabilities/ff"), word_of_kernel);
        if (effects.none())
            continue;
        const bool game_pad =
            kernel_bits(told_by_kernel(device / "capabilities/key"), word_of_kernel)[game_pad_button];
        FeedbackBits bits;
        for (std::size_t i = 0; i < bits.size(); ++i)
            bits[i] = effects[i];
        const FeedbackKind kind = feedback_kind(bits, game_pad);
        if (kind != FeedbackKind::none)
            all.push_back({(nodes / node).string(), name_for_person(device, game_pad),
                           told_name(told_by_kernel(device / "uniq")), kind});
    }
    std::sort(all.begin(), all.end(), [](const FoundFeedback& a, const FoundFeedback& b) {
        return a.path.size() != b.path.size() ? a.path.size() < b.path.size() : a.path < b.path;
    });
    return all;
}

} // namespace tp
