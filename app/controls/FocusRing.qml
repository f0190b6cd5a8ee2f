// SPDX-License-Identifier: Apache-2.0
import QtQuick

// Drawn round whatever has the keyboard.
Rectangle {
    required property Item target

    anchors.fill: parent
    anchors.margins: -Theme.ring - 2
    visible: target.activeFocus
    color: "transparent"
    radius: Theme.radius + Theme.ring + 2
    border.width: Theme.ring
    border.color: Theme.accent
}
