// SPDX-License-Identifier: Apache-2.0
pragma Singleton
import QtQuick

// Colours and sizes of every page, in three schemes. Each text colour keeps 7:1 on each of the three grounds.
QtObject {
    id: theme

    enum Scheme { Dark, Light, YellowOnBlack }

    // Set by the program from the person's choices.
    property int scheme: Theme.Dark
    property real textScale: 1.0
    property bool motion: true

    readonly property bool mirrored: Qt.application.layoutDirection === Qt.RightToLeft

    function pick(dark, light, yellow) { return scheme === Theme.Light ? light : scheme === Theme.YellowOnBlack ? yellow : dark }

    readonly property color ground: pick("#0e1217", "#ffffff", "#000000")
    readonly property color panel: pick("#171d25", "#f4f6f9", "#000000")
    readonly property color raised: pick("#242d39", "#e8edf3", "#141400")
    readonly property color pressed: pick("#33404f", "#cfd8e3", "#3a3a00")
    readonly property color edge: pick("#8b9bb0", "#56647a", "#d8d800")
    readonly property color text: pick("#f4f6f8", "#11161d", "#ffff00")
    readonly property color quiet: pick("#bcc8d6", "#333f4f", "#e6e65a")
    readonly property color accent: pick("#ffd166", "#0b3f91", "#ffffff")
    readonly property color accentText: pick("#14181d", "#ffffff", "#000000")
    readonly property color accentPressed: pick("#e0b450", "#082c66", "#d0d0d0")
    readonly property color line: pick("#8fdcff", "#00508f", "#7fffff")
    readonly property color finger: pick("#ff9eb0", "#8c0030", "#ffb0ff")

    readonly property real textSize: 18 * textScale
    readonly property real smallSize: 16 * textScale
    readonly property real headingSize: 22 * textScale
    readonly property real bigSize: 46 * textScale

    readonly property real target: Math.max(64, 48 * textScale)
    readonly property real gap: 12
    readonly property real radius: 10
    readonly property real ring: 3
}
