// SPDX-License-Identifier: Apache-2.0
import QtQuick
import QtQuick.Templates as T

// On or off. `on` is what the program says, `switched` what a person wants: it comes however the switch was thrown,
// since a screen reader's toggle in Qt 6.4 changes `checked` without `toggled` or `clicked`.
T.Switch {
    id: control

    property bool on: false
    signal switched(bool on)

    implicitWidth: Theme.target
    implicitHeight: Math.max(Theme.target, label.implicitHeight + 2 * padding)
    padding: Theme.gap

    onOnChanged: checked = on
    onCheckedChanged: if (checked !== on) switched(checked)
    Component.onCompleted: checked = on

    Accessible.role: Accessible.CheckBox
    Accessible.name: text
    Accessible.checkable: true
    Accessible.checked: checked
    Accessible.onPressAction: control.toggle()
    Accessible.onToggleAction: control.toggle()
    Keys.onReturnPressed: control.toggle()
    Keys.onEnterPressed: control.toggle()

    contentItem: Text {
        id: label
        text: control.text
        rightPadding: 76
        font.pixelSize: Theme.textSize
        color: Theme.text
        verticalAlignment: Text.AlignVCenter
        wrapMode: Text.WordWrap
        Accessible.ignored: true
    }
    indicator: Rectangle {
        x: control.width - width - control.padding
        y: (control.height - height) / 2
        width: 60
        height: 32
        radius: 16
        color: control.checked ? Theme.accent : Theme.ground
        border.width: 2
        border.color: control.checked ? Theme.accent : Theme.edge
        Rectangle {
            x: control.checked ? parent.width - width - 5 : 5
            anchors.verticalCenter: parent.verticalCenter
            width: 22
            height: 22
            radius: 11
            color: control.checked ? Theme.accentText : Theme.edge
        }
    }
    background: Rectangle {
        radius: Theme.radius
        color: Theme.raised
        border.width: 1
        border.color: Theme.edge
        FocusRing { target: control }
    }
}
