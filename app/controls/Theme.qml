// SPDX-License-Identifier: Apache-2.0
pragma Singleton
import QtQuick

// Colours and sizes of every page. Each text colour keeps 7:1 on each of the two grounds.
QtObject {
    readonly property color ground: "#0e1217"
    readonly property color panel: "#171d25"
    readonly property color raised: "#242d39"
    readonly property color pressed: "#33404f"
    readonly property color edge: "#8b9bb0"
    readonly property color text: "#f4f6f8"
    readonly property color quiet: "#bcc8d6"
    readonly property color accent: "#ffd166"
    readonly property color accentText: "#14181d"
    readonly property color line: "#8fdcff"
    readonly property color finger: "#ff9eb0"

    property real textScale: 1.0
    readonly property real textSize: 18 * textScale
    readonly property real smallSize: 16 * textScale
    readonly property real headingSize: 22 * textScale
    readonly property real bigSize: 46 * textScale

    readonly property real target: Math.max(64, 48 * textScale)
    readonly property real gap: 12
    readonly property real radius: 10
    readonly property real ring: 3
}
