// SPDX-License-Identifier: Apache-2.0
import QtQuick

// Drawn round whatever has the keyboard.
Rectangle {
    required property Item target
    property real corner: Theme.radius // of what it is drawn round; 0: a picture

    anchors.fill: parent
    anchors.margins: -Theme.ring - 2
    visible: target.activeFocus
    color: "transparent"
    radius: corner + Theme.ring + 2
    border.width: Theme.ring
    border.color: Theme.accent
}
