// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/explore/explore_choices.hpp"
#include "app/pages/explore/explore_ear.hpp"
#include "app/pages/explore/explore_finger.hpp"
#include "app/pages/explore/explore_hand.hpp"
#include "app/pages/explore/explore_tour.hpp"
#include "app/pages/explore/explore_view.hpp"
#include "app/pages/explore/explore_words.hpp"
#include "app/pages/explore/explore_zoom.hpp"
#include "app/parts/controls/recording_announcer.hpp"
#include "app/parts/finger/finger_servo.hpp"
#include "app/parts/finger/page_clock.hpp"
#include "explore_bench.hpp"

#include <QObject>
#include <QPointF>
#include <QString>
#include <QTimer>

#include <cstddef>
#include <vector>

constexpr int left_eye = 0;
constexpr int lips = 2;
constexpr int outline = 3;

/// The parts of an ExploreSession without it and without a device. The time is a variable; the servo, whose
/// force is on where a photograph is, runs in its own. It is looked at as the session does while Qt's events
/// are served.
struct ExploreParts {
    double time = 100.0;
    tp::RecordingVoice voice;
    tp::RecordingAnnouncer announcer;
    tp::Narrator narrator{voice, announcer};
    ExploreSounds sounds;
    tp::ExploreSettings settings = settings_at(time);
    tp::PageClock now{settings.now};
    tp::FingerServo servo{
        {settings.surface.width_mm, settings.surface.height_mm}, settings.servo, settings.plant};
    tp::ExploreWords words{narrator, sounds.earcons, sounds.preferences, now};
    tp::ExploreChoices choices{sounds.preferences, servo, words, settings};
    tp::ExploreView view{settings, servo, words, choices};
    tp::ExploreFinger finger{servo, view, words, now};
    tp::ExploreTour tour{servo, view, finger, words, now};
    tp::ExploreZoom zoom{servo, view, finger, tour, words, now};
    tp::ExploreEar ear{servo, view, finger, tour, zoom, choices, words, sounds.earcons, sounds.guide, now};
    tp::ExploreHand hand{servo, view, finger, tour, ear, words, now};
    QTimer timer;

    /// With a photograph of so many faces; 0: with none.
    explicit ExploreParts(int faces = 1, std::vector<QString> names = {}) {
        QObject::connect(&view, &tp::ExploreView::fresh, [this] { servo.engage(); });
        QObject::connect(&timer, &QTimer::timeout, [this] { poll(); });
        timer.start(16);
        if (faces > 0)
            view.show(drawn_photo(faces, std::move(names)));
        voice.clear();
    }
    void poll() {
        if (!view.ready())
            return;
        const tp::ServoSnapshot seen = servo.snapshot();
        finger.poll(seen, now());
        tour.follow(seen.tour_progress, now());
        ear.hear();
    }

    /// A place so many millimetres right of and above a feature's first point (sheet frame).
    QPointF by(int feature, double right = 0.0, double up = 0.0) const {
        return view.frame().from_surface(view.line(feature).points[0] + tp::Vec2(right, up));
    }
    /// A place left of the outline's left side.
    QPointF left_of_outline(double away) const {
        const auto& points = view.line(outline).points;
        return view.frame().from_surface(0.5 * (points[0] + points[1]) - tp::Vec2(away, 0.0));
    }
    /// Distance of a place in the sheet's frame to a feature's line, mm.
    double distance_to(int feature, QPointF place) const {
        return tp::distance_to(view.line(feature), view.frame().to_surface(place));
    }
    void down(QPointF place, int id = 0) { hand.fingerDown(id, place.x(), place.y()); }
    void move(QPointF place, double later = 0.016) {
        time += later;
        hand.fingerMoved(0, place.x(), place.y());
    }
    void stay(QPointF place, double seconds) {
        for (double end = time + seconds; time < end;)
            move(place, 0.01);
    }
    QString said() const { return voice.said().isEmpty() ? QString() : voice.said().back(); }
};
