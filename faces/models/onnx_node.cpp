// SPDX-License-Identifier: Apache-2.0
#include "faces/models/onnx_node.hpp"

#include "faces/models/onnx_fields.hpp"

#include <algorithm>
#include <set>

namespace tp::onnx {
namespace {

constexpr std::int64_t most_kernel = 512; ///< cells; pads, strides and dilations too

/// What an operator takes.
struct Operator {
    std::string_view name;
    std::size_t least_inputs, most_inputs;
    std::vector<std::string_view> attributes;
};

const std::vector<Operator>& operators() {
    static const std::vector<Operator> all{
        {"Add", 2, 2, {}},
        {"Concat", 1, 16, {"axis"}},
        {"Constant", 0, 0, {"value"}},
        {"Conv", 2, 3, {"dilations", "group", "kernel_shape", "pads", "strides"}},
        {"Gather", 2, 2, {"axis"}},
        {"MaxPool", 1, 1, {"ceil_mode", "kernel_shape", "pads", "strides"}},
        {"PRelu", 2, 2, {}},
        {"Pad", 2, 2, {"mode"}},
        {"Relu", 1, 1, {}},
        {"Reshape", 2, 2, {}},
        {"Shape", 1, 1, {}},
        {"Sigmoid", 1, 1, {}},
        {"Slice", 1, 5, {"axes", "ends", "starts"}},
        {"Softmax", 1, 1, {"axis"}},
        {"Transpose", 1, 1, {"perm"}},
        {"Unsqueeze", 1, 1, {"axes"}},
    };
    return all;
}

/// Whether an attribute's numbers are of use to an operator.
bool is_useful(const Attribute& attribute) {
    const std::size_t count = attribute.numbers.size();
    const auto& [name, numbers, tensor] = attribute;
    if (name == "value")
        return tensor.has_value();
    if (name == "mode")
        return true; // "constant", as is_attribute sees to
    if (name == "group")
        return count == 1 && are_within(numbers, 1, most_of_a_dimension);
    if (name == "kernel_shape" || name == "strides" || name == "dilations")
        return count == 2 && are_within(numbers, 1, most_kernel);
    if (name == "pads")
        return count == 4 && are_within(numbers, 0, most_kernel);
    if (name == "ceil_mode")
        return count == 1 && are_within(numbers, 0, 1);
    if (name == "axis")
        return count == 1 && are_within(numbers, 0, 3);
    if (name == "perm") {
        std::vector<std::int64_t> sorted = numbers;
        std::ranges::sort(sorted);
        for (std::size_t i = 0; i < count; ++i)
            if (sorted[i] != static_cast<std::int64_t>(i))
                return false;
        return count > 0 && count <= 4;
    }
    if (name == "axes")
        return count == 1 && are_within(numbers, 0, 3);
    return count == 1; // starts and ends
}

std::optional<Attribute> attribute_in(std::string_view message) {
    constexpr std::uint64_t one = 3, text = 4, tensor = 5, many = 8, type = 20;
    const auto fields = fields_of(message);
    if (!fields)
        return std::nullopt;
    Attribute attribute;
    std::set<std::uint64_t> kinds, told;
    for (const Field& field : *fields) {
        bool good = false;
        switch (field.number) {
        case 1:
            good = take_word(field, attribute.name);
            break;
        case one:
            good = field.wire == 0 && !kinds.contains(one) && take_numbers(field, attribute.numbers);
            kinds.insert(2);
            break;
        case many:
            good = take_numbers(field, attribute.numbers);
            kinds.insert(7);
            break;
        case text:
            good = field.wire == 2 && field.bytes == "constant" && kinds.empty();
            kinds.insert(3);
            break;
        case tensor: {
            std::string name;
            if (field.wire == 2 && !attribute.tensor)
                attribute.tensor = tensor_in(field.bytes, name);
            good = attribute.tensor.has_value();
            kinds.insert(4);
            break;
        }
        case type:
            good = field.wire == 0 && told.insert(field.value).second && told.size() == 1;
            break;
        default:
            break;
        }
        if (!good)
            return std::nullopt;
    }
    if (kinds.size() != 1 || kinds != told || !is_useful(attribute))
        return std::nullopt;
    const bool single =
        attribute.name == "axis" || attribute.name == "group" || attribute.name == "ceil_mode";
    const std::uint64_t meant = attribute.name == "value" ? 4 : attribute.name == "mode" ? 3 : single ? 2 : 7;
    return *kinds.begin() == meant ? std::optional(attribute) : std::nullopt;
}

} // namespace

std::optional<Node> node_in(std::string_view message) {
    const auto fields = fields_of(message);
    if (!fields)
        return std::nullopt;
    Node node;
    for (const Field& field : *fields) {
        bool good = field.wire == 2;
        if (field.number == 1) {
            good = good && take_word(field, node.inputs.emplace_back());
        } else if (field.number == 5 && good) {
            const auto attribute = attribute_in(field.bytes);
            good = attribute && node.attributes.emplace(attribute->name, *attribute).second;
        } else {
            good = good && ((field.number == 2 && take_word(field, node.output)) ||
                            (field.number == 3 && take_word(field, node.name)) ||
                            (field.number == 4 && take_word(field, node.kind)));
        }
        if (!good)
            return std::nullopt;
    }
    return node.output.empty() ? std::nullopt : std::optional(node);
}

bool fits(const Node& node, const Values& values) {
    const auto kind = std::ranges::find(operators(), node.kind, &Operator::name);
    if (kind == operators().end() || node.inputs.size() < kind->least_inputs ||
        node.inputs.size() > kind->most_inputs || values.contains(node.output))
        return false;
    for (const auto& [name, attribute] : node.attributes)
        if (std::ranges::find(kind->attributes, name) == kind->attributes.end())
            return false;
    const bool may_repeat = node.kind != "Concat"; // what is put together with itself grows without end
    for (std::size_t i = 0; i < node.inputs.size(); ++i)
        if (!values.contains(node.inputs[i]) ||
            !(may_repeat ||
              std::find(node.inputs.begin(), node.inputs.begin() + static_cast<std::ptrdiff_t>(i),
                        node.inputs[i]) == node.inputs.begin() + static_cast<std::ptrdiff_t>(i)))
            return false;
    const auto input = [&](std::size_t i) -> const Value& { return values.find(node.inputs[i])->second; };
    const auto has = [&](const char* name) { return node.attributes.contains(name); };
    if (node.kind == "Constant")
        return has("value");
    if (node.kind == "Concat" || node.kind == "Unsqueeze")
        return has(node.kind == "Concat" ? "axis" : "axes");
    if (node.kind == "Transpose")
        return has("perm");
    if (node.kind == "MaxPool")
        return has("kernel_shape") && !input(0).is_tensor;
    if (node.kind == "Slice") // its places are attributes up to version 9, then inputs
        return node.inputs.size() == 1
                   ? has("starts") && has("ends") && has("axes")
                   : node.inputs.size() > 2 && node.attributes.empty() &&
                         std::all_of(node.inputs.begin() + 1, node.inputs.end(),
                                     [&](const std::string& name) {
                                         const Value& v = values.find(name)->second;
                                         return !v.is_tensor || (v.whole && v.whole->size() == 1);
                                     });
    if (node.kind == "Gather") // one size of a shape
        return input(1).whole && input(1).whole->size() == 1 && are_within(*input(1).whole, 0, 3) &&
               !input(0).is_tensor;
    if (node.kind == "Pad")
        return !input(0).is_tensor && input(1).whole && are_within(*input(1).whole, 0, most_kernel);
    if (node.kind == "Reshape")
        return !input(1).is_tensor || (input(1).whole && is_shape(*input(1).whole));
    if (node.kind == "PRelu")
        return !input(0).is_tensor && input(1).is_tensor && !input(1).whole;
    if (node.kind != "Conv")
        return true;
    const Value& weights = input(1);
    if (!weights.is_tensor || weights.whole || weights.dimensions.size() != 4 || input(0).is_tensor)
        return false;
    const auto group = node.attributes.find("group");
    if (group != node.attributes.end() && weights.dimensions[0] % group->second.numbers[0] != 0)
        return false;
    const auto kernel = node.attributes.find("kernel_shape");
    if (kernel == node.attributes.end() || kernel->second.numbers[0] != weights.dimensions[2] ||
        kernel->second.numbers[1] != weights.dimensions[3])
        return false;
    return node.inputs.size() < 3 ||
           (input(2).is_tensor && !input(2).whole && input(2).dimensions.size() == 1 &&
            input(2).dimensions[0] == weights.dimensions[0]);
}

} // namespace tp::onnx
