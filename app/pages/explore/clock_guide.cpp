// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/clock_guide.hpp"

#include "app/pages/explore/place_words.hpp"
#include "audio/guide/sonar_cue.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace tp {

namespace {

constexpr double letters_a_second = 14.0;
constexpr char16_t first_wide = 0x1100; // Hangul Jamo and all that comes behind

bool worth_saying_again(const ClockGuide::Word& now, const ClockGuide::Word& before) {
    return now.hour != before.hour || std::abs(now.millimetres - before.millimetres) >= 2;
}

} // namespace

double speech_seconds(const QString& sentence, double rate) {
    double letters = 0.0;
    for (const QChar letter : sentence)
        letters += letter.unicode() >= first_wide ? 3.0 : 1.0;
    return letters / letters_a_second * std::exp2(-std::clamp(rate, -1.0, 1.0));
}

std::optional<ClockGuide::Word> ClockGuide::follow(Vec2 place, double distance, Vec2 way, double now) {
    if (!is_finite(place) || !std::isfinite(distance))
        return std::nullopt;
    if (!rests_at_ || length(place - *rests_at_) > rest_mm) {
        if (!rests_at_)
            nearest_mm_ = distance;
        rests_at_ = place;
        rests_since_ = now;
    }
    nearest_mm_ = std::min(nearest_mm_, distance);
    const bool rests = now - rests_since_ >= rest_s;
    const bool drifts = distance >= nearest_mm_ + drift_mm;
    if (distance <= on_line_mm || now < busy_until_ || !(rests || drifts))
        return std::nullopt;
    const Word word{clock_direction(way), static_cast<int>(std::lround(distance))};
    if (said_ && !worth_saying_again(word, *said_))
        return std::nullopt;
    said_ = word;
    nearest_mm_ = distance;
    return word;
}

void ClockGuide::busy_until(double then) { busy_until_ = std::max(busy_until_, then); }

void ClockGuide::lift() {
    rests_at_.reset();
    said_.reset();
}

} // namespace tp
