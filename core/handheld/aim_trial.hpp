// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aiming/aim.hpp"
#include "core/aiming/held_camera.hpp"
#include "core/handheld/guided_hand.hpp"
#include "core/handheld/hand_tremor.hpp"
#include "core/handheld/held_pose.hpp"
#include "core/handheld/seen_people.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace tp {

/// What the hand hears.
enum class AimGuidance { words_and_tone, words, tone, none };
inline constexpr std::array<AimGuidance, 4> all_guidance{AimGuidance::words_and_tone, AimGuidance::words,
                                                         AimGuidance::tone, AimGuidance::none};
/// "words and tone", "words", "tone", "none"
std::string_view name_of(AimGuidance guidance);

/// One person who wants one picture.
struct AimTrial {
    Aim aim = Aim::middle;
    AimGuidance guidance = AimGuidance::words_and_tone;
    HeldCamera camera;
    std::uint64_t seed = 1; ///< another one is another person at another start
    double longest_s = 30.0;
    double frames_per_s = 10.0;
    double latency_s = 0.1; ///< from a frame to what is begun for it (assumed)
    bool gravity = true;    ///< the camera knows which way is down, as tablets and telephones do
    CameraOptics optics;
    DetectorManner detector;
    HandManner hand;
    TremorManner tremor;
};

struct AimTrialResult {
    std::optional<double> framed_s; ///< when the shutter took a picture that is as it was wished
    int missed_pictures = 0;        ///< pictures before it that were not
    int sentences = 0;              ///< until then
    std::vector<HeldPose> way;      ///< the camera at every frame
};

/// The people of a trial and how the camera is held at its start, by its seed alone: all ways of guidance begin alike.
struct AimStart {
    std::vector<ScenePlace> people;
    HeldPose pose;
};
AimStart start_of(const AimTrial& trial);

/// In virtual time, by geometry alone: no photograph is looked at.
AimTrialResult run_trial(const AimTrial& trial);

/// A picture from there would be as the aim asks, measured without a detector's errors, with a tenth of slack.
bool acceptable(const std::vector<ScenePlace>& people, const HeldPose& pose, const CameraOptics& optics,
                Aim aim);

/// What became of many trials of one kind.
struct AimShares {
    std::size_t trials = 0;
    double within_5_s = 0.0; ///< share, 0 … 1
    double within_10_s = 0.0;
    double within_15_s = 0.0;
    double within_20_s = 0.0;
    std::optional<double> median_s; ///< of all trials; nothing where fewer than half were framed
    double missed_pictures = 0.0;   ///< a trial, mean
    double sentences = 0.0;         ///< a trial, mean
};
AimShares shares_of(const std::vector<AimTrialResult>& results);

} // namespace tp
