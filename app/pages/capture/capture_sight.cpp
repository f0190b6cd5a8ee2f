// SPDX-License-Identifier: Apache-2.0
#include "app/pages/capture/capture_sight.hpp"

#include <utility>

namespace tp {

CaptureSight::CaptureSight(CaptureCamera& camera, CaptureTouch& touch, CaptureAiming& aiming,
                           CaptureShutter& shutter, CaptureMemo& memo, CaptureMoment& moment,
                           CaptureTeller& teller)
    : camera_(camera), touch_(touch), aiming_(aiming), shutter_(shutter), memo_(memo), moment_(moment),
      teller_(teller) {
    connect(&camera_, &CaptureCamera::began, this, &CaptureSight::camera_began);
    connect(&camera_, &CaptureCamera::seen, &touch_, &CaptureTouch::watch);
    connect(&camera_, &CaptureCamera::seen, &aiming_, &CaptureAiming::see);
    connect(&camera_, &CaptureCamera::failed, this, [this] {
        aiming_.end();
        moment_.end();
    });
    connect(&memo_, &CaptureMemo::changed, this, &CaptureSight::follow_memo);
}

void CaptureSight::enter() {
    become(state_ == State::Away || state_ == State::Hidden ? State::Hidden : State::Seen);
}

void CaptureSight::leave() {
    become(state_ == State::Away || state_ == State::Hidden ? State::Away : State::Left);
}

void CaptureSight::show_window(bool shown) {
    const bool open = state_ == State::Hidden || state_ == State::Seen;
    become(shown ? (open ? State::Seen : State::Left) : (open ? State::Hidden : State::Away));
}

void CaptureSight::become(State state) {
    const State before = std::exchange(state_, state);
    if (before == state)
        return;
    if (state == State::Seen)
        go_on();
    else if (before == State::Seen || before == State::Hidden)
        go_off();
}

void CaptureSight::go_on() {
    camera_.switch_on();
    touch_.enter();
}

/// Nothing of what was seen is kept.
void CaptureSight::go_off() {
    memo_.finish();
    shutter_.forget();
    camera_.switch_off();
    moment_.end();
    aiming_.end();
    touch_.leave();
    teller_.silence();
}

void CaptureSight::camera_began() {
    aiming_.begin(camera_.held());
    moment_.begin();
    teller_.sound(Earcon::ready);
}

void CaptureSight::follow_memo() {
    if (memo_.running()) {
        aiming_.hush();
        moment_.end();
    } else {
        aiming_.listen();
        if (camera_.state() == CaptureCamera::On)
            moment_.begin();
    }
}

void CaptureSight::try_again() {
    if (state_ == State::Seen && camera_.state() == CaptureCamera::Failed)
        camera_.switch_on();
}

} // namespace tp
