// SPDX-License-Identifier: Apache-2.0
#include "faces/yunet_detector.hpp"

#include <opencv2/imgproc.hpp>

#include <cmath>

namespace tp {
namespace {

constexpr int usual_side = 320, thorough_side = 1280; ///< px, the longer side of what the net is shown
constexpr float least_face_score = 0.6F;
constexpr float most_face_overlap = 0.3F;
constexpr int most_candidates = 5000;

} // namespace

Result<std::unique_ptr<Detector>> YunetDetector::load(const std::filesystem::path& file) {
    try {
        auto net = cv::FaceDetectorYN::create(file.string(), "", cv::Size(usual_side, usual_side),
                                              least_face_score, most_face_overlap, most_candidates);
        auto detector = std::make_unique<YunetDetector>(net);
        detector->detect(cv::Mat::zeros(64, 64, CV_8UC3),
                         Effort::usual); // a net of another kind fails here, not later
        return std::unique_ptr<Detector>(std::move(detector));
    } catch (const std::exception&) {
        return Error{"The file \"" + file.string() + "\" is not a YuNet detector that can be used."};
    }
}

std::vector<Detection> YunetDetector::detect(const cv::Mat& picture, Effort effort, Looks&,
                                             const std::stop_token&) {
    const double longest = effort == Effort::usual ? usual_side : thorough_side;
    const double scale = std::min(1.0, longest / std::max(picture.cols, picture.rows));
    cv::Mat shrunk = picture;
    if (scale < 1.0)
        cv::resize(picture, shrunk,
                   cv::Size(std::max(1, static_cast<int>(std::lround(picture.cols * scale))),
                            std::max(1, static_cast<int>(std::lround(picture.rows * scale)))),
                   0, 0, cv::INTER_AREA);
    net_->setInputSize(shrunk.size());
    cv::Mat rows;
    net_->detect(shrunk, rows);
    std::vector<Detection> found;
    for (int i = 0; i < rows.rows; ++i) {
        const float* row = rows.ptr<float>(i);
        const auto point = [&](int at) { return Vec2(row[at], row[at + 1]) / scale; };
        Detection detection;
        detection.box = {point(0), point(0) + point(2)};
        detection.right_eye = point(4);
        detection.left_eye = point(6);
        detection.score = static_cast<double>(row[14]);
        if (is_finite(detection.box.min) && is_finite(detection.box.max))
            found.push_back(detection);
    }
    return found;
}

} // namespace tp
