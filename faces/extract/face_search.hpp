// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/base/landmarks.hpp"
#include "faces/contours/second_opinion.hpp"
#include "faces/detect/detector.hpp"

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace tp {

/// Of a face for which the picture had to be turned: three more looks would make three times the false
/// alarms. Nine in ten faces from 40 px on reach 0.98 (plausibility.cpp).
inline constexpr double least_confidence_turned = 0.95;

/// A detected face and its points.
struct LocatedFace {
    Detection detection;
    Landmarks points;
    std::optional<Landmarks> mesh = {}; ///< the face mesh's, where it was asked

    Vec2 centre() const;
};

/// The largest confidence; 0 where there is no face.
double surest(const std::vector<LocatedFace>& located);

/// Milliseconds that a search took.
struct SearchTimes {
    double detect = 0.0, landmarks = 0.0;
};

/// Somebody asked the search to stop.
struct SearchStopped {};

/// Finds the faces of a picture: places by a detector, which the landmarks confirm. Throws SearchStopped
/// where it is asked to stop, and what OpenCV throws.
class FaceSearch {
public:
    /// With `second`, the mesh says of what the landmarks refuse whether it is a face all the same, and where
    /// nothing is left another detector looks.
    FaceSearch(std::unique_ptr<Detector> detector, LandmarkModel& landmarks, SecondOpinion* second)
        : detector_(std::move(detector)), landmarks_(landmarks), second_(second) {}

    /// The faces of an upright picture, the largest first. Looks thoroughly, where `most` allows it, only if
    /// a usual look finds no face.
    std::vector<LocatedFace> upright(const cv::Mat& picture, Effort most, SearchTimes& times,
                                     const std::stop_token& stop);
    /// Those of a picture that was turned, by a usual look of our detector, which are sure enough to believe
    /// that it had to be.
    std::vector<LocatedFace> turned(const cv::Mat& picture, SearchTimes& times, const std::stop_token& stop);

private:
    /// Whose word is enough for a place to be a face.
    enum class By { landmarks, landmarks_and_mesh };

    std::optional<LocatedFace> by_landmarks(const cv::Mat& picture, const Detection& detection);
    std::optional<LocatedFace> by_mesh(const cv::Mat& picture, const Detection& detection);
    std::vector<LocatedFace> confirmed(const cv::Mat& picture, std::vector<Detection> detections, By judges,
                                       const std::stop_token& stop);

    std::unique_ptr<Detector> detector_;
    LandmarkModel& landmarks_;
    SecondOpinion* second_;
};

} // namespace tp
