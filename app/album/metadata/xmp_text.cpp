// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/xmp_text.hpp"

#include "core/base/utf8.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <utility>

namespace tp {

namespace {

constexpr std::array<std::pair<std::string_view, char>, 5> entities = {
    {{"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}}};

/// XML 1.0, 2.2: Char.
constexpr bool is_xml(char32_t code) {
    return code == '\t' || code == '\n' || code == '\r' || (code >= 0x20 && code < 0xD800) ||
           (code >= 0xE000 && code < 0xFFFE) || (code >= 0x10000 && code <= 0x10FFFF);
}

void append_utf8(std::string& text, char32_t code) {
    const auto add = [&](char32_t byte) { text += static_cast<char>(byte); };
    if (code < 0x80) {
        add(code);
    } else if (code < 0x800) {
        add(0xC0 | (code >> 6));
        add(0x80 | (code & 0x3F));
    } else if (code < 0x10000) {
        add(0xE0 | (code >> 12));
        add(0x80 | ((code >> 6) & 0x3F));
        add(0x80 | (code & 0x3F));
    } else {
        add(0xF0 | (code >> 18));
        add(0x80 | ((code >> 12) & 0x3F));
        add(0x80 | ((code >> 6) & 0x3F));
        add(0x80 | (code & 0x3F));
    }
}

/// The character that an entity's name, without & and ;, stands for.
std::optional<char32_t> character(std::string_view name) {
    for (const auto& [known, letter] : entities)
        if (name == known)
            return static_cast<char32_t>(letter);
    if (!name.starts_with('#'))
        return std::nullopt;
    name.remove_prefix(1);
    const bool hexadecimal = name.starts_with('x');
    name.remove_prefix(hexadecimal ? 1 : 0);
    std::uint32_t code = 0;
    const auto [end, error] =
        std::from_chars(name.data(), name.data() + name.size(), code, hexadecimal ? 16 : 10);
    if (error != std::errc{} || end != name.data() + name.size() || !is_xml(code))
        return std::nullopt;
    return code;
}

} // namespace

std::string holdable(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        char32_t code = 0;
        const std::size_t length = utf8_length(text, code);
        if (length == 0)
            result += "\xEF\xBF\xBD"; // U+FFFD
        else if (is_xml(code))
            result += text.substr(0, length);
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return result;
}

std::string escaped(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    for (const char letter : holdable(text)) {
        switch (letter) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '"':
            result += "&quot;";
            break;
        case '\r': // as they are, readers turn these three into other white space
            result += "&#13;";
            break;
        case '\n':
            result += "&#10;";
            break;
        case '\t':
            result += "&#9;";
            break;
        default:
            result += letter;
        }
    }
    return result;
}

std::string unescaped(std::string_view xml) {
    constexpr std::size_t longest_entity = 12;
    std::string result;
    result.reserve(xml.size());
    for (std::size_t i = 0; i < xml.size(); ++i) {
        if (xml[i] == '\r') { // XML 1.0, 2.11
            if (i + 1 >= xml.size() || xml[i + 1] != '\n')
                result += '\n';
            continue;
        }
        if (xml[i] == '&') {
            const std::size_t end = xml.substr(i, longest_entity).find(';');
            if (end != std::string_view::npos)
                if (const auto code = character(xml.substr(i + 1, end - 1))) {
                    append_utf8(result, *code);
                    i += end;
                    continue;
                }
        }
        result += xml[i];
    }
    return holdable(result);
}

} // namespace tp
