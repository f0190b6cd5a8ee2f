// SPDX-License-Identifier: Apache-2.0
#include "faces/models/onnx_file.hpp"

#include "faces/decode/picture_file.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace tp {
namespace {

constexpr std::uintmax_t most_net_bytes = 256U << 20;
constexpr std::int64_t most_of_a_dimension = 1 << 20, most_numbers = 1 << 26, most_input_px = 4096;
constexpr std::size_t most_dimensions = 6, most_name_bytes = 512, most_nodes = 10'000;
constexpr std::int64_t most_kernel = 512; ///< cells; pads, strides and dilations too
constexpr std::int64_t float_type = 1, int64_type = 7;

/// One field of a protobuf message: a number (wire type 0), or bytes (2; 5, of which a float is made).
struct Field {
    std::uint64_t number = 0;
    int wire = 0;
    std::uint64_t value = 0;
    std::string_view bytes;
};

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

/// Nothing where the message ends in the middle, or has a field of another wire type.
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

/// Numbers of a repeated field, one by one or packed.
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

bool is_word(std::string_view text) {
    return text.size() <= most_name_bytes &&
           std::ranges::all_of(text, [](char c) { return c >= ' ' && c < 127; });
}

/// A word that is set once and not empty.
bool take_word(const Field& field, std::string& word) {
    if (field.wire != 2 || !word.empty() || field.bytes.empty() || !is_word(field.bytes))
        return false;
    word = field.bytes;
    return true;
}

bool are_within(const std::vector<std::int64_t>& numbers, std::int64_t least, std::int64_t most) {
    return std::ranges::all_of(numbers, [=](std::int64_t n) { return n >= least && n <= most; });
}

/// The product; nothing where it is not from 1 to most_numbers.
std::optional<std::int64_t> numbers_in(const std::vector<std::int64_t>& dimensions) {
    std::int64_t count = 1;
    if (dimensions.size() > most_dimensions || !are_within(dimensions, 1, most_of_a_dimension))
        return std::nullopt;
    for (const std::int64_t size : dimensions)
        if ((count *= size) > most_numbers)
            return std::nullopt;
    return count;
}

/// What is known of something that nodes take or make.
struct Value {
    std::vector<std::int64_t> dimensions;             ///< of a tensor in the file
    std::optional<std::vector<std::int64_t>> whole{}; ///< the numbers of one of whole numbers
    bool is_tensor = false;                           ///< in the file
};
using Values = std::map<std::string, Value, std::less<>>;

std::optional<Value> tensor_in(std::string_view message, std::string& name) {
    const auto fields = fields_of(message);
    if (!fields)
        return std::nullopt;
    Value value;
    value.is_tensor = true;
    std::int64_t type = 0;
    std::string_view raw;
    for (const Field& field : *fields) {
        const bool good = field.number == 1   ? take_numbers(field, value.dimensions)
                          : field.number == 8 ? take_word(field, name)
                          : field.number == 2 ? field.wire == 0 && type == 0
                                              : field.number == 9 && field.wire == 2 && raw.empty();
        if (!good)
            return std::nullopt;
        if (field.number == 2)
            type = static_cast<std::int64_t>(field.value);
        if (field.number == 9)
            raw = field.bytes;
    }
    const auto count = numbers_in(value.dimensions);
    if (!count || (type != float_type && type != int64_type))
        return std::nullopt;
    const std::size_t each = type == float_type ? sizeof(float) : sizeof(std::int64_t);
    if (raw.size() != static_cast<std::size_t>(*count) * each)
        return std::nullopt;
    if (type == int64_type) {
        value.whole.emplace(static_cast<std::size_t>(*count));
        std::memcpy(value.whole->data(), raw.data(), raw.size());
    }
    return value;
}

/// A place with a shape: name, numbers, and dimensions, those not told in figures 0.
bool is_place(std::string_view message, std::string& name, std::vector<std::int64_t>& dimensions) {
    std::string_view inner;
    const auto only = [&](std::string_view outer, std::uint64_t number) {
        const auto fields = fields_of(outer);
        if (!fields || fields->size() != 1 || fields->front().number != number || fields->front().wire != 2)
            return false;
        inner = fields->front().bytes;
        return true;
    };
    const auto fields = fields_of(message);
    if (!fields)
        return false;
    std::string_view type;
    for (const Field& field : *fields)
        if (field.number == 1 ? !take_word(field, name)
                              : field.number != 2 || field.wire != 2 || !type.empty())
            return false;
        else if (field.number == 2)
            type = field.bytes;
    if (!only(type, 1))
        return false;
    const auto tensor = fields_of(inner);
    if (!tensor || tensor->size() != 2 || (*tensor)[0].number != 1 || (*tensor)[0].wire != 0 ||
        (*tensor)[0].value != float_type || (*tensor)[1].number != 2 || (*tensor)[1].wire != 2)
        return false;
    const auto shape = fields_of((*tensor)[1].bytes);
    if (!shape)
        return false;
    for (const Field& dimension : *shape) {
        const auto size = fields_of(dimension.bytes);
        if (dimension.number != 1 || dimension.wire != 2 || !size || size->size() > 1)
            return false;
        const bool told = !size->empty() && size->front().number == 1 && size->front().wire == 0;
        dimensions.push_back(told ? static_cast<std::int64_t>(size->front().value) : 0);
    }
    return dimensions.size() <= most_dimensions && are_within(dimensions, 0, most_of_a_dimension);
}

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

/// Of dimensions of which one may be left to what remains.
bool is_shape(std::vector<std::int64_t> dimensions) {
    const auto open = std::ranges::find(dimensions, -1);
    if (open != dimensions.end())
        *open = 1;
    return numbers_in(dimensions).has_value();
}

struct Attribute {
    std::string name;
    std::vector<std::int64_t> numbers;
    std::optional<Value> tensor;
};

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

struct Node {
    std::vector<std::string> inputs;
    std::string output, name, kind;
    std::map<std::string, Attribute, std::less<>> attributes;
};

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

/// Whether a node's inputs are there and what its operator takes.
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

bool is_plain_graph(std::string_view message) {
    const auto fields = fields_of(message);
    if (!fields)
        return false;
    Values values;
    std::vector<Node> nodes;
    std::size_t inputs = 0, outputs = 0;
    for (const Field& field : *fields) {
        if (field.wire != 2)
            return false;
        std::string name;
        std::vector<std::int64_t> dimensions;
        switch (field.number) {
        case 1: {
            auto node = node_in(field.bytes);
            if (!node || nodes.size() == most_nodes)
                return false;
            nodes.push_back(std::move(*node));
            break;
        }
        case 2: // its name
            break;
        case 5: {
            const auto tensor = tensor_in(field.bytes, name);
            if (!tensor || name.empty() || !values.emplace(name, *tensor).second)
                return false;
            break;
        }
        case 11:
            if (!is_place(field.bytes, name, dimensions) || name.empty() || dimensions.size() != 4 ||
                dimensions[1] != 3 || !are_within(dimensions, 0, most_input_px) || ++inputs > 1 ||
                !values.emplace(name, Value{}).second)
                return false;
            break;
        case 12:
            if (!is_place(field.bytes, name, dimensions) || name.empty())
                return false;
            ++outputs;
            break;
        default:
            return false;
        }
    }
    std::set<std::string> names;
    for (const Node& node : nodes) {
        if (!fits(node, values) || (!node.name.empty() && !names.insert(node.name).second))
            return false;
        const auto value = node.attributes.find("value");
        values.emplace(node.output, value == node.attributes.end() ? Value{} : *value->second.tensor);
    }
    return inputs == 1 && outputs > 0;
}

} // namespace

bool is_plain_onnx(std::string_view bytes) {
    const auto fields = fields_of(bytes);
    if (!fields)
        return false;
    std::size_t graphs = 0;
    for (const Field& field : *fields) {
        if (field.number < 1 || field.number > 8)
            return false;
        if (field.number == 7 && (field.wire != 2 || ++graphs > 1 || !is_plain_graph(field.bytes)))
            return false;
    }
    return graphs == 1;
}

std::optional<cv::dnn::Net> onnx_net(const std::filesystem::path& file) {
    if (std::filesystem::file_size(file) > most_net_bytes)
        return std::nullopt;
    const Result<Bytes> bytes = read_bytes(file);
    if (!bytes)
        return std::nullopt;
    const auto* text = reinterpret_cast<const char*>(bytes->data());
    if (!is_plain_onnx({text, bytes->size()}))
        return std::nullopt;
    return cv::dnn::readNetFromONNX(text, bytes->size());
}

} // namespace tp
