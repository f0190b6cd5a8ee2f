// SPDX-License-Identifier: Apache-2.0
#include "app/explore/explore_window.hpp"

#include "app/explore/explore_module.hpp"

#include <QColor>
#include <QScreen>
#include <QVariant>

namespace tp {

ExploreWindow::ExploreWindow(ExploreSession& session, NotificationAnnouncer& announcer) {
    register_explore();
    setResizeMode(SizeRootObjectToView);
    setMinimumSize({480, 560});
    resize(1280, 800);
    setColor(QColor(0x0e, 0x12, 0x17));
    const auto entitle = [this, &session] {
        setTitle(session.photoName().isEmpty() ? QString("TouchPhoto")
                                               : tr("%1 – TouchPhoto").arg(session.title()));
    };
    connect(&session, &ExploreSession::photoChanged, this, entitle);
    entitle();
    setInitialProperties(
        {{"session", QVariant::fromValue(&session)}, {"announcer", QVariant::fromValue(&announcer)}});
    setSource(QUrl("qrc:/qt-project.org/imports/TouchPhoto/Explore/ExplorePage.qml"));
}

void ExploreWindow::fit_to_screen() {
    const QSize room = screen()->availableSize();
    resize(room.height() > room.width() ? room : size().boundedTo(room));
}

} // namespace tp
