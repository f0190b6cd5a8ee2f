// SPDX-License-Identifier: Apache-2.0
#include "core/aiming/advice_pace.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tp {

namespace {

constexpr double better = 0.93; ///< of the least so far: it helps
constexpr double worse = 1.3;   ///< of it: the hand went the wrong way

/// So long an instruction must hold before it is said: what a hand that moves does by itself is no news.
double settles_s(Advice advice) {
    switch (advice) {
    case Advice::keep_still:
        return 0.7;
    case Advice::more_light:
    case Advice::light_behind_them:
    case Advice::eyes_shut:
        return 0.4;
    default:
        return is_look(advice) ? 0.3 : 0.0;
    }
}

double pause_of(Advice advice) {
    switch (advice) {
    case Advice::ready:
    case Advice::more_light:
    case Advice::light_behind_them:
    case Advice::eyes_shut:
        return again_when_well_s;
    default:
        return again_s;
    }
}

} // namespace

void AdvicePace::forget() {
    ended_.reset();
    said_.reset();
}

void AdvicePace::sentence_ended(double now_s) {
    if (!speaking_since_)
        return;
    speaking_since_.reset();
    ended_ = std::isfinite(now_s) ? now_s : last_s_;
}

bool AdvicePace::due(const AimInstruction& now, double now_s) const {
    if (ended_ && now_s - *ended_ < aim_breath_s)
        return false;
    if (said_ != now.advice)
        return now_s - since_ >= settles_s(now.advice);
    const double ended = ended_.value_or(-std::numeric_limits<double>::infinity());
    if (badness_ > worse * best_ && is_move(now.advice))
        return now_s - ended >= wrong_way_s;
    return now_s - std::max(ended, better_at_) >= pause_of(now.advice);
}

bool AdvicePace::say(const AimInstruction& now, double badness, double now_s) {
    if (!std::isfinite(now_s))
        return false;
    if (now_s < last_s_) {
        since_ = better_at_ = now_s;
        if (speaking_since_)
            speaking_since_ = now_s;
        if (ended_)
            ended_ = now_s;
    }
    last_s_ = now_s;
    if (speaking_since_ && now_s - *speaking_since_ > longest_sentence_s)
        sentence_ended(now_s);
    if (newest_ != now.advice)
        since_ = now_s;
    newest_ = now.advice;
    badness_ = std::isfinite(badness) ? badness : 0.0;
    if (badness_ < better * best_) {
        best_ = badness_;
        better_at_ = now_s;
    }
    if (speaking() || !due(now, now_s))
        return false;
    said_ = now.advice;
    speaking_since_ = now_s;
    best_ = badness_;
    return true;
}

} // namespace tp
