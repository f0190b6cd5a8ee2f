// SPDX-License-Identifier: Apache-2.0
#include "core/svg/sheet_names.hpp"

#include "core/svg/svg_number.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <unordered_set>

namespace tp::svg {

namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";

/// Bytes of the UTF-8 sequence at the front of `text` (overlong forms, surrogates and what lies beyond
/// U+10FFFF are none); 0 where it is broken.
std::size_t sequence_length(std::string_view text) {
    const auto byte = [&](std::size_t i) -> std::uint32_t {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
    };
    const auto tail = [&](std::size_t i) { return (byte(i) & 0xC0u) == 0x80u; };
    const std::uint32_t lead = byte(0);
    if (lead < 0x80)
        return 1;
    if (lead >= 0xC2 && lead <= 0xDF)
        return tail(1) ? 2 : 0;
    if (lead >= 0xE0 && lead <= 0xEF) {
        const bool fits = (lead != 0xE0 || byte(1) >= 0xA0) && (lead != 0xED || byte(1) <= 0x9F);
        return fits && tail(1) && tail(2) ? 3 : 0;
    }
    if (lead >= 0xF0 && lead <= 0xF4) {
        const bool fits = (lead != 0xF0 || byte(1) >= 0x90) && (lead != 0xF4 || byte(1) <= 0x8F);
        return fits && tail(1) && tail(2) && tail(3) ? 4 : 0;
    }
    return 0;
}

/// Control characters and the two non-characters that XML 1.0 forbids, and the white space that it would
/// alter.
bool xml_cannot_hold(std::string_view character) {
    return (character.size() == 1 && static_cast<unsigned char>(character[0]) < 0x20) ||
           character == "\xEF\xBF\xBE" || character == "\xEF\xBF\xBF";
}

/// Calls `use` with each character of valid UTF-8.
template <typename Use>
void for_each_character(std::string_view text, const Use& use) {
    while (!text.empty()) {
        const std::size_t length = std::max<std::size_t>(1, sequence_length(text));
        use(text.substr(0, length));
        text.remove_prefix(length);
    }
}

std::string id_for(std::string_view name) {
    std::string id;
    for_each_character(
        name, [&](std::string_view c) { id += c == " " || xml_cannot_hold(c) ? std::string_view("_") : c; });
    return id;
}

constexpr std::string_view hex_digits = "0123456789ABCDEF";

/// Percent signs, as in URLs, for what XML cannot hold.
std::string encoded(std::string_view name) {
    std::string result;
    for_each_character(name, [&](std::string_view c) {
        if (c != "%" && !xml_cannot_hold(c)) {
            result += c;
            return;
        }
        for (const char byte : c) {
            const auto value = static_cast<unsigned char>(byte);
            result += '%';
            result += hex_digits[value >> 4u];
            result += hex_digits[value & 15u];
        }
    });
    return result;
}

std::string decoded(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::size_t high = i + 2 < text.size() ? hex_digits.find(text[i + 1]) : std::string_view::npos;
        const std::size_t low = i + 2 < text.size() ? hex_digits.find(text[i + 2]) : std::string_view::npos;
        if (text[i] == '%' && high != std::string_view::npos && low != std::string_view::npos) {
            result += static_cast<char>(16 * high + low);
            i += 2;
        } else {
            result += text[i];
        }
    }
    return result;
}

/// Numbers a name upwards until it is free. Remembers where it stopped, so that many bearers stay cheap.
class Numbering {
public:
    explicit Numbering(std::unordered_set<std::string>& taken) : taken_(taken) {}

    std::string next(const std::string& name, const char* joint, std::size_t first) {
        std::size_t& number = next_.try_emplace(name, first).first->second;
        std::string numbered;
        do
            numbered = name + joint + std::to_string(number++);
        while (!taken_.insert(numbered).second);
        return numbered;
    }

private:
    std::unordered_set<std::string>& taken_;
    std::unordered_map<std::string, std::size_t> next_;
};

} // namespace

std::string valid_utf8(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const std::size_t length = sequence_length(text);
        result += length > 0 ? text.substr(0, length) : replacement;
        text.remove_prefix(std::max<std::size_t>(1, length));
    }
    return result;
}

void make_unique(std::vector<std::string>& names) {
    std::unordered_set<std::string> taken(names.begin(), names.end());
    std::unordered_set<std::string> borne;
    Numbering numbering(taken);
    for (std::string& name : names)
        if (!name.empty() && !borne.insert(name).second)
            name = numbering.next(name, " ", 2);
    Numbering nameless(taken);
    for (std::string& name : names)
        if (name.empty())
            name = nameless.next("contour", " ", 1);
}

std::vector<ElementName> spelled(const std::vector<std::string>& names) {
    std::vector<ElementName> result;
    std::unordered_set<std::string> taken;
    for (const std::string& name : names) {
        result.push_back({id_for(name), {}});
        if (result.back().id == name)
            taken.insert(name); // a name that is an id keeps it, whoever stands before
    }
    Numbering numbering(taken);
    for (std::size_t i = 0; i < names.size(); ++i) {
        ElementName& element = result[i];
        if (element.id == names[i])
            continue;
        element.data_name = encoded(names[i]);
        if (!taken.insert(element.id).second)
            element.id = numbering.next(element.id, "_", 2);
    }
    return result;
}

std::string name_from(std::string_view id, std::string_view data_name) {
    if (trimmed(id).empty())
        return {};
    const std::string plain = valid_utf8(id);
    if (data_name.empty())
        return plain;
    const std::string exact = valid_utf8(decoded(data_name));
    const std::string expected = id_for(exact);
    if (!plain.starts_with(expected))
        return plain;
    const std::string_view rest = std::string_view(plain).substr(expected.size());
    const bool numbered = rest.size() > 1 && rest.front() == '_' &&
                          rest.find_first_not_of("0123456789", 1) == std::string_view::npos;
    return rest.empty() || numbered ? exact : plain;
}

} // namespace tp::svg
