// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/capture/capture_aiming.hpp"
#include "app/pages/capture/capture_camera.hpp"
#include "app/pages/capture/capture_memo.hpp"
#include "app/pages/capture/capture_moment.hpp"
#include "app/pages/capture/capture_shutter.hpp"
#include "app/pages/capture/capture_teller.hpp"
#include "app/pages/capture/capture_touch.hpp"

#include <QObject>

namespace tp {

/// What is on while the page is to be seen: the camera, what leads the hand, and the microphone that keeps the moment. All of it
/// goes off with the page and with its window. While a memo is spoken the hand is not led, and the memo alone has the microphone.
///
/// |        | the page opens | it is left | the window is hidden | it is shown again |
/// |--------|----------------|------------|----------------------|-------------------|
/// | Left   | Seen           |            | Away                 |                   |
/// | Away   | Hidden         |            |                      | Left              |
/// | Hidden |                | Away       |                      | Seen              |
/// | Seen   |                | Left       | Hidden               |                   |
class CaptureSight final : public QObject {
    Q_OBJECT
public:
    enum class State {
        Left,   ///< the page is not open
        Away,   ///< nor is its window to be seen
        Hidden, ///< it is open in a window that is not to be seen
        Seen
    };

    /// All must outlive it.
    CaptureSight(CaptureCamera& camera, CaptureTouch& touch, CaptureAiming& aiming, CaptureShutter& shutter,
                 CaptureMemo& memo, CaptureMoment& moment, CaptureTeller& teller);

    State state() const { return state_; }

    void enter();
    void leave();
    void show_window(bool shown);
    /// A camera that failed is tried again.
    void try_again();

private:
    void become(State state);
    void go_on();
    void go_off();
    void camera_began();
    void follow_memo();

    CaptureCamera& camera_;
    CaptureTouch& touch_;
    CaptureAiming& aiming_;
    CaptureShutter& shutter_;
    CaptureMemo& memo_;
    CaptureMoment& moment_;
    CaptureTeller& teller_;
    State state_ = State::Left;
};

} // namespace tp
