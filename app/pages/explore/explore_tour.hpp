// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/explore/explore_finger.hpp"
#include "app/pages/explore/explore_view.hpp"
#include "app/pages/explore/explore_words.hpp"
#include "app/parts/finger/finger_servo.hpp"
#include "app/parts/finger/page_clock.hpp"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

#include <cstddef>
#include <deque>
#include <optional>

namespace tp {

/// The guided tour: the device leads the finger round a feature, or round every feature of a face, each named
/// before.
///
/// |         | toggle  | toggleFace | the name is spoken | led round                | end, a hand that leads, another scene |
/// |---------|---------|------------|--------------------|--------------------------|---------------------------------------|
/// | None    | Leading | Naming     |                    |                          |                                       |
/// | Naming  | None    | None       | Leading            |                          | None                                  |
/// | Leading | None    | None       |                    | Naming the next, or None | None                                  |
class ExploreTour final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")

    Q_PROPERTY(bool touring READ touring NOTIFY changed)
    /// How much of the feature the finger has been led round, 0 … 1.
    Q_PROPERTY(double progress READ progress NOTIFY progressed)
public:
    enum class State {
        None,
        Naming, ///< the next feature is told
        Leading ///< the finger is led round it
    };

    /// All must outlive this.
    ExploreTour(FingerServo& servo, ExploreView& view, ExploreFinger& finger, ExploreWords& words,
                const PageClock& now);

    State state() const { return state_; }
    bool touring() const { return state_ != State::None; }
    double progress() const { return progress_; }

    /// Starts the tour round the feature that is meant, or ends it.
    Q_INVOKABLE void toggle();
    /// Starts the tour of every feature of the face under the finger; or ends it.
    Q_INVOKABLE void toggleFace();
    /// Lets go of the finger, without a word where `sentence` is empty.
    void end(const QString& sentence = {});
    /// The same because the person has taken the lead.
    void end_told() { end(tr("Tour ended.")); }
    /// The hand is there now: whether it leads itself, because there is no tour or because it has moved too
    /// far for one.
    bool yields_to(Vec2 hand);
    /// Time has passed: what comes next. `progress` is the servo's.
    void follow(double progress, double now);

signals:
    void changed();
    void progressed();

private:
    bool may_begin();
    void lead(int feature);
    void set_progress(double progress);

    FingerServo& servo_;
    ExploreView& view_;
    ExploreFinger& finger_;
    ExploreWords& words_;
    const PageClock& now_;
    State state_ = State::None;
    std::deque<int> left_;          ///< features of the tour of a face, the next one first
    double goes_on_at_ = 0.0;       ///< s, when its name has been spoken
    std::optional<Vec2> grab_from_; ///< where the hand was when the tour began, surface frame
    double progress_ = 0.0;
};

} // namespace tp
