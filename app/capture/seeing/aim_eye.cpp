// SPDX-License-Identifier: Apache-2.0
#include "app/capture/seeing/aim_eye.hpp"

#include "app/capture/seeing/frame_light.hpp"
#include "faces/extract/quick_faces.hpp"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <utility>
#include <vector>

namespace tp {

namespace {

constexpr int smallest_side_px = 16;                        ///< of a small frame that can hold a face
constexpr Rect middle_of_frame{{0.25, 0.25}, {0.75, 0.75}}; ///< whose sharpness is told where nobody is seen

cv::Size shrunk_size(const cv::Size& size, int longer) {
    const double scale = static_cast<double>(longer) / std::max(size.width, size.height);
    const auto side = [scale](int px) { return std::max(1, static_cast<int>(std::lround(scale * px))); };
    return {side(size.width), side(size.height)};
}

/// Smaller only. Always a copy: `small` is written again, and a frame belongs to others too.
void shrink(const cv::Mat& picture, int longer, cv::Mat& small) {
    if (std::max(picture.cols, picture.rows) <= longer)
        picture.copyTo(small);
    else
        cv::resize(picture, small, shrunk_size(picture.size(), longer), 0.0, 0.0, cv::INTER_AREA);
}

Detection scaled(const Detection& face, Vec2 by) {
    return {{face.box.min * by, face.box.max * by}, face.right_eye * by, face.left_eye * by, face.score};
}

} // namespace

struct AimEye::Parts {
    explicit Parts(HeldCamera camera) : held(camera) {}

    HeldCamera held;
    FaceName name_of;
    QuickFaces faces;
    FrameMotion motion;
    FrameSharpness sharpness;
    cv::Mat small, smallest, grey;

    Vec2 shut_at{0.0}; ///< the face whose eyes were looked at last
    double eyes_looked_s = -1.0;
    bool shut = false;
    double name_asked_s = -1.0;
    std::size_t asked = 0; ///< how many names were asked for

    /// In the whole frame, the largest first.
    std::vector<Detection> faces_of(const cv::Mat& pixels) {
        std::vector<Detection> found = faces.find(small);
        const Vec2 back(static_cast<double>(pixels.cols) / small.cols,
                        static_cast<double>(pixels.rows) / small.rows);
        for (Detection& face : found)
            face = scaled(face, back);
        return found;
    }

    /// Of the largest face, from time to time; between, what was seen then.
    bool eyes_shut(const CameraFrame& frame, const Detection& face) {
        const double since = frame.time_s - eyes_looked_s;
        const bool same = length(shut_at - face.box.centre()) < 0.5 * face.size();
        if (same && since >= 0.0 && since < eyes_every_s)
            return shut;
        eyes_looked_s = frame.time_s;
        shut_at = face.box.centre();
        shut = faces.eyes_shut(frame.pixels, face);
        return shut;
    }

    void ask_name(const CameraFrame& frame, const std::vector<Detection>& found, AimFrame& seen) {
        const double since = frame.time_s - name_asked_s;
        if (!name_of || found.empty() || (name_asked_s >= 0.0 && since >= 0.0 && since < name_every_s))
            return;
        name_asked_s = frame.time_s;
        const std::size_t whose = asked++ % found.size();
        if (const auto face = faces.face_at(frame.pixels, found[whose]))
            seen.faces[whose].name = name_of(frame.pixels, *face);
    }

    void look(const CameraFrame& frame, AimFrame& seen) {
        shrink(frame.pixels, small_px, small);
        shrink(small, smallest_px, smallest);
        cv::cvtColor(smallest, grey, cv::COLOR_BGR2GRAY);
        seen.motion = motion.see(grey, frame.time_s);
        if (std::min(small.cols, small.rows) < smallest_side_px)
            return;
        const std::vector<Detection> found = faces_of(frame.pixels);
        const Vec2 size(frame.pixels.cols, frame.pixels.rows);
        std::vector<Rect> boxes;
        for (const Detection& face : found) {
            AimFace here;
            here.box = {face.box.min / size, face.box.max / size};
            here.confidence = face.score;
            here.eyes = {{face.right_eye / size, face.left_eye / size}};
            here.brightness = brightness_of(grey, here.box);
            boxes.push_back(here.box);
            seen.faces.push_back(std::move(here));
        }
        seen.surroundings = brightness_beside(grey, boxes);
        seen.sharpness = sharpness.see(
            fineness(frame.pixels, boxes.empty() ? middle_of_frame : boxes.front()), frame.time_s);
        if (!found.empty() && found.front().size() >= eyes_from_px)
            seen.faces.front().eyes_shut = eyes_shut(frame, found.front());
        ask_name(frame, found, seen);
    }
};

AimEye::AimEye(HeldCamera held) : parts_(std::make_unique<Parts>(held)) {}
AimEye::AimEye(AimEye&&) noexcept = default;
AimEye& AimEye::operator=(AimEye&&) noexcept = default;
AimEye::~AimEye() = default;

void AimEye::hold(HeldCamera held) { parts_->held = held; }
void AimEye::name_by(FaceName name_of) { parts_->name_of = std::move(name_of); }

AimFrame AimEye::see(const CameraFrame& frame) {
    AimFrame seen;
    seen.time_s = frame.time_s;
    seen.elevation_deg = frame.elevation_deg;
    // A camera turned clockwise sees the world turned the other way; a mirror turns it back.
    if (frame.roll_deg)
        seen.horizon_deg = parts_->held.mirrored ? *frame.roll_deg : -*frame.roll_deg;
    if (frame.pixels.empty() || frame.pixels.type() != CV_8UC3)
        return seen;
    seen.aspect = static_cast<double>(frame.pixels.cols) / frame.pixels.rows;
    try {
        parts_->look(frame, seen);
    } catch (const std::exception&) { // out of memory, mostly: the next frame may fare better
        seen.faces.clear();
    }
    return seen;
}

} // namespace tp
