// SPDX-License-Identifier: Apache-2.0
#include "faces/detect/yunet_detector.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace tp {
namespace {

constexpr int thorough_side = 1280; ///< px, the longer side of what the net is shown
constexpr int least_side = 64;      ///< px, of what the net is shown; black is added
constexpr float least_face_score = 0.6F;
constexpr float most_face_overlap = 0.3F;
constexpr int most_candidates = 5000;
constexpr double farthest_px = 1e6;

/// What the net answers about each anchor.
constexpr std::size_t place_numbers = 14, class_numbers = 2, overlap_numbers = 1;
constexpr float place_variance = 0.1F, width_variance = 0.1F, height_variance = 0.2F;

/// Where the net looks: around the middle of each cell, squares of these sides.
struct Level {
    int cell;                ///< px
    std::vector<float> side; ///< px
};
const std::array<Level, 4> anchor_levels{
    {{8, {10.0F, 16.0F, 24.0F}}, {16, {32.0F, 48.0F}}, {32, {64.0F, 96.0F}}, {64, {128.0F, 192.0F, 256.0F}}}};

struct Anchor {
    float x, y, side; ///< px
};

std::vector<Anchor> anchors_in(cv::Size size) {
    std::vector<Anchor> anchors;
    const auto quarter = [](int px) { return (px + 1) / 2 / 2; };
    cv::Size cells(quarter(size.width), quarter(size.height));
    for (const Level& level : anchor_levels) {
        cells = {cells.width / 2, cells.height / 2};
        const auto cell = static_cast<float>(level.cell);
        for (int row = 0; row < cells.height; ++row)
            for (int column = 0; column < cells.width; ++column)
                for (const float side : level.side)
                    anchors.push_back({(static_cast<float>(column) + 0.5F) * cell,
                                       (static_cast<float>(row) + 0.5F) * cell, side});
    }
    return anchors;
}

const float* numbers_of(const cv::Mat& answer, std::size_t count) {
    if (answer.type() != CV_32F || !answer.isContinuous() || answer.total() != count)
        throw std::runtime_error("the net's answer is not one of a YuNet");
    return answer.ptr<float>();
}

/// In the picture that the net saw.
Detection placed(const Anchor& anchor, const float* numbers, float score) {
    const auto at = [&](std::size_t i) {
        return Vec2(anchor.x + numbers[i] * place_variance * anchor.side,
                    anchor.y + numbers[i + 1] * place_variance * anchor.side);
    };
    const Vec2 extent(anchor.side * std::exp(numbers[2] * width_variance),
                      anchor.side * std::exp(numbers[3] * height_variance));
    return {{at(0) - 0.5 * extent, at(0) + 0.5 * extent}, at(4), at(6), static_cast<double>(score)};
}

bool is_near(const Detection& face) {
    for (const Vec2 p : {face.box.min, face.box.max, face.right_eye, face.left_eye})
        if (!(std::abs(p.x) < farthest_px && std::abs(p.y) < farthest_px))
            return false;
    return true;
}

} // namespace

std::vector<Detection> YunetDetector::detect(const cv::Mat& picture, Effort effort, Looks&,
                                             const std::stop_token&) {
    const double longest = effort == Effort::usual ? usual_side_ : thorough_side;
    const double scale = std::min(1.0, longest / std::max(picture.cols, picture.rows));
    cv::Mat shrunk = picture;
    if (scale < 1.0)
        cv::resize(picture, shrunk,
                   cv::Size(std::max(1, static_cast<int>(std::lround(picture.cols * scale))),
                            std::max(1, static_cast<int>(std::lround(picture.rows * scale)))),
                   0, 0, cv::INTER_AREA);
    if (std::min(shrunk.cols, shrunk.rows) < least_side)
        cv::copyMakeBorder(shrunk, shrunk, 0, std::max(0, least_side - shrunk.rows), 0,
                           std::max(0, least_side - shrunk.cols), cv::BORDER_CONSTANT);
    net_.setInput(cv::dnn::blobFromImage(shrunk));
    std::vector<cv::Mat> answers;
    net_.forward(answers, std::vector<cv::String>{"loc", "conf", "iou"});
    const std::vector<Anchor> anchors = anchors_in(shrunk.size());
    const float* places = numbers_of(answers.at(0), place_numbers * anchors.size());
    const float* classes = numbers_of(answers.at(1), class_numbers * anchors.size());
    const float* overlaps = numbers_of(answers.at(2), overlap_numbers * anchors.size());

    std::vector<Detection> candidates;
    std::vector<cv::Rect> boxes;
    std::vector<float> scores;
    for (std::size_t i = 0; i < anchors.size(); ++i) {
        const float score = std::sqrt(classes[class_numbers * i + 1] * std::clamp(overlaps[i], 0.0F, 1.0F));
        if (!(score > least_face_score))
            continue;
        const Detection face = placed(anchors[i], places + place_numbers * i, score);
        if (!is_near(face))
            continue;
        candidates.push_back(face);
        boxes.emplace_back(static_cast<int>(face.box.min.x), static_cast<int>(face.box.min.y),
                           static_cast<int>(face.box.width()), static_cast<int>(face.box.height()));
        scores.push_back(score);
    }
    std::vector<int> kept;
    cv::dnn::NMSBoxes(boxes, scores, least_face_score, most_face_overlap, kept, 1.0F, most_candidates);
    std::vector<Detection> found;
    for (const int i : kept) {
        Detection face = candidates[static_cast<std::size_t>(i)];
        for (Vec2* p : {&face.box.min, &face.box.max, &face.right_eye, &face.left_eye})
            *p /= scale;
        found.push_back(face);
    }
    return found;
}

} // namespace tp
