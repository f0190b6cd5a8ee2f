// SPDX-License-Identifier: Apache-2.0
#include "core/handheld/guided_hand.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tp {

namespace {

constexpr double shortest_move_s = 0.25;
constexpr double look_deg = 75.0;  ///< how far one turns to look for somebody
constexpr double heard_side = 0.3; ///< of a tone: so much to one ear is heard as a side

/// Share of a smooth reach that is done at a share of its time: least jerk (Flash, Hogan 1985).
double reached(double time) {
    const double t = std::clamp(time, 0.0, 1.0);
    return t * t * t * (10.0 - 15.0 * t + 6.0 * t * t);
}

double measure(AimStep step, double little, double some, double much) {
    return step == AimStep::little ? little : step == AimStep::some ? some : much;
}

} // namespace

int words_in(const AimInstruction& instruction) {
    if (is_look(instruction.advice))
        return 3;
    if (is_move(instruction.advice))
        return instruction.step == AimStep::little ? 3 : 2;
    switch (instruction.advice) {
    case Advice::ready:
    case Advice::keep_still:
        return 2;
    case Advice::more_light:
    case Advice::light_behind_them:
    case Advice::eyes_shut:
        return 5;
    default:
        return 3;
    }
}

GuidedHand::GuidedHand(const HandManner& manner, const HeldPose& start, bool front, std::uint64_t seed)
    : manner_(manner), pose_(start), side_(front ? -1.0 : 1.0), chance_(seed),
      reaction_s_(chance_.between(manner.fastest_reaction_s, manner.slowest_reaction_s)),
      aims_at_s_(manner.re_aims_s * chance_.factor(manner.spread)) {}

double& GuidedHand::value(Axis axis) {
    switch (axis) {
    case Axis::pan:
        return pose_.pan_deg;
    case Axis::tilt:
        return pose_.tilt_deg;
    case Axis::roll:
        return pose_.roll_deg;
    case Axis::forward:
        break;
    }
    return pose_.forward_m;
}

void GuidedHand::move(Axis axis, double amount, double speed, bool look) {
    const double side = axis == Axis::pan || axis == Axis::roll ? side_ : 1.0;
    moves_.push_back({axis, side * amount, std::max(shortest_move_s, std::abs(amount) / speed), 0.0, look});
}

double GuidedHand::hear_words(const AimInstruction& instruction, double now_s) {
    const double ends =
        now_s + manner_.speech_starts_s + 60.0 * words_in(instruction) / manner_.words_per_minute;
    hears_words_ = true;
    heard_ = instruction;
    acts_at_s_ = ends + reaction_s_;
    return ends;
}

void GuidedHand::hear_tone(const AimTone& tone, double now_s) { tones_.emplace_back(now_s, tone); }

void GuidedHand::act(const AimInstruction& instruction) {
    moves_.clear();
    const double length = chance_.factor(manner_.spread);
    const double degrees =
        length * measure(instruction.step, manner_.little_deg, manner_.some_deg, manner_.much_deg);
    const double metres =
        length * measure(instruction.step, manner_.little_m, manner_.some_m, manner_.much_m);
    const double side = chance_.happens(manner_.wrong_side) ? -1.0 : 1.0;
    const double height = chance_.happens(manner_.wrong_height) ? -1.0 : 1.0;
    switch (instruction.advice) {
    case Advice::look_left:
    case Advice::look_right:
        move(Axis::pan, side * (instruction.advice == Advice::look_right ? look_deg : -look_deg),
             manner_.look_deg_s, true);
        break;
    case Advice::look_up:
    case Advice::look_down:
        move(Axis::tilt, height * (instruction.advice == Advice::look_up ? look_deg : -look_deg),
             manner_.look_deg_s, true);
        break;
    case Advice::move_left:
    case Advice::move_right:
        move(Axis::pan, side * (instruction.advice == Advice::move_right ? degrees : -degrees),
             manner_.turn_deg_s);
        break;
    case Advice::move_up:
    case Advice::move_down:
        move(Axis::tilt, height * (instruction.advice == Advice::move_up ? degrees : -degrees),
             manner_.turn_deg_s);
        break;
    case Advice::closer:
    case Advice::farther:
        move(Axis::forward, instruction.advice == Advice::closer ? metres : -metres, manner_.walk_m_s);
        break;
    case Advice::turn_clockwise:
    case Advice::turn_anticlockwise:
        move(Axis::roll, side * (instruction.advice == Advice::turn_clockwise ? degrees : -degrees),
             manner_.turn_deg_s);
        break;
    case Advice::more_light:
    case Advice::light_behind_them:
    case Advice::keep_still:
    case Advice::eyes_shut:
    case Advice::ready:
        break; // the hand stops
    }
}

