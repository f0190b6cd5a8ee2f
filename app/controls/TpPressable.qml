// SPDX-License-Identifier: Apache-2.0
import QtQuick

// What is pressed like a button but is none: a control of Qt keeps its own role in Qt 6.4, whatever is set.
Item {
    id: pressable

    readonly property bool down: area.pressed && area.containsMouse
    signal clicked

    opacity: enabled ? 1 : 0.45
    activeFocusOnTab: true
    Accessible.focusable: true
    Accessible.onPressAction: if (pressable.enabled) pressable.clicked()
    Keys.onSpacePressed: (event) => { if (!event.isAutoRepeat) pressable.clicked() }
    Keys.onReturnPressed: pressable.clicked()
    Keys.onEnterPressed: pressable.clicked()

    MouseArea {
        id: area
        anchors.fill: parent
        onPressed: pressable.forceActiveFocus(Qt.MouseFocusReason)
        onClicked: pressable.clicked()
    }
}
