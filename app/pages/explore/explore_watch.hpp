// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/explore/explore_device.hpp"
#include "app/pages/explore/explore_ear.hpp"
#include "app/pages/explore/explore_finger.hpp"
#include "app/pages/explore/explore_touch.hpp"
#include "app/pages/explore/explore_tour.hpp"
#include "app/pages/explore/explore_view.hpp"
#include "app/pages/explore/rest_watch.hpp"
#include "app/parts/finger/finger_servo.hpp"
#include "app/parts/finger/page_clock.hpp"

#include <QObject>
#include <QTimer>

namespace tp {

/// Looks at the finger again and again while there is something to feel, so that the parts hear what has become of it. While the
/// page is out of sight, and once a finger that is only drawn has been up for RestWatch::after_s with nothing left to tell,
/// nothing ticks. A device's finger never rests.
///
/// |          | enter    | leave | quiet   | something is done |
/// |----------|----------|-------|---------|-------------------|
/// | away     | watching |       |         |                   |
/// | watching |          | away  | resting |                   |
/// | resting  | watching | away  |         | watching          |
class ExploreWatch final : public QObject {
    Q_OBJECT
public:
    enum class State { away, watching, resting };

    /// All must outlive this.
    ExploreWatch(FingerServo& servo, ExploreView& view, ExploreFinger& finger, ExploreTour& tour,
                 ExploreEar& ear, ExploreDevice& device, ExploreTouch& touch, const PageClock& now);
    ~ExploreWatch() override;

    State state() const { return state_; }

    /// The page comes into sight, or goes out of it; so does the finger.
    void enter();
    void leave();

private:
    void stir();
    void poll();
    void rest_where_quiet(Fault fault, double now);

    FingerServo& servo_;
    ExploreView& view_;
    ExploreFinger& finger_;
    ExploreTour& tour_;
    ExploreEar& ear_;
    ExploreDevice& device_;
    ExploreTouch& touch_;
    const PageClock& now_;
    State state_ = State::watching;
    RestWatch quiet_;
    QTimer timer_; ///< in `watching`, while there is something to feel
};

} // namespace tp
