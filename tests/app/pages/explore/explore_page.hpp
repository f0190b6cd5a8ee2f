// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/explore/explore_module.hpp"
#include "app/parts/controls/notification_announcer.hpp"
#include "explore_bench.hpp"
#include "page_window.hpp"

#include <QPoint>
#include <QPointF>
#include <QQuickItem>

struct Page {
    tp::RecordingVoice voice;
    tp::NotificationAnnouncer announcer;
    tp::Narrator narrator{voice, announcer};
    ExploreSounds sounds;
    tp::ExploreSession session{narrator, sounds.earcons, sounds.guide, sounds.preferences,
                               patient_settings()};
    PageWindow window{"Explore/ExplorePage.qml", &session};

    Page() { session.show(drawn_photo()); }
    bool exposed() { return window.exposed(); }

    QQuickItem* surface() const { return window.rootObject()->findChild<QQuickItem*>("surface"); }
    /// Sheet frame → window.
    QPoint pixel(QPointF place) const {
        const double scale = surface()->width() / session.view()->surfaceWidth();
        return surface()->mapToScene(scale * place).toPoint();
    }
    /// A place 5 mm inside of the outline's left side, and one higher up.
    QPointF beside(double higher = 0.0) const {
        const QPointF corner =
            session.view()->frame().from_surface(session.view()->felt().lines[outline].points[1]);
        return corner + QPointF(5.0, -30.0 - higher);
    }
    static constexpr int left_eye = 0;
    static constexpr int outline = 3;
};
