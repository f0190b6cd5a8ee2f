// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/explore/clock_guide.hpp"
#include "app/pages/explore/explore_choices.hpp"
#include "app/pages/explore/explore_finger.hpp"
#include "app/pages/explore/explore_tour.hpp"
#include "app/pages/explore/explore_view.hpp"
#include "app/pages/explore/explore_words.hpp"
#include "app/pages/explore/explore_zoom.hpp"
#include "app/pages/explore/passage_earcons.hpp"
#include "app/parts/finger/finger_servo.hpp"
#include "app/parts/finger/page_clock.hpp"
#include "audio/guide/sonified_guide.hpp"
#include "audio/sound/earcon_player.hpp"

#include <QObject>

namespace tp {

/// What the finger hears on its way: names of features, earcons, and the guide that leads to where a force
/// begins.
///
/// |        | listen | hush   | enter | leave |
/// |--------|--------|--------|-------|-------|
/// | open   |        | hushed |       | away  |
/// | hushed | open   |        | open  | away  |
/// | away   |        |        | open  |       |
class ExploreEar final : public QObject {
    Q_OBJECT
public:
    enum class State {
        open,
        hushed, ///< stopped by the person: the guide waits for the next touch
        away,   ///< the page is out of sight: nothing is heard
    };

    /// All must outlive this.
    ExploreEar(FingerServo& servo, ExploreView& view, ExploreFinger& finger, ExploreTour& tour,
               ExploreZoom& zoom, ExploreChoices& choices, ExploreWords& words, EarconPlayer& earcons,
               SonifiedGuide& guide, const PageClock& now);
    /// Nothing sounds behind it.
    ~ExploreEar() override;

    State state() const { return state_; }
    bool sounds() const { return guide_.sounds(); }

    void enter();
    void leave();
    void listen();
    void hush();
    /// The guide is silent until the finger is heard again.
    void silence() { guide_.silence(); }
    /// The finger is lifted: to the next one everything is new.
    void lift();
    /// The finger is where it is, now. Only where there is something to feel.
    void hear();

private:
    void tell_feature(double now);
    void tell_way(Vec2 place, double now);
    void guide(Vec2 place, double now);
    void lead_by_sound(Vec2 place);
    bool ticks() const;
    bool present(double now) const;
    double level(double distance) const;

    FingerServo& servo_;
    ExploreView& view_;
    ExploreFinger& finger_;
    ExploreTour& tour_;
    ExploreZoom& zoom_;
    ExploreChoices& choices_;
    ExploreWords& words_;
    EarconPlayer& earcons_;
    SonifiedGuide& guide_;
    const PageClock& now_;
    State state_ = State::open;
    PassageEarcons way_;
    ClockGuide clock_guide_;
};

} // namespace tp
