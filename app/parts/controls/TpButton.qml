// SPDX-License-Identifier: Apache-2.0
import QtQuick
import QtQuick.Templates as T

// A button whose action reaches every hand: mouse, touch, Space, Enter, and a screen reader's press, which a plain
// Button of Qt 6.4 acknowledges and forgets.
T.Button {
    id: control

    property bool primary: false
    property bool large: false // one of the few things that a page is for
    property string hint: ""

    implicitWidth: Math.max(Theme.target, Math.ceil(metrics.advanceWidth) + 2 * padding + 2)
    implicitHeight: Math.max(Theme.target, label.implicitHeight + 2 * padding)
    padding: Theme.gap
    opacity: enabled ? 1 : 0.45

    Accessible.role: Accessible.Button
    Accessible.name: enabled ? text : qsTr("%1, not available").arg(text) // Qt 6.4 tells no other way
    Accessible.description: hint
    Accessible.onPressAction: if (control.enabled) control.clicked()
    Keys.onReturnPressed: control.clicked()
    Keys.onEnterPressed: control.clicked()

    TextMetrics { // a wrapped Text's own implicit width follows the width that is made of it
        id: metrics
        font: label.font
        text: label.text
    }

    contentItem: PlainText {
        id: label
        text: control.text
        font.pixelSize: control.large ? 1.2 * Theme.headingSize : Theme.textSize
        font.bold: control.primary
        color: control.primary ? Theme.accentText : Theme.text
        horizontalAlignment: Text.AlignHCenter
        verticalAlignment: Text.AlignVCenter
        wrapMode: Text.Wrap
        Accessible.ignored: true
    }
    background: Rectangle {
        radius: Theme.radius
        color: control.primary ? (control.down ? Theme.accentPressed : Theme.accent)
                               : (control.down ? Theme.pressed : Theme.raised)
        border.width: control.primary ? 0 : 1
        border.color: Theme.edge
        FocusRing { target: control }
    }
}
