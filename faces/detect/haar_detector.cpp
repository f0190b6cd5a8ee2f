// SPDX-License-Identifier: Apache-2.0
#include "faces/detect/haar_detector.hpp"

#include "faces/decode/picture.hpp"
#include "faces/decode/quiet_opencv.hpp"
#include "faces/models/haar_file.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace tp {
namespace {

constexpr int usual_search_px = 640, thorough_search_px = 1280; ///< the longer side of what is searched
constexpr double window_growth = 1.1;                           ///< from one size of window to the next
/// Windows at about the same place that make a face, and how much these may differ (OpenCV's own choices).
constexpr int least_windows = 3;
constexpr double most_window_difference = 0.2;
/// Of which faces are made: a frontal portrait takes 100; putting them together takes the square of their
/// number.
constexpr std::size_t most_windows = 10'000;
constexpr double sure_windows = 20.0; ///< of a face with a score of a half

// In the square that is found, fractions of its side: means of 68 frontal portraits with contours placed by
// hand (Face Research Lab London Set; standard deviation 0.014).
constexpr Vec2 right_eye_place{0.317, 0.409}, left_eye_place{0.682, 0.409};
/// The head without hair is 1.08 times as large and reaches as far below.
constexpr Vec2 head_begin{-0.04, 0.0}, head_end{1.04, 1.08};

} // namespace

Result<std::unique_ptr<Detector>> HaarDetector::load(const std::filesystem::path& file) {
    const Error unusable{"The file \"" + file.string() + "\" is not a Haar cascade that can be used."};
    try {
        quiet_opencv();
        const HushedThread hushed;
        auto cascade = haar_cascade(file);
        if (!cascade)
            return unusable;
        auto detector = std::make_unique<HaarDetector>(std::move(*cascade));
        detector->detect(cv::Mat::zeros(128, 128, CV_8UC3), Effort::usual); // what fails, fails here
        return std::unique_ptr<Detector>(std::move(detector));
    } catch (const std::exception&) {
        return unusable;
    }
}

std::vector<Detection> HaarDetector::detect(const cv::Mat& picture, Effort effort, Looks&,
                                            const std::stop_token&) {
    const cv::Mat shrunk =
        not_larger_than(picture, effort == Effort::usual ? usual_search_px : thorough_search_px);
    const Vec2 back(static_cast<double>(picture.cols) / shrunk.cols,
                    static_cast<double>(picture.rows) / shrunk.rows);
    cv::Mat grey;
    cv::cvtColor(shrunk, grey, cv::COLOR_BGR2GRAY);
    std::vector<cv::Rect> boxes;
    cascade_.detectMultiScale(grey, boxes, window_growth, 0);
    boxes.resize(std::min(boxes.size(), most_windows));
    std::vector<int> windows;
    cv::groupRectangles(boxes, windows, least_windows, most_window_difference);
    std::vector<Detection> found;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const auto place = [&](Vec2 in_box) {
            return back * (Vec2(boxes[i].x, boxes[i].y) + in_box * Vec2(boxes[i].width, boxes[i].height));
        };
        found.push_back({{place(head_begin), place(head_end)},
                         place(right_eye_place),
                         place(left_eye_place),
                         windows[i] / (windows[i] + sure_windows)});
    }
    return found;
}

} // namespace tp
