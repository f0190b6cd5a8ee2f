// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/models/onnx_values.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The operators of an ONNX file, and what each of them takes.
namespace tp::onnx {

struct Attribute {
    std::string name;
    std::vector<std::int64_t> numbers;
    std::optional<Value> tensor;
};

struct Node {
    std::vector<std::string> inputs;
    std::string output, name, kind;
    std::map<std::string, Attribute, std::less<>> attributes;
};

/// Nothing where its bytes or an attribute mean nothing.
std::optional<Node> node_in(std::string_view message);

/// Whether a node's inputs are there and what its operator takes.
bool fits(const Node& node, const Values& values);

} // namespace tp::onnx
