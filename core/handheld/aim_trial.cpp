// SPDX-License-Identifier: Apache-2.0
#include "core/handheld/aim_trial.hpp"

#include "core/aiming/aiming.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tp {

namespace {

constexpr double step_s = 0.01;          ///< s, the hand's step
constexpr double slack = 1.1;            ///< what is nearly as asked is acceptable
constexpr double nearest_person_m = 0.6; ///< how far away people stand at the start (assumed)
constexpr double farthest_person_m = 3.0;
constexpr int group = 3;           ///< people, where everybody is wanted
constexpr double shoulder_m = 0.5; ///< between their heads

AimTrialResult run_from(const AimTrial& trial, const AimStart& start) {
    AimTrialResult result;
    const bool words = trial.guidance == AimGuidance::words || trial.guidance == AimGuidance::words_and_tone;
    const bool tone = trial.guidance == AimGuidance::tone || trial.guidance == AimGuidance::words_and_tone;
    Chance detection(trial.seed + 0x9e3779b97f4a7c15);
    HandTremor tremor(trial.tremor, trial.seed + 0x3c6ef372fe94f82a);
    GuidedHand hand(trial.hand, start.pose, trial.camera.front, trial.seed + 0xdaa66d2c7ddf743f);
    Aiming aiming(trial.aim, trial.camera);
    aiming.with_tone(tone);
    aiming.expect(static_cast<int>(start.people.size()));
    HeldPose before = tremor.added_to(hand.pose());
    double sentence_ends = std::numeric_limits<double>::infinity();
    const int steps = static_cast<int>(std::lround(trial.longest_s / step_s));
    const int frame_every = std::max(1, static_cast<int>(std::lround(1.0 / (trial.frames_per_s * step_s))));
    for (int i = 0; i < steps; ++i) {
        const double now = i * step_s;
        tremor.step(step_s);
        hand.step(step_s);
        const HeldPose pose = tremor.added_to(hand.pose());
        if (now >= sentence_ends) {
            aiming.sentence_ended(now);
            sentence_ends = std::numeric_limits<double>::infinity();
        }
        if (i % frame_every == 0) {
            AimFrame frame = seen_people(start.people, pose, trial.optics, trial.detector, detection);
            if (trial.camera.mirrored)
                frame = mirrored(std::move(frame));
            frame.time_s = now;
            if (trial.gravity)
                frame.elevation_deg = pose.tilt_deg;
            frame.motion = picture_motion(before, pose, step_s, trial.optics);
            const AimAnswer answer = aiming.see(frame);
            result.way.push_back(pose);
            if (answer.say && words) {
                ++result.sentences;
                sentence_ends = hand.hear_words(*answer.say, now + trial.latency_s);
            } else if (answer.say) {
                aiming.sentence_ended(now);
            }
            if (tone)
                hand.hear_tone(answer.tone, now + trial.latency_s);
            if (answer.take) {
                if (acceptable(start.people, pose, trial.optics, trial.aim)) {
                    result.framed_s = now;
                    return result;
                }
                ++result.missed_pictures;
                aiming.arm();
            }
        }
        before = pose;
    }
    return result;
}

} // namespace

std::string_view name_of(AimGuidance guidance) {
    switch (guidance) {
    case AimGuidance::words_and_tone:
        return "words and tone";
    case AimGuidance::words:
        return "words";
    case AimGuidance::tone:
        return "tone";
    case AimGuidance::none:
        break;
    }
    return "none";
}

AimStart start_of(const AimTrial& trial) {
    Chance chance(trial.seed);
    AimStart start;
    const double ahead = chance.between(nearest_person_m, farthest_person_m);
    const int people = trial.aim == Aim::everybody ? group : 1;
    for (int i = 0; i < people; ++i)
        start.people.push_back({shoulder_m * (i - 0.5 * (people - 1)),
                                people > 1 ? 0.08 * chance.normal() : 0.0,
                                people > 1 ? std::max(ahead, 1.5) : ahead});
    start.pose.pan_deg = trial.hand.aim_pan_deg * chance.normal();
    start.pose.tilt_deg = trial.hand.aim_tilt_deg * chance.normal();
    start.pose.roll_deg = trial.hand.aim_roll_deg * chance.normal();
    return start;
}

AimTrialResult run_trial(const AimTrial& trial) { return run_from(trial, start_of(trial)); }

bool acceptable(const std::vector<ScenePlace>& people, const HeldPose& pose, const CameraOptics& optics,
                Aim aim) {
    Chance none(0);
    AimFrame frame = seen_people(people, pose, optics, DetectorManner::faultless(), none);
    FaceTracks tracks;
    for (int i = 0; i < sightings_to_count; ++i)
        tracks.see(frame);
    if (aim == Aim::everybody && tracks.faces().size() != people.size())
        return false;
    Framer framer(aim);
    const auto framing = framer.frame(tracks.faces(), optics.aspect);
    if (!framing)
        return false;
    const Rect& box = framing->box;
    const bool whole = box.min.x >= 0.0 && box.min.y >= 0.0 && box.max.x <= 1.0 && box.max.y <= 1.0;
    return whole && std::abs(framing->off.x) <= slack * framing->tolerance.x &&
           std::abs(framing->off.y) <= slack * framing->tolerance.y && std::abs(framing->size_off) <= slack &&
           std::abs(framing->tilt_deg.value_or(0.0)) <= slack * level_deg;
}

AimShares shares_of(const std::vector<AimTrialResult>& results) {
    AimShares shares;
    shares.trials = results.size();
    if (results.empty())
        return shares;
    std::vector<double> times;
    for (const AimTrialResult& result : results) {
        shares.missed_pictures += result.missed_pictures;
        shares.sentences += result.sentences;
        if (result.framed_s)
            times.push_back(*result.framed_s);
    }
    const auto all = static_cast<double>(results.size());
    shares.missed_pictures /= all;
    shares.sentences /= all;
    std::sort(times.begin(), times.end());
    const auto within = [&times, all](double s) {
        return static_cast<double>(std::upper_bound(times.begin(), times.end(), s) - times.begin()) / all;
    };
    shares.within_5_s = within(5.0);
    shares.within_10_s = within(10.0);
    shares.within_15_s = within(15.0);
    shares.within_20_s = within(20.0);
    const std::size_t middle = (results.size() - 1) / 2;
    if (middle < times.size())
        shares.median_s = times[middle];
    return shares;
}

} // namespace tp
