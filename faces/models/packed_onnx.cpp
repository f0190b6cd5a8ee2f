// SPDX-License-Identifier: Apache-2.0
#include "faces/models/packed_onnx.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace tp {
namespace {

constexpr std::string_view magic = "TPONNX8\n";

/// Takes bytes from the front; what is asked for beyond the end is nothing, and then all that follows is.
class Front {
public:
    explicit Front(std::string_view bytes) : left_(bytes) {}

    bool failed() const { return failed_; }
    bool ended() const { return left_.empty(); }

    std::string_view bytes(std::uint64_t count) {
        failed_ |= count > left_.size();
        if (failed_)
            return {};
        const std::string_view taken = left_.substr(0, static_cast<std::size_t>(count));
        left_.remove_prefix(taken.size());
        return taken;
    }
    std::uint32_t count() {
        const std::string_view from = bytes(sizeof(std::uint32_t));
        std::uint32_t value = 0;
        if (!failed_)
            std::memcpy(&value, from.data(), sizeof value);
        return value;
    }

private:
    std::string_view left_;
    bool failed_ = false;
};

float float_at(std::string_view bytes, std::size_t index) {
    float value = 0.0F;
    std::memcpy(&value, bytes.data() + index * sizeof value, sizeof value);
    return value;
}

/// Appends the floats that the next rows stand for.
void append_rows(Front& front, std::vector<char>& model) {
    const std::uint64_t rows = front.count(), columns = front.count();
    const std::string_view steps = front.bytes(rows * 2 * sizeof(float));
    const std::string_view numbers = front.bytes(rows * columns);
    if (front.failed())
        return;
    const std::size_t begin = model.size();
    model.resize(begin + numbers.size() * sizeof(float));
    char* to = model.data() + begin;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::size_t row = i / static_cast<std::size_t>(columns);
        const double scale = static_cast<double>(float_at(steps, 2 * row)),
                     minimum = static_cast<double>(float_at(steps, 2 * row + 1));
        const auto value = static_cast<float>(scale * static_cast<unsigned char>(numbers[i]) + minimum);
        std::memcpy(to + i * sizeof value, &value, sizeof value);
    }
}

} // namespace

std::optional<std::vector<char>> unpacked_onnx(std::string_view packed) {
    if (!packed.starts_with(magic))
        return std::nullopt;
    Front front(packed.substr(magic.size()));
    const std::size_t size = front.count();
    std::vector<char> model;
    model.reserve(std::min(size, sizeof(float) * packed.size()));
    for (;;) {
        const std::string_view plain = front.bytes(front.count());
        model.insert(model.end(), plain.begin(), plain.end());
        if (!front.failed() && front.ended() && model.size() == size)
            return model;
        append_rows(front, model);
        if (front.failed() || model.size() > size)
            return std::nullopt;
    }
}

} // namespace tp
