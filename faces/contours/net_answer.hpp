// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/dnn/dnn.hpp>

#include <array>
#include <cstddef>

namespace tp {

/// What a net of resources/models says of a window's pixels (8-bit BGR): the first `Count` numbers.
template <std::size_t Count>
std::array<double, Count> answer_to(cv::dnn::Net& net, const cv::Mat& pixels) {
    net.setInput(cv::dnn::blobFromImage(pixels, 1.0 / 255.0, cv::Size(), cv::Scalar::all(127.5)));
    const cv::Mat output = net.forward();
    std::array<double, Count> numbers{};
    for (std::size_t i = 0; i < Count; ++i)
        numbers[i] = static_cast<double>(output.ptr<float>()[i]);
    return numbers;
}

} // namespace tp
