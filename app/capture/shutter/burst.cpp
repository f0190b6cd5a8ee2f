// SPDX-License-Identifier: Apache-2.0
#include "app/capture/shutter/burst.hpp"

#include "app/capture/seeing/frame_sharpness.hpp"
#include "faces/base/detection.hpp"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <utility>

namespace tp {

namespace {

constexpr int small_px = 320;        ///< longer side of what the detector sees
constexpr int smallest_side_px = 16; ///< of a picture that can hold a face
constexpr double sure_score = 0.5;
constexpr double cut_share = 0.05; ///< of a face's box beyond the edge: the edge cuts it
constexpr double eyes_from_px = 80.0;
constexpr std::size_t most_eyes = 6; ///< faces whose eyes are looked at, the largest
constexpr Rect middle{{0.25, 0.25}, {0.75, 0.75}};

cv::Mat shrunk(const cv::Mat& picture) {
    const double scale = static_cast<double>(small_px) / std::max(picture.cols, picture.rows);
    if (scale >= 1.0)
        return picture;
    cv::Mat small;
    cv::resize(picture, small, {}, scale, scale, cv::INTER_AREA);
    return small;
}

Detection scaled(const Detection& face, Vec2 by) {
    return {{face.box.min * by, face.box.max * by}, face.right_eye * by, face.left_eye * by, face.score};
}

bool is_whole(const Rect& box, Vec2 size) {
    const Vec2 beyond = glm::max(-box.min, box.max - size);
    return beyond.x <= cut_share * box.width() && beyond.y <= cut_share * box.height();
}

} // namespace

BurstLook burst_look(const cv::Mat& picture, QuickFaces& faces) {
    BurstLook look;
    if (picture.empty() || picture.type() != CV_8UC3)
        return look;
    const cv::Mat small = shrunk(picture);
    std::vector<Detection> found;
    if (std::min(small.cols, small.rows) >= smallest_side_px)
        found = faces.find(small);
    std::erase_if(found, [](const Detection& face) { return face.score < sure_score; });
    const Vec2 size(picture.cols, picture.rows);
    const Vec2 back(static_cast<double>(picture.cols) / small.cols,
                    static_cast<double>(picture.rows) / small.rows);
    for (std::size_t i = 0; i < found.size(); ++i) {
        const Detection face = scaled(found[i], back);
        if (is_whole(face.box, size))
            ++look.faces;
        if (const auto fine = fineness(picture, {face.box.min / size, face.box.max / size}))
            look.fineness = std::min(look.fineness.value_or(*fine), *fine);
        if (i < most_eyes && face.size() >= eyes_from_px && faces.eyes_shut(picture, face))
            ++look.shut;
    }
    if (!look.fineness)
        look.fineness = fineness(picture, middle);
    return look;
}

Burst::Burst(std::vector<CameraFrame> frames, HeldCamera held, double shutter_s)
    : frames_(std::move(frames)), held_(held) {
    std::stable_sort(frames_.begin(), frames_.end(),
                     [](const CameraFrame& a, const CameraFrame& b) { return a.time_s < b.time_s; });
    const auto away = [shutter_s](const CameraFrame& frame) { return std::abs(frame.time_s - shutter_s); };
    while (frames_.size() > most_frames)
        frames_.erase(away(frames_.front()) > away(frames_.back()) ? frames_.begin() : frames_.end() - 1);
    for (std::size_t i = 1; i < frames_.size(); ++i)
        if (away(frames_[i]) < away(frames_[wished_]))
            wished_ = i;
}

cv::Mat Burst::picture(std::size_t number) const {
    if (!coded_.empty())
        return pixels_of(coded_[number]);
    const cv::Mat& pixels = frames_[number].pixels;
    if (!held_.mirrored || pixels.empty())
        return pixels;
    cv::Mat turned_back;
    cv::flip(pixels, turned_back, 1);
    return turned_back;
}

Result<CodedPicture> Burst::coded(std::size_t number) const {
    return coded_.empty() ? coded_picture(picture(number)) : coded_[number];
}

Burst Burst::packed() const {
    Burst packed = *this;
    for (std::size_t i = 0; i < size(); ++i) {
        Result<CodedPicture> coded = this->coded(i);
        if (!coded)
            return *this;
        packed.coded_.push_back(std::move(coded).value());
        packed.frames_[i].pixels = cv::Mat();
    }
    return packed;
}

BurstOrder Burst::choose(QuickFaces& faces) const {
    std::vector<BurstLook> looks;
    for (const CameraFrame& frame : frames_) {
        BurstLook look;
        try {
            look = burst_look(frame.pixels, faces);
        } catch (const std::exception&) { // out of memory, mostly
        }
        looks.push_back(look);
    }
    return order_of(looks, wished_);
}

} // namespace tp
