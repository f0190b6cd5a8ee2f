// SPDX-License-Identifier: Apache-2.0
#include "faces/models/onnx_values.hpp"

#include "faces/models/onnx_fields.hpp"

#include <algorithm>
#include <cstring>

namespace tp::onnx {
namespace {

constexpr std::int64_t most_numbers = 1 << 26;
constexpr std::size_t most_dimensions = 6;
constexpr std::int64_t float_type = 1, int64_type = 7;

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

} // namespace

bool are_within(const std::vector<std::int64_t>& numbers, std::int64_t least, std::int64_t most) {
    return std::ranges::all_of(numbers, [=](std::int64_t n) { return n >= least && n <= most; });
}

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

bool is_shape(std::vector<std::int64_t> dimensions) {
    const auto open = std::ranges::find(dimensions, -1);
    if (open != dimensions.end())
        *open = 1;
    return numbers_in(dimensions).has_value();
}

} // namespace tp::onnx
