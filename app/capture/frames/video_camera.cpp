// SPDX-License-Identifier: Apache-2.0
#include "app/capture/frames/video_camera.hpp"

#include "audio/video/film_of_video.hpp"
#include "core/files/file_words.hpp"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <string>

namespace tp {

namespace {

constexpr double shortest_wait_s = 0.06; ///< between two frames: more than one aims with cost time only

cv::Mat upright(FilmPicture& picture) {
    const cv::Mat planes(picture.height * 3 / 2, picture.width, CV_8UC1, picture.planes.data());
    cv::Mat pixels;
    cv::cvtColor(planes, pixels, cv::COLOR_YUV2BGR_I420);
    if (picture.turn_deg == 90)
        cv::rotate(pixels, pixels, cv::ROTATE_90_CLOCKWISE);
    else if (picture.turn_deg == 180)
        cv::rotate(pixels, pixels, cv::ROTATE_180);
    else if (picture.turn_deg == 270)
        cv::rotate(pixels, pixels, cv::ROTATE_90_COUNTERCLOCKWISE);
    return pixels;
}

} // namespace

Result<VideoCamera> VideoCamera::open(const std::filesystem::path& file, HeldCamera held) {
    VideoCamera camera(file, held);
    if (std::string why = camera.begin(); !why.empty())
        return Error{std::move(why)};
    return camera;
}

std::string VideoCamera::begin() {
    film_.reset(); // whoever decodes it is free for the next round
    auto film = film_of_video(file_);
    if (!film)
        return "The video " + quoted(file_) + " cannot be played: " + film.error();
    film_ = std::move(film).value();
    last_s_.reset();
    return {};
}

Result<std::optional<CameraFrame>> VideoCamera::next() {
    auto picture = film_ ? film_->next(last_s_ ? *last_s_ + shortest_wait_s : 0.0) : std::nullopt;
    if (!picture) {
        round_s_ += last_s_.value_or(0.0) + shortest_wait_s;
        if (std::string why = begin(); !why.empty())
            return Error{std::move(why)};
        picture = film_->next(0.0);
        if (!picture) // nothing is left of it
            return std::optional<CameraFrame>();
    }
    last_s_ = std::max(0.0, picture->time_s);
    CameraFrame frame;
    frame.pixels = upright(*picture);
    frame.time_s = round_s_ + *last_s_;
    return std::optional(std::move(frame));
}

} // namespace tp
