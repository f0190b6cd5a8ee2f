// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace tp {

/// The bytes of an ONNX model of which faces/training/pack_descriptor keeps most numbers in 8 bits; nothing where they
/// are not such bytes, or cut short.
///
/// "TPONNX8\n" and the size of the model (32 bits, little-endian as all that follows). Then by turns: a count (32
/// bits) and so many bytes of the model as they are; rows and columns (32 bits each), for each row its scale and
/// minimum (two floats), and the rows × columns bytes q of numbers, each of which stands for the float
/// scale · q + minimum. The last are bytes as they are.
std::optional<std::vector<char>> unpacked_onnx(std::string_view packed);

} // namespace tp
