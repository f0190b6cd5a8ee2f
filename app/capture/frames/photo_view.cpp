// SPDX-License-Identifier: Apache-2.0
#include "app/capture/frames/photo_view.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace tp {

namespace {

constexpr int exposures = 3;    ///< views that a moving frame is the mean of
constexpr double seen_px = 0.5; ///< a smear below that is none

HeldPose later(HeldPose pose, const HeldPose& rate, double dt) {
    pose.pan_deg += rate.pan_deg * dt;
    pose.tilt_deg += rate.tilt_deg * dt;
    pose.roll_deg += rate.roll_deg * dt;
    pose.forward_m += rate.forward_m * dt;
    return pose;
}

/// Each row from the pose of its own time.
cv::Mat rows_of(const cv::Mat& photo, const PhotoWall& wall, const HeldPose& pose, const HeldPose& rate,
                const CameraOptics& optics, const FrameTaking& taking) {
    const double photo_aspect = static_cast<double>(photo.cols) / photo.rows;
    cv::Mat places(taking.size, CV_32FC2);
    for (int y = 0; y < taking.size.height; ++y) {
        const double down = (y + 0.5) / taking.size.height;
        const HeldPose now = later(pose, rate, (down - 0.5) * taking.readout_s);
        auto* row = places.ptr<cv::Vec2f>(y);
        for (int x = 0; x < taking.size.width; ++x) {
            const Vec2 at =
                place_on_photo({(x + 0.5) / taking.size.width, down}, photo_aspect, wall, now, optics);
            const Vec2 px =
                is_finite(at) ? Vec2(at.x * photo.cols - 0.5, at.y * photo.rows - 0.5) : Vec2(-1e4);
            row[x] = {static_cast<float>(std::clamp(px.x, -1e4, 1e6)),
                      static_cast<float>(std::clamp(px.y, -1e4, 1e6))};
        }
    }
    cv::Mat frame;
    cv::remap(photo, frame, places, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_CONSTANT,
              cv::Scalar(128, 128, 128));
    return frame;
}

} // namespace

Vec2 place_on_photo(Vec2 in_frame, double photo_aspect, const PhotoWall& wall, const HeldPose& pose,
                    const CameraOptics& optics) {
    const double focal = optics.focal(pose.zoom);
    const double seen_x = (in_frame.x - 0.5) / focal;
    const double seen_y = (0.5 - in_frame.y) / (focal * optics.aspect);
    // The way of `projected`, backwards: roll, tilt, pan.
    const double roll = pose.roll_deg * std::numbers::pi / 180.0;
    const double tilt = pose.tilt_deg * std::numbers::pi / 180.0;
    const double pan = pose.pan_deg * std::numbers::pi / 180.0;
    const double x = seen_x * std::cos(roll) + seen_y * std::sin(roll);
    const double y = -seen_x * std::sin(roll) + seen_y * std::cos(roll);
    const double up = y * std::cos(tilt) + std::sin(tilt);
    const double level = -y * std::sin(tilt) + std::cos(tilt);
    const double right = x * std::cos(pan) + level * std::sin(pan);
    const double ahead = -x * std::sin(pan) + level * std::cos(pan);
    const double far = wall.ahead_m - pose.forward_m;
    if (!(ahead > 1e-6) || !(far > 0.0))
        return Vec2(std::numeric_limits<double>::quiet_NaN());
    const double height_m = wall.width_m / photo_aspect;
    return {wall.aim.x + right / ahead * far / wall.width_m, wall.aim.y - up / ahead * far / height_m};
}

cv::Mat view_of(const cv::Mat& photo, const PhotoWall& wall, const HeldPose& pose, const HeldPose& rate,
                const CameraOptics& optics, const FrameTaking& taking) {
    const double smear_px =
        picture_motion({}, rate, 1.0, optics) * pose.zoom * taking.exposed_s * taking.size.width;
    cv::Mat frame;
    if (smear_px < seen_px) {
        frame = rows_of(photo, wall, pose, rate, optics, taking);
    } else {
        cv::Mat sum = cv::Mat::zeros(taking.size, CV_32FC3);
        for (int i = 0; i < exposures; ++i) {
            const double at = ((i + 0.5) / exposures - 0.5) * taking.exposed_s;
            cv::accumulate(rows_of(photo, wall, later(pose, rate, at), rate, optics, taking), sum);
        }
        sum.convertTo(frame, CV_8UC3, 1.0 / exposures);
    }
    if (taking.exposure != 1.0)
        frame.convertTo(frame, CV_8UC3, taking.exposure);
    return frame;
}

} // namespace tp