void GuidedHand::correct(const AimTone& tone) {
    const double interval = 1.0 / tone.beats_per_s;
    const double share = (interval - 1.0 / fastest_beats) / (1.0 / slowest_beats - 1.0 / fastest_beats);
    const double distance = (1.0 + share * (far_off - 1.0)) * chance_.factor(manner_.tone_spread);
    const double side = chance_.happens(manner_.tone_wrong_side) ? -tone.side : tone.side;
    const double pitch = tone.pitch_octaves / highest_octaves;
    const double height = chance_.happens(manner_.tone_wrong_height) ? -pitch : pitch;
    const double degrees = manner_.tone_step_deg * distance;
    if (std::abs(side) > heard_side)
        move(Axis::pan, degrees * side, manner_.turn_deg_s);
    if (std::abs(height) > heard_side)
        move(Axis::tilt, degrees * height, manner_.turn_deg_s);
    double longest = shortest_move_s;
    for (const Move& each : moves_)
        longest = std::max(longest, each.lasts_s);
    corrects_at_s_ = now_s_ + longest + reaction_s_;
}

void GuidedHand::aim_at_voice() {
    move(Axis::pan, side_ * (manner_.aim_pan_deg * chance_.normal() - pose_.pan_deg), manner_.turn_deg_s);
    move(Axis::tilt, manner_.aim_tilt_deg * chance_.normal() - pose_.tilt_deg, manner_.turn_deg_s);
    aims_at_s_ = now_s_ + manner_.re_aims_s * chance_.factor(manner_.spread);
}

void GuidedHand::follow_tone() {
    while (tones_.size() > 1 && tones_[1].first <= now_s_ - reaction_s_)
        tones_.pop_front();
    const bool heard =
        !tones_.empty() && tones_.front().first <= now_s_ - reaction_s_ && tones_.front().second.sounds;
    if (!heard) {
        if (!hears_words_ && moves_.empty() && now_s_ >= aims_at_s_)
            aim_at_voice();
        return;
    }
    const AimTone& tone = tones_.front().second;
    aims_at_s_ = now_s_ + manner_.re_aims_s;
    const bool on_place = tone.beats_per_s <= 0.0;
    std::erase_if(moves_, [this, &tone, on_place](const Move& each) {
        if (each.axis != Axis::pan && each.axis != Axis::tilt)
            return false;
        const bool passed = each.axis == Axis::pan
                                ? tone.side * side_ * each.amount < 0.0 && std::abs(tone.side) > heard_side
                                : tone.pitch_octaves * each.amount < 0.0 &&
                                      std::abs(tone.pitch_octaves) > heard_side * highest_octaves;
        return each.look || on_place || passed;
    });
    if (!on_place && moves_.empty() && now_s_ >= corrects_at_s_)
        correct(tone);
}

void GuidedHand::step(double dt) {
    now_s_ += dt;
    if (heard_ && now_s_ >= acts_at_s_) {
        act(*heard_);
        heard_.reset();
    }
    follow_tone();
    for (Move& each : moves_) {
        const double before = reached(each.done_s / each.lasts_s);
        each.done_s += dt;
        value(each.axis) += each.amount * (reached(each.done_s / each.lasts_s) - before);
    }
    std::erase_if(moves_, [](const Move& each) { return each.done_s >= each.lasts_s; });
}

} // namespace tp
