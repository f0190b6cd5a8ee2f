// SPDX-License-Identifier: Apache-2.0
import QtQuick
import QtQuick.Templates as T

// On or off. `on` is what the program says, `switched` what a person wants: it comes however the switch was thrown,
// since a screen reader's toggle in Qt 6.4 changes `checked` without `toggled` or `clicked`.
T.Switch {
    id: control

    property bool on: false
    readonly property real thick: Math.round(32 * Math.min(1.5, Theme.textScale))
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

    contentItem: Item {
        PlainText {
            id: label
            // As wide as the control and not as its content, which is laid out while the height is set: a binding loop.
            width: control.width - 2 * control.padding
            text: control.text
            rightPadding: control.mirrored ? 0 : control.indicator.width + 16
            leftPadding: control.mirrored ? control.indicator.width + 16 : 0
            anchors.verticalCenter: parent.verticalCenter
            font.pixelSize: Theme.textSize
            color: Theme.text
            wrapMode: Text.Wrap
            Accessible.ignored: true
        }
    }
    indicator: Rectangle {
        x: control.mirrored ? control.padding : control.width - width - control.padding
        y: (control.height - height) / 2
        width: 2 * control.thick - 4
        height: control.thick
        radius: 0.5 * height
        color: control.checked ? Theme.accent : Theme.ground
        border.width: 2
        border.color: control.checked ? Theme.accent : Theme.edge
        Rectangle {
            x: control.checked !== control.mirrored ? parent.width - width - 5 : 5
            anchors.verticalCenter: parent.verticalCenter
            width: control.thick - 10
            height: width
            radius: 0.5 * width
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
