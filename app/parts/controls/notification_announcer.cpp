// SPDX-License-Identifier: Apache-2.0
#include "app/parts/controls/notification_announcer.hpp"

namespace tp {

namespace {
constexpr int appear_after_ms = 20; ///< a turn or two of the event loop, so that the name is there first
constexpr int vanish_after_ms = 2000;
} // namespace

NotificationAnnouncer::NotificationAnnouncer(QObject* parent) : Announcer(parent) {
    appear_.setSingleShot(true);
    vanish_.setSingleShot(true);
    connect(&appear_, &QTimer::timeout, this, [this] {
        show(true);
        vanish_.start(vanish_after_ms);
    });
    connect(&vanish_, &QTimer::timeout, this, [this] { show(false); });
}

void NotificationAnnouncer::announce(const QString& sentence) {
    vanish_.stop();
    sentence_ = sentence;
    show(false);
    appear_.start(appear_after_ms);
}

void NotificationAnnouncer::show(bool shown) {
    shown_ = shown;
    emit changed();
}

} // namespace tp
