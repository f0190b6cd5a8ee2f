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

/// From one pose; what all pixels of a row share is computed once.
class Gaze {
public:
    Gaze(double photo_aspect, const PhotoWall& wall, const HeldPose& pose, const CameraOptics& optics)
        : wall_(wall), height_m_(wall.width_m / photo_aspect), far_m_(wall.ahead_m - pose.forward_m),
          focal_(optics.focal(pose.zoom)), focal_down_(focal_ * optics.aspect), roll_(pose.roll_deg),
          tilt_(pose.tilt_deg), pan_(pose.pan_deg) {}

    /// The way of `projected`, backwards: roll, tilt, pan.
    Vec2 on_photo(Vec2 in_frame) const {
        const double seen_x = (in_frame.x - 0.5) / focal_;
        const double seen_y = (0.5 - in_frame.y) / focal_down_;
        const double x = seen_x * roll_.cos + seen_y * roll_.sin;
        const double y = -seen_x * roll_.sin + seen_y * roll_.cos;
        const double up = y * tilt_.cos + tilt_.sin;
        const double level = -y * tilt_.sin + tilt_.cos;
        const double right = x * pan_.cos + level * pan_.sin;
        const double ahead = -x * pan_.sin + level * pan_.cos;
        if (!(ahead > 1e-6) || !(far_m_ > 0.0))
            return Vec2(std::numeric_limits<double>::quiet_NaN());
        return {wall_.aim.x + right / ahead * far_m_ / wall_.width_m,
                wall_.aim.y - up / ahead * far_m_ / height_m_};
    }

private:
    struct Turn {
        explicit Turn(double deg)
            : sin(std::sin(deg * std::numbers::pi / 180.0)), cos(std::cos(deg * std::numbers::pi / 180.0)) {}
        double sin, cos;
    };

    PhotoWall wall_;
    double height_m_, far_m_;
    double focal_, focal_down_;
    Turn roll_, tilt_, pan_;
};

/// Each row from the pose of its own time.
cv::Mat rows_of(const cv::Mat& photo, const PhotoWall& wall, const HeldPose& pose, const HeldPose& rate,
                const CameraOptics& optics, const FrameTaking& taking) {
    const double photo_aspect = static_cast<double>(photo.cols) / photo.rows;
    cv::Mat places(taking.size, CV_32FC2);
    for (int y = 0; y < taking.size.height; ++y) {
        const double down = (y + 0.5) / taking.size.height;
        const Gaze now(photo_aspect, wall, later(pose, rate, (down - 0.5) * taking.readout_s), optics);
        auto* row = places.ptr<cv::Vec2f>(y);
        for (int x = 0; x < taking.size.width; ++x) {
            const Vec2 at = now.on_photo({(x + 0.5) / taking.size.width, down});
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
    return Gaze(photo_aspect, wall, pose, optics).on_photo(in_frame);
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
