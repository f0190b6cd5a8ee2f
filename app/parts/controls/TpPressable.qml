// SPDX-License-Identifier: Apache-2.0
import QtQuick

// What is pressed like a button but is none: a control of Qt keeps its own role in Qt 6.4, whatever is set.
Item {
    id: pressable

    readonly property bool down: area.held
    signal clicked

    opacity: enabled ? 1 : 0.45
    activeFocusOnTab: true
    Accessible.focusable: true
    Accessible.onPressAction: if (pressable.enabled) pressable.clicked()
    Keys.onSpacePressed: (event) => { if (!event.isAutoRepeat) pressable.clicked() }
    Keys.onReturnPressed: pressable.clicked()
    Keys.onEnterPressed: pressable.clicked()

    // A MouseArea of Qt 6.4 loses the second of two taps that follow each other soon.
    MultiPointTouchArea {
        id: area
        property bool held: false
        anchors.fill: parent
        maximumTouchPoints: 1
        onPressed: {
            pressable.forceActiveFocus(Qt.MouseFocusReason)
            held = true
        }
        onReleased: (points) => {
            held = false
            if (contains(Qt.point(points[0].x, points[0].y)))
                pressable.clicked()
        }
        onCanceled: held = false
    }
}
