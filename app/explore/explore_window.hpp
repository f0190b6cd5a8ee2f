// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/controls/notification_announcer.hpp"
#include "app/explore/explore_session.hpp"

#include <QQuickView>

namespace tp {

/// The explore page in a window of its own.
class ExploreWindow final : public QQuickView {
    Q_OBJECT
public:
    /// Both must outlive the window.
    ExploreWindow(ExploreSession& session, NotificationAnnouncer& announcer);
};

} // namespace tp
