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
    /// No larger than the screen it is on; the whole of one that is taller than wide.
    void fit_to_screen();
};

} // namespace tp
