// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls

// One end of the part that stays: dragged, moved by arrow keys (0.1 s, with Shift 1 s), or by a screen reader. `setting`
// is what the program says, `chosen` what a person wants.
Item {
    id: handle

    required property string label
    required property string valueText
    required property bool atBegin // else at the end
    required property real setting // s
    required property real duration // s
    property real value: setting
    readonly property real minimumValue: 0
    readonly property real maximumValue: duration
    readonly property real stepSize: 0.1
    signal chosen(real seconds)
    signal dragged(real x) // in the parent, of the line

    width: Theme.target
    activeFocusOnTab: true
    onSettingChanged: value = setting
    onValueChanged: {
        if (Math.abs(value - setting) > 1e-6) {
            chosen(value)
            value = setting
        }
    }

    Accessible.role: Accessible.Slider
    Accessible.name: label
    Accessible.description: valueText
    Accessible.focusable: true
    Accessible.onIncreaseAction: handle.chosen(handle.setting + handle.stepSize)
    Accessible.onDecreaseAction: handle.chosen(handle.setting - handle.stepSize)

    Keys.onPressed: (event) => {
        const step = event.modifiers & Qt.ShiftModifier ? 1.0 : handle.stepSize
        event.accepted = true
        switch (event.key) {
        case Qt.Key_Left:
        case Qt.Key_Down: handle.chosen(handle.setting - step); break
        case Qt.Key_Right:
        case Qt.Key_Up: handle.chosen(handle.setting + step); break
        case Qt.Key_Home: handle.chosen(0); break
        case Qt.Key_End: handle.chosen(handle.duration); break
        default: event.accepted = false
        }
    }

    Rectangle { // the line itself
        x: handle.atBegin ? parent.width - width : 0
        width: 4
        height: parent.height
        color: Theme.accent
    }
    Rectangle { // what is taken hold of
        x: handle.atBegin ? parent.width - width : 0
        anchors.verticalCenter: parent.verticalCenter
        width: 0.6 * parent.width
        height: 0.7 * Theme.target
        radius: Theme.radius
        color: area.pressed ? Theme.accentPressed : Theme.accent
        PlainText {
            anchors.centerIn: parent
            text: handle.atBegin ? "⟩" : "⟨"
            font.pixelSize: Theme.headingSize
            color: Theme.accentText
            Accessible.ignored: true
        }
    }
    MouseArea {
        id: area
        property real held: 0
        anchors.fill: parent
        preventStealing: true
        onPressed: (mouse) => {
            handle.forceActiveFocus(Qt.MouseFocusReason)
            held = mouse.x - (handle.atBegin ? handle.width : 0)
        }
        onPositionChanged: (mouse) => {
            if (pressed)
                handle.dragged(handle.mapToItem(handle.parent, mouse.x - held, 0).x)
        }
    }
    FocusRing { target: handle }
}
