// SPDX-License-Identifier: Apache-2.0
#include "faces/models/onnx_file.hpp"

#include "faces/decode/picture_file.hpp"
#include "faces/models/onnx_fields.hpp"
#include "faces/models/onnx_node.hpp"
#include "faces/models/onnx_values.hpp"

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace tp {
namespace onnx {
namespace {

constexpr std::int64_t most_input_px = 4096;
constexpr std::size_t most_nodes = 10'000;

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
} // namespace onnx

bool is_plain_onnx(std::string_view bytes) {
    const auto fields = onnx::fields_of(bytes);
    if (!fields)
        return false;
    std::size_t graphs = 0;
    for (const onnx::Field& field : *fields) {
        if (field.number < 1 || field.number > 8)
            return false;
        if (field.number == 7 && (field.wire != 2 || ++graphs > 1 || !onnx::is_plain_graph(field.bytes)))
            return false;
    }
    return graphs == 1;
}

std::optional<cv::dnn::Net> onnx_net(const std::filesystem::path& file) {
    constexpr std::uintmax_t most_net_bytes = 256U << 20;
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
