// SPDX-License-Identifier: Apache-2.0
#include "app/capture/frames/simulated_camera.hpp"

#include "faces/decode/picture.hpp"

#include <opencv2/core.hpp>

#include <utility>

namespace tp {

namespace {

HeldPose rate_between(const HeldPose& before, const HeldPose& after, double dt) {
    HeldPose rate;
    rate.pan_deg = (after.pan_deg - before.pan_deg) / dt;
    rate.tilt_deg = (after.tilt_deg - before.tilt_deg) / dt;
    rate.roll_deg = (after.roll_deg - before.roll_deg) / dt;
    rate.forward_m = (after.forward_m - before.forward_m) / dt;
    return rate;
}

} // namespace

Result<SimulatedCamera> SimulatedCamera::open(const std::filesystem::path& photo, const SimulatedHold& hold) {
    Result<cv::Mat> pixels = read_picture(photo);
    if (!pixels)
        return Error{pixels.error()};
    return SimulatedCamera(std::move(pixels).value(), hold);
}

SimulatedCamera::SimulatedCamera(cv::Mat photo, const SimulatedHold& hold)
    : photo_(std::move(photo)), hold_(hold), tremor_(hold.tremor, hold.seed), wished_(hold.start),
      last_(tremor_.added_to(hold.start)) {
    hold_.optics.aspect = static_cast<double>(hold_.taking.size.width) / hold_.taking.size.height;
}

Result<std::optional<CameraFrame>> SimulatedCamera::next() {
    const double dt = 1.0 / hold_.frames_per_s;
    tremor_.step(dt);
    const HeldPose pose = tremor_.added_to(wished_);
    CameraFrame frame;
    frame.pixels =
        view_of(photo_, hold_.wall, pose, rate_between(last_, pose, dt), hold_.optics, hold_.taking);
    if (hold_.held.mirrored)
        cv::flip(frame.pixels, frame.pixels, 1);
    frame.time_s = static_cast<double>(taken_++) * dt;
    frame.elevation_deg = pose.tilt_deg;
    frame.roll_deg = pose.roll_deg;
    last_ = pose;
    return std::optional(std::move(frame));
}

} // namespace tp
