// SPDX-License-Identifier: Apache-2.0
import QtQuick

// What a NotificationAnnouncer says to a screen reader. It has no look: the page shows the same words elsewhere.
Item {
    required property var announcer

    width: 1
    height: 1
    visible: announcer !== null && announcer.shown
    Accessible.role: Accessible.Notification
    Accessible.name: announcer !== null ? announcer.sentence : ""
}
