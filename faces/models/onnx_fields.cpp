// SPDX-License-Identifier: Apache-2.0
#include "faces/models/onnx_fields.hpp"

#include <algorithm>

namespace tp::onnx {
namespace {

constexpr std::size_t most_name_bytes = 512;

std::optional<std::uint64_t> take_varint(std::string_view& text) {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64 && !text.empty(); shift += 7) {
        const auto byte = static_cast<unsigned char>(text.front());
        text.remove_prefix(1);
        value |= std::uint64_t{byte & 127U} << shift;
        if (byte < 128)
            return value;
    }
    return std::nullopt;
}

bool is_word(std::string_view text) {
    return text.size() <= most_name_bytes &&
           std::ranges::all_of(text, [](char c) { return c >= ' ' && c < 127; });
}

} // namespace

std::optional<std::vector<Field>> fields_of(std::string_view message) {
    std::vector<Field> fields;
    while (!message.empty()) {
        const auto key = take_varint(message);
        if (!key)
            return std::nullopt;
        Field field{*key >> 3, static_cast<int>(*key & 7), 0, {}};
        std::uint64_t size = 4;
        if (field.wire == 0 || field.wire == 2) {
            const auto value = take_varint(message);
            if (!value)
                return std::nullopt;
            (field.wire == 0 ? field.value : size) = *value;
        } else if (field.wire != 5) {
            return std::nullopt;
        }
        if (field.wire != 0) {
            if (size > message.size())
                return std::nullopt;
            field.bytes = message.substr(0, size);
            message.remove_prefix(size);
        }
        fields.push_back(field);
    }
    return fields;
}

bool take_numbers(const Field& field, std::vector<std::int64_t>& numbers) {
    if (field.wire == 0)
        numbers.push_back(static_cast<std::int64_t>(field.value));
    std::string_view packed = field.bytes;
    while (field.wire == 2 && !packed.empty()) {
        const auto value = take_varint(packed);
        if (!value)
            return false;
        numbers.push_back(static_cast<std::int64_t>(*value));
    }
    return field.wire != 5;
}

bool take_word(const Field& field, std::string& word) {
    if (field.wire != 2 || !word.empty() || field.bytes.empty() || !is_word(field.bytes))
        return false;
    word = field.bytes;
    return true;
}

} // namespace tp::onnx
