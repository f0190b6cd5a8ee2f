// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/explore/explore_choices.hpp"
#include "app/pages/explore/explore_device.hpp"
#include "app/pages/explore/explore_ear.hpp"
#include "app/pages/explore/explore_finger.hpp"
#include "app/pages/explore/explore_gestures.hpp"
#include "app/pages/explore/explore_hand.hpp"
#include "app/pages/explore/explore_settings.hpp"
#include "app/pages/explore/explore_touch.hpp"
#include "app/pages/explore/explore_tour.hpp"
#include "app/pages/explore/explore_view.hpp"
#include "app/pages/explore/explore_walk.hpp"
#include "app/pages/explore/explore_watch.hpp"
#include "app/pages/explore/explore_words.hpp"
#include "app/pages/explore/explore_zoom.hpp"
#include "app/parts/finger/finger_servo.hpp"
#include "app/parts/finger/page_clock.hpp"

#include <QEvent>
#include <QObject>
#include <QUrl>
#include <QtQml/qqmlregistration.h>

#include <memory>

namespace tp {

/// A photograph being felt: the parts that decide what the explore page shows and tells, each with one thing
/// to care for, and what concerns several of them. A part knows those before it. The page only binds and
/// draws.
class ExploreSession final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(tp::ExploreWords* words READ words CONSTANT)
    Q_PROPERTY(tp::ExploreChoices* choices READ choices CONSTANT)
    Q_PROPERTY(tp::ExploreView* view READ view CONSTANT)
    Q_PROPERTY(tp::ExploreWalk* walk READ walk CONSTANT)
    Q_PROPERTY(tp::ExploreFinger* finger READ finger CONSTANT)
    Q_PROPERTY(tp::ExploreTour* tour READ tour CONSTANT)
    Q_PROPERTY(tp::ExploreZoom* zoom READ zoom CONSTANT)
    Q_PROPERTY(tp::ExploreHand* hand READ hand CONSTANT)
    Q_PROPERTY(tp::ExploreDevice* device READ device CONSTANT)
    Q_PROPERTY(tp::ExploreTouch* touch READ touch CONSTANT)
public:
    /// All must outlive the session.
    ExploreSession(Narrator& narrator, EarconPlayer& earcons, SonifiedGuide& guide, Preferences& preferences,
                   ExploreSettings settings = {});

    ExploreWords* words() { return &words_; }
    ExploreChoices* choices() { return &choices_; }
    ExploreView* view() { return &view_; }
    const ExploreView* view() const { return &view_; }
    ExploreWalk* walk() { return &walk_; }
    ExploreFinger* finger() { return &finger_; }
    ExploreTour* tour() { return &tour_; }
    ExploreZoom* zoom() { return &zoom_; }
    ExploreHand* hand() { return &hand_; }
    ExploreDevice* device() { return &device_; }
    ExploreTouch* touch() { return &touch_; }
    const ExploreWatch& watch() const { return watch_; }

    /// The page comes into sight: says where one is and what can be done. The force is as it was.
    Q_INVOKABLE void enter();
    /// The page goes out of sight: its sounds, its speech and its force end; nothing is told until `enter`.
    Q_INVOKABLE void leave();
    /// Asks to go where one came from.
    Q_INVOKABLE void back() { emit backAsked(); }

    /// Reads a photograph and makes it felt; the words say what was found. Returns at once.
    Q_INVOKABLE void open(const QUrl& file);
    void open_file(const QString& file);
    /// Where a file dialog begins: the user's pictures.
    Q_INVOKABLE QUrl picturesFolder() const;
    /// A photograph that is loaded already.
    void show(std::shared_ptr<const LoadedPhoto> photo) { view_.show(std::move(photo)); }

    /// Stops what sounds or moves: tour, guide, force, the search for faces in a photograph just opened.
    /// False where nothing did.
    Q_INVOKABLE bool stop();
    /// The same; where there is nothing to stop the force comes back.
    Q_INVOKABLE void stopOrStart();

signals:
    void backAsked();

private:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void stop_everything();

    PageClock now_;
    FingerServo servo_;
    ExploreWords words_;
    ExploreChoices choices_;
    ExploreView view_;
    ExploreWalk walk_;
    ExploreFinger finger_;
    ExploreTour tour_;
    ExploreZoom zoom_;
    ExploreEar ear_;
    ExploreHand hand_;
    ExploreDevice device_;
    ExploreTouch touch_;
    ExploreWatch watch_;
    ExploreGestures gestures_;
};

} // namespace tp
