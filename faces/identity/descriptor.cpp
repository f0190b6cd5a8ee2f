// SPDX-License-Identifier: Apache-2.0
#include "faces/identity/descriptor.hpp"

#include <algorithm>
#include <cmath>

namespace tp {

std::optional<FaceDescriptor> descriptor_of(const FaceNumbers& numbers) {
    if (!std::ranges::all_of(numbers, [](float number) { return std::isfinite(number); }))
        return std::nullopt;
    FaceDescriptor bytes{};
    std::ranges::transform(numbers, bytes.begin(), [](float number) {
        const double steps = std::round(static_cast<double>(number) / descriptor_step);
        return static_cast<std::int8_t>(std::clamp(steps, -127.0, 127.0));
    });
    return bytes;
}

double distance(const FaceNumbers& a, const FaceNumbers& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < descriptor_length; ++i) {
        const double apart = static_cast<double>(a[i]) - static_cast<double>(b[i]);
        sum += apart * apart;
    }
    return std::sqrt(sum);
}

double distance(const FaceDescriptor& a, const FaceDescriptor& b) {
    return descriptor_step * std::sqrt(static_cast<double>(squared_distance(a, b)));
}

std::int32_t squared_distance(const FaceDescriptor& a, const FaceDescriptor& b) {
    std::int32_t sum = 0;
    for (std::size_t i = 0; i < descriptor_length; ++i) {
        const std::int32_t apart = a[i] - b[i];
        sum += apart * apart;
    }
    return sum;
}

} // namespace tp
