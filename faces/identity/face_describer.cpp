// SPDX-License-Identifier: Apache-2.0
#include "faces/identity/face_describer.hpp"

#include "faces/base/freed_memory.hpp"
#include "faces/decode/quiet_opencv.hpp"
#include "faces/identity/face_square.hpp"
#include "faces/identity/sharpened.hpp"
#include "faces/identity/unfit.hpp"
#include "faces/models/model_catalog.hpp"

#include <opencv2/dnn/dnn.hpp>

#include <algorithm>

namespace tp {

struct FaceDescriber::Net {
    cv::dnn::Net net = embedded_net(EmbeddedModel::descriptor);
};

FaceDescriber::FaceDescriber() = default;
FaceDescriber::~FaceDescriber() = default;

std::optional<FaceNumbers> FaceDescriber::describe(const cv::Mat& picture, const Face& face) {
    const auto places = face_places(face);
    if (!places || picture.type() != CV_8UC3)
        return std::nullopt;
    const auto square = face_square(picture, *places);
    if (!square)
        return std::nullopt;
    const bool has_detail = length(places->left_eye - places->right_eye) >= smallest_eyes_px;
    return describe_square(has_detail ? sharpened_where_soft(*square) : *square);
}

std::optional<FaceNumbers> FaceDescriber::describe_square(const cv::Mat& square) {
    if (square.type() != CV_8UC3 || square.size() != cv::Size(face_square_px, face_square_px))
        return std::nullopt;
    try {
        if (!net_) {
            quiet_opencv();
            net_ = std::make_unique<Net>();
            give_back_freed_memory();
        }
        constexpr bool as_rgb = true;
        net_->net.setInput(cv::dnn::blobFromImage(square, 1.0, cv::Size(), cv::Scalar(), as_rgb));
        const cv::Mat answer = net_->net.forward();
        if (answer.type() != CV_32F || answer.total() != descriptor_length || !answer.isContinuous())
            return std::nullopt;
        FaceNumbers numbers{};
        std::copy_n(answer.ptr<float>(), descriptor_length, numbers.begin());
        return numbers;
    } catch (const cv::Exception&) {
        return std::nullopt;
    }
}

} // namespace tp
