// SPDX-License-Identifier: Apache-2.0
import QtQuick
import QtQuick.Templates as T

// A number within bounds. `setting` is what the program says, `chosen` what a person wants, by hand, key or screen
// reader (which in Qt 6.4 sets `value` without `moved`, and reads its bounds from minimumValue and maximumValue).
T.Slider {
    id: control

    property string label: ""
    property string valueText: ""
    property real setting: from
    readonly property real minimumValue: from
    readonly property real maximumValue: to
    signal chosen(real value)

    implicitWidth: 200
    implicitHeight: Math.max(Theme.target, Math.max(caption.implicitHeight, reading.implicitHeight) + 40)
    leftPadding: Theme.gap
    rightPadding: Theme.gap
    snapMode: T.Slider.SnapAlways

    onSettingChanged: value = setting
    onValueChanged: if (Math.abs(value - setting) > 1e-9) chosen(value)
    Component.onCompleted: value = setting

    Accessible.role: Accessible.Slider
    Accessible.name: label
    Accessible.description: valueText
    Accessible.onIncreaseAction: control.increase()
    Accessible.onDecreaseAction: control.decrease()

    background: Rectangle {
        radius: Theme.radius
        color: Theme.raised
        border.width: 1
        border.color: Theme.edge
        PlainText {
            id: caption
            anchors { left: parent.left; right: reading.left; top: parent.top; margins: 10; leftMargin: Theme.gap }
            text: control.label
            font.pixelSize: Theme.smallSize
            color: Theme.text
            wrapMode: Text.Wrap
            Accessible.ignored: true
        }
        PlainText {
            id: reading
            anchors { right: parent.right; top: parent.top; margins: 10; rightMargin: Theme.gap }
            width: Math.min(Math.ceil(metrics.advanceWidth) + 2, 0.5 * parent.width - Theme.gap) // half is the label's
            text: control.valueText
            font.pixelSize: Theme.smallSize
            color: Theme.quiet
            horizontalAlignment: Text.AlignRight
            wrapMode: Text.Wrap
            Accessible.ignored: true
        }
        TextMetrics { // a wrapped Text's own implicit width follows the width that is made of it
            id: metrics
            font: reading.font
            text: reading.text
        }
        Rectangle {
            x: control.leftPadding
            anchors { bottom: parent.bottom; bottomMargin: 18 }
            width: control.availableWidth
            height: 6
            radius: 3
            color: Theme.ground
            Rectangle {
                anchors.left: parent.left
                width: control.position * parent.width
                height: parent.height
                radius: 3
                color: Theme.accent
            }
        }
        FocusRing { target: control }
    }
    handle: Rectangle {
        x: control.leftPadding + control.visualPosition * (control.availableWidth - width)
        y: control.height - 21 - height / 2
        width: 24
        height: 24
        radius: 12
        color: Theme.text
        border.width: 2
        border.color: Theme.ground
    }
}
