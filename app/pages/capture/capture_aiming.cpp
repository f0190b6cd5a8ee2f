// SPDX-License-Identifier: Apache-2.0
#include "app/pages/capture/capture_aiming.hpp"

#include "app/pages/capture/aim_cue.hpp"
#include "app/pages/capture/aim_words.hpp"

#include <QStringList>

#include <algorithm>
#include <utility>

namespace tp {

namespace {
/// After a camera began anew: not good for so long, the hand is elsewhere; less is a camera that gets used to the light.
constexpr double elsewhere_s = 2.0;
} // namespace

CaptureAiming::CaptureAiming(CaptureChoices& choices, CaptureTeller& teller, SonifiedGuide& guide,
                             CaptureTouch& touch)
    : choices_(choices), teller_(teller), guide_(guide), touch_(touch), aiming_(choices.aim()),
      aim_(choices.aim()) {
    connect(&choices_, &CaptureChoices::changed, this, [this] {
        if (aim_ != choices_.aim())
            aiming_.aim_at(aim_ = choices_.aim());
    });
}

QString CaptureAiming::advice() const { return now_ ? AimWords::instruction(*now_, false) : QString(); }

void CaptureAiming::begin(HeldCamera held) {
    const bool turned_round = std::exchange(front_, held.front) != held.front;
    const bool taken_before = aimed_ == Aimed::Taken || aimed_ == Aimed::Again;
    aiming_ = Aiming(aim_, held);
    now_.reset();
    good_since_.reset();
    bad_since_.reset();
    aimed_ = taken_before && !turned_round ? Aimed::Again : Aimed::Sought;
    another_told_ = false;
    words_ = Words::Open;
    whole_ = true;
    people_.clear();
    pulses_.forget();
    emit changed();
}

void CaptureAiming::end() {
    quiet();
    now_.reset();
    emit changed();
}

bool CaptureAiming::hush() {
    quiet();
    return std::exchange(words_, Words::Hushed) != Words::Hushed;
}

void CaptureAiming::listen() {
    if (words_ == Words::Hushed)
        words_ = Words::Owed;
}

void CaptureAiming::see(const AimFrame& frame) {
    now_s_ = frame.time_s;
    if (words_ == Words::Owed && !teller_.speaking()) {
        words_ = Words::Open;
        aiming_.aim_at(aim_); // what was not said is said now
    }
    aiming_.with_tone(tone());
    const AimAnswer answer = aiming_.see(frame);
    now_ = answer.now;
    if (!answer.good) {
        good_since_.reset();
        if (!bad_since_)
            bad_since_ = now_s_;
        if (aimed_ != Aimed::Again || now_s_ - *bad_since_ >= elsewhere_s)
            aimed_ = Aimed::Sought;
    } else {
        bad_since_.reset();
        if (aimed_ == Aimed::Sought)
            aimed_ = Aimed::Reached;
        if (!good_since_)
            good_since_ = now_s_;
    }
    if (answer.say)
        say(*answer.say);
    hear(answer.tone);
    emit changed();
    if (answer.take && aimed_ == Aimed::Reached && choices_.by_itself())
        emit take_asked();
}

void CaptureAiming::say(const AimInstruction& instruction) {
    if (aimed_ == Aimed::Taken || words_ == Words::Hushed)
        return aiming_.sentence_ended(now_s_);
    if (teller_.speaking()) {
        words_ = Words::Owed;
        return aiming_.sentence_ended(now_s_);
    }
    const bool another = aimed_ == Aimed::Again && instruction.advice == Advice::ready;
    if (another && std::exchange(another_told_, true))
        return aiming_.sentence_ended(now_s_);
    QStringList words;
    if (const QString people = AimWords::people(instruction); people != people_) {
        people_ = people;
        words << people;
    }
    words << (another ? AimWords::another() : AimWords::instruction(instruction, whole_));
    words.removeAll(QString());
    whole_ = whole_ && !AimWords::is_way(instruction.advice);
    teller_.tell(words.join(' '), [this] { aiming_.sentence_ended(now_s_); });
}

/// The tone sounds: it was chosen, or stands in for ticks where nothing ticks.
bool CaptureAiming::tone() const { return choices_.tone() || (choices_.ticks() && !touch_.in_use()); }

void CaptureAiming::quiet() {
    guide_.silence();
    touch_.still();
}

void CaptureAiming::hear(const AimTone& tone) {
    if (words_ == Words::Hushed || !tone.sounds) {
        pulses_.forget();
        return quiet();
    }
    feel(tone);
    if (!this->tone())
        return guide_.silence();
    AimTone heard = tone;
    if (teller_.speaking())
        heard.gain = std::min(heard.gain, gain_under_words);
    guide_.sound(aim_cue(heard, good_since_ ? (now_s_ - *good_since_) / good_for_s : 0.0));
}

void CaptureAiming::feel(const AimTone& tone) {
    if (!touch_.in_use())
        return pulses_.forget();
    if (const auto strength = pulses_.due(tone, now_s_))
        touch_.pulse(*strength);
}

void CaptureAiming::tell_all() {
    if (!now_)
        return;
    QStringList words{AimWords::people(*now_), AimWords::cut(now_->cut), AimWords::instruction(*now_, true)};
    words.removeAll(QString());
    teller_.answer(words.join(' '));
}

} // namespace tp
