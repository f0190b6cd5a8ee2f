// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/dnn/dnn.hpp>

#include <filesystem>
#include <optional>
#include <string_view>

namespace tp {

/// Whether the bytes are an ONNX model (onnx.proto of ONNX 1.6) of the operators that face nets are made of,
/// each with as many inputs as it takes, all of them made before, attributes that mean something and tensors
/// as large as they say. OpenCV believes all of that and falls over what is otherwise.
bool is_plain_onnx(std::string_view bytes);

/// The net in an ONNX file; nothing where the file is none, or not a plain one. Throws what OpenCV and the
/// file system throw.
std::optional<cv::dnn::Net> onnx_net(const std::filesystem::path& file);

} // namespace tp
