// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Tensors and shapes in an ONNX file.
namespace tp::onnx {

constexpr std::int64_t most_of_a_dimension = 1 << 20;

/// What is known of something that nodes take or make.
struct Value {
    std::vector<std::int64_t> dimensions;             ///< of a tensor in the file
    std::optional<std::vector<std::int64_t>> whole{}; ///< the numbers of one of whole numbers
    bool is_tensor = false;                           ///< in the file
};
using Values = std::map<std::string, Value, std::less<>>;

/// A tensor whose bytes are as many as its dimensions say; sets its name where it has one.
std::optional<Value> tensor_in(std::string_view message, std::string& name);

/// A place with a shape: name, numbers, and dimensions, those not told in figures 0.
bool is_place(std::string_view message, std::string& name, std::vector<std::int64_t>& dimensions);

bool are_within(const std::vector<std::int64_t>& numbers, std::int64_t least, std::int64_t most);

/// Whether a tensor may be reshaped to these dimensions, of which one may be -1: what remains.
bool is_shape(std::vector<std::int64_t> dimensions);

} // namespace tp::onnx
