// SPDX-License-Identifier: Apache-2.0
#include "nodes_check.hpp"

#include "device/told_name.hpp"
#include "device/touch_output/force_feedback/event_nodes.hpp"
#include "memory_folder.hpp"

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdio>

namespace tp::test {

namespace {

constexpr std::size_t fields = 5;
constexpr std::array<const char*, fields> files{"capabilities/ff", "capabilities/key", "name", "uniq",
                                                "id/bustype"};

std::array<std::string_view, fields> apart(std::string_view bytes) {
    std::array<std::string_view, fields> parts;
    for (std::string_view& part : parts) {
        const std::size_t end = std::min(bytes.find('\0'), bytes.size());
        part = bytes.substr(0, end);
        bytes.remove_prefix(std::min(end + 1, bytes.size()));
    }
    return parts;
}

/// As a kernel of words of 32 bits writes them.
std::string written(const std::bitset<768>& bits) {
    std::string text;
    for (std::size_t word = bits.size() / 32; word-- > 0;) {
        unsigned long value = 0;
        for (std::size_t i = 32; i-- > 0;)
            value = 2 * value + (bits[32 * word + i] ? 1 : 0);
        std::array<char, 16> digits{};
        std::snprintf(digits.data(), digits.size(), "%lx", value);
        text += (text.empty() ? "" : " ") + std::string(digits.data());
    }
    return text;
}

bool can_be_said(const std::string& name) {
    return name.size() <= 80 && (name.empty() || (name.front() != ' ' && name.back() != ' ')) &&
           std::ranges::all_of(name, [](char c) { return c >= ' ' && c <= '~' && c != '"'; });
}

} // namespace

std::string complaint_about_input_device(std::string_view bytes) {
    const auto parts = apart(bytes);
    const std::string_view first_line = parts[0].substr(0, 1024).substr(0, parts[0].find('\n'));
    for (const unsigned word_bits : {32U, 64U}) {
        const std::bitset<768> bits = kernel_bits(parts[0], word_bits);
        if (kernel_bits(written(bits), 32) != bits)
            return "bits that are written are read as others";
    }
    if (const std::string name = told_name(parts[2]); !can_be_said(name) || told_name(name) != name)
        return "a name cannot be said";

    static const MemoryFolder folder;
    for (std::size_t i = 0; i < fields; ++i)
        folder.file(std::filesystem::path("event7/device") / files[i], parts[i]);
    const std::vector<FoundFeedback> found = find_feedback_below(folder.path(), "/dev/input");
    if (found.size() > 1)
        return "one device is offered twice";
    for (const FoundFeedback& one : found) {
        if (one.path != "/dev/input/event7")
            return "another node is opened";
        if (one.kind == FeedbackKind::none || kernel_bits(first_line, 64).none())
            return "what plays nothing is offered";
        if (one.name.empty() || !can_be_said(one.name) || !can_be_said(one.serial_number))
            return "a device that is offered has no name that can be said";
    }
    return {};
}

} // namespace tp::test
