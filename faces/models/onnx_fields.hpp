// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The protobuf that ONNX files are made of, read without trust.
namespace tp::onnx {

/// One field of a protobuf message: a number (wire type 0), or bytes (2; 5, of which a float is made).
struct Field {
    std::uint64_t number = 0;
    int wire = 0;
    std::uint64_t value = 0;
    std::string_view bytes;
};

/// Nothing where the message ends in the middle, or has a field of another wire type.
std::optional<std::vector<Field>> fields_of(std::string_view message);

/// Adds the numbers of a repeated field, one by one or packed; false where it has none.
bool take_numbers(const Field& field, std::vector<std::int64_t>& numbers);

/// A word of printable ASCII that is set once and not empty.
bool take_word(const Field& field, std::string& word);

} // namespace tp::onnx
