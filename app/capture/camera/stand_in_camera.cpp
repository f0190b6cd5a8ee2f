// SPDX-License-Identifier: Apache-2.0
#include "app/capture/camera/stand_in_camera.hpp"

#include "app/capture/camera/system_camera.hpp"
#include "app/capture/frames/folder_camera.hpp"
#include "app/capture/frames/paced_camera.hpp"
#include "app/capture/frames/video_camera.hpp"
#include "faces/decode/picture.hpp"

#include <algorithm>
#include <array>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace tp {

namespace {

constexpr double folder_frames_per_s = 15.0;
constexpr double narrow_photo_m =
    0.75; ///< width of an upright one; a portrait's face is then about 0.25 m wide
constexpr double beside_deg = -14.0;
constexpr double above_deg = 6.0;
constexpr double most_turned_deg = 60.0;
constexpr double nearest_m = 0.4;  ///< to the photograph
constexpr double farthest_m = 3.0; ///< back from where it is held at first

HeldPose first_pose() {
    HeldPose pose;
    pose.pan_deg = beside_deg;
    pose.tilt_deg = above_deg;
    return pose;
}

} // namespace

/// Where a person at a desk holds the camera, from the page's thread to the one that frames are made on.
class StandInCamera::Hand {
public:
    HeldPose pose() const {
        const std::lock_guard lock(mutex_);
        return pose_;
    }
    void move_by(const HeldPose& way) {
        const auto turned = [](double deg) { return std::clamp(deg, -most_turned_deg, most_turned_deg); };
        const std::lock_guard lock(mutex_);
        pose_.pan_deg = turned(pose_.pan_deg + way.pan_deg);
        pose_.tilt_deg = turned(pose_.tilt_deg + way.tilt_deg);
        pose_.roll_deg = turned(pose_.roll_deg + way.roll_deg);
        pose_.forward_m =
            std::clamp(pose_.forward_m + way.forward_m, -farthest_m, PhotoWall{}.ahead_m - nearest_m);
    }

private:
    mutable std::mutex mutex_;
    HeldPose pose_ = first_pose();
};

/// What is looked at is read by whoever asks for frames.
class StandInCamera::Frames final : public FrameSource {
public:
    Frames(Of of, std::filesystem::path path, std::shared_ptr<const Hand> hand)
        : of_(of), path_(std::move(path)), hand_(std::move(hand)) {}

    Result<std::optional<CameraFrame>> next() override {
        if (!simulated_ && !given_)
            if (std::string why = begin(); !why.empty())
                return Error{std::move(why)};
        if (!simulated_)
            return given_->next();
        simulated_->move_to(hand_->pose());
        return simulated_->next();
    }
    HeldCamera held() const override { return {}; }

private:
    std::string begin() {
        if (of_ == Of::folder) {
            Result<FolderCamera> folder = FolderCamera::open(path_, folder_frames_per_s);
            if (!folder)
                return folder.error();
            given_ = std::make_unique<FolderCamera>(std::move(folder).value());
            return {};
        }
        if (of_ == Of::video) {
            Result<VideoCamera> video = VideoCamera::open(path_);
            if (!video)
                return video.error();
            given_ = std::make_unique<VideoCamera>(std::move(video).value());
            return {};
        }
        const Result<cv::Mat> photo = read_picture(path_);
        if (photo)
            simulated_.emplace(*photo, hold_before(*photo));
        return photo.error();
    }

    Of of_;
    std::filesystem::path path_;
    std::shared_ptr<const Hand> hand_;
    std::optional<SimulatedCamera> simulated_;
    std::unique_ptr<FrameSource> given_; ///< a folder's or a video's
};

SimulatedHold hold_before(const cv::Mat& photo) {
    SimulatedHold hold;
    hold.wall.width_m = narrow_photo_m * std::max(1.0, static_cast<double>(photo.cols) / photo.rows);
    hold.start = first_pose();
    return hold;
}

StandInCamera::StandInCamera(Of of, std::filesystem::path path) : of_(of), path_(std::move(path)) {}

StandInCamera::~StandInCamera() = default;

Result<std::unique_ptr<FrameSource>> StandInCamera::open(CameraSide) {
    hand_ = std::make_shared<Hand>();
    return std::unique_ptr<FrameSource>(
        std::make_unique<PacedCamera>(std::make_unique<Frames>(of_, path_, hand_)));
}

void StandInCamera::close() { hand_.reset(); }

bool StandInCamera::move_by(const HeldPose& way) {
    if (!moved_by_keys() || !hand_)
        return false;
    hand_->move_by(way);
    return true;
}

std::unique_ptr<Camera> camera_named(const std::string& wish) {
    constexpr std::array<std::pair<std::string_view, StandInCamera::Of>, 3> desks{
        {{"simulated:", StandInCamera::Of::photo},
         {"folder:", StandInCamera::Of::folder},
         {"video:", StandInCamera::Of::video}}};
    if (wish.empty())
        return std::make_unique<SystemCamera>();
    for (const auto& [word, of] : desks)
        if (wish.starts_with(word) && wish.size() > word.size())
            return std::make_unique<StandInCamera>(of, wish.substr(word.size()));
    return nullptr;
}

} // namespace tp
