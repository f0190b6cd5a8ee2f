// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/explore/dwell.hpp"
#include "app/pages/explore/explore_view.hpp"
#include "app/pages/explore/explore_words.hpp"
#include "app/pages/explore/feature_tracker.hpp"
#include "app/pages/explore/hand_state.hpp"
#include "app/parts/finger/finger_servo.hpp"
#include "app/parts/finger/page_clock.hpp"
#include "core/servo/servo_loop.hpp"

#include <QObject>
#include <QPointF>
#include <QString>
#include <QtQml/qqmlregistration.h>

#include <cmath>
#include <optional>

namespace tp {

/// Where the finger is, which feature it is on, and the force on it. QML places are in the sheet's frame (see
/// SheetFrame), forces in newtons with y down, as they are drawn.
class ExploreFinger final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")

    Q_PROPERTY(QPointF place READ place NOTIFY moved)
    /// The hand, to which the finger is bound by a spring where it is only drawn.
    Q_PROPERTY(QPointF pointer READ pointer NOTIFY moved)
    Q_PROPERTY(QPointF force READ force NOTIFY moved)
    /// Ticks lead it on a tour, and where to.
    Q_PROPERTY(bool led READ led NOTIFY moved)
    Q_PROPERTY(QPointF leader READ leader NOTIFY moved)
    Q_PROPERTY(double newtons READ newtons NOTIFY moved)
    /// Index of the feature that it is on; -1: none.
    Q_PROPERTY(int feature READ feature NOTIFY featureChanged)
    Q_PROPERTY(QString featureName READ featureName NOTIFY featureChanged)
public:
    /// All must outlive this. `dwell_s`: how long a finger stays on a feature before it is told.
    ExploreFinger(FingerServo& servo, ExploreView& view, ExploreWords& words, const PageClock& now,
                  double dwell_s = Dwell::usual_s);

    QPointF place() const { return place_; }
    QPointF pointer() const { return pointer_; }
    QPointF force() const { return force_; }
    bool led() const { return led_; }
    QPointF leader() const { return leader_; }
    double newtons() const { return std::hypot(force_.x(), force_.y()); }
    int feature() const { return tracker_.current(); }
    QString featureName() const { return view_.label_of(feature()); }

    /// Tells face, feature, clock direction and distance; without a photograph, what can be done.
    Q_INVOKABLE void whereAmI();

    // Places below are in the surface frame.

    /// A fingertip on a touchscreen is where it is, whatever the drawn finger does; a device's finger and a
    /// mouse's are where the force has drawn them.
    Vec2 felt_place() const;
    /// Nobody's hand is on the surface: what rests there is not told.
    bool lifted() const { return servo_.real() ? !servo_.held() : hand_.off_surface(); }
    /// The same, or nobody has come yet.
    bool up() const { return lifted() || (!servo_.real() && moved_at_ == long_ago && !hand_.touches()); }
    const HandState& hand() const { return hand_; }
    HandState& hand() { return hand_; }
    /// Where mouse or touch was last.
    const std::optional<Vec2>& hand_place() const { return hand_place_; }

    /// The hand is there; the finger has not moved yet.
    void hand_at(Vec2 place) { hand_place_ = place; }
    /// The hand moves now.
    void stir() { moved_at_ = now_(); }
    /// It sets the drawn finger down there, or draws it there.
    void set_down(Vec2 place);
    void draw_to(Vec2 place);
    /// When the hand moved last, s; long ago where it is gone.
    double moved_at() const { return moved_at_; }
    void forget_moves() { moved_at_ = long_ago; }
    /// Another device's handle is the finger now.
    void take_handle() { handle_was_at_ = {}; }

    /// What the servo says now.
    void poll(const ServoSnapshot& seen, double now);
    /// Which feature it is on now.
    int follow();
    /// The feature to tell, once it has stayed on it; -1: none.
    int stays(double now) { return dwell_.follow(feature(), now); }
    /// What it is on has been told, or need not be.
    void settle() { dwell_.settle(feature()); }
    /// The next touch is told everything anew.
    void forget_stay() { dwell_ = Dwell(dwell_s_); }
    /// It is on that feature now, and that is told already.
    void set_feature(int index);

    /// The feature that was stepped to or felt last; -1: none.
    int last_feature() const { return last_feature_; }
    void set_last_feature(int index) { last_feature_ = index; }
    /// Which feature a person means who names none: the one under the finger, the last one, the nearest. Only
    /// where there is something to feel.
    int meant_feature() const;

signals:
    void moved();
    void featureChanged();

private:
    static constexpr double long_ago = -1e9;

    void begin_anew();

    FingerServo& servo_;
    ExploreView& view_;
    ExploreWords& words_;
    const PageClock& now_;
    double dwell_s_;
    FeatureTracker tracker_;
    Dwell dwell_;
    HandState hand_;
    QPointF place_, pointer_, force_, leader_;
    bool led_ = false;
    int last_feature_ = -1;
    std::optional<Vec2> hand_place_;
    double moved_at_ = long_ago;
    Vec2 handle_was_at_{0.0};
};

} // namespace tp
