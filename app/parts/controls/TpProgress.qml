// SPDX-License-Identifier: Apache-2.0
import QtQuick

// How far long work is, 0–1, with words; below 0: nobody knows yet. A screen reader has the words only: Qt 6.4 gives it
// no value of a progress bar.
Item {
    id: progress

    property string label: ""
    property string valueText: ""
    property real fraction: 0 // a "value" would be announced as one, which it is not

    implicitWidth: 200
    implicitHeight: words.implicitHeight + 22

    Accessible.role: Accessible.ProgressBar
    Accessible.name: valueText === "" ? label : label + ": " + valueText

    PlainText {
        id: words
        width: parent.width
        text: progress.valueText === "" ? progress.label : progress.label + ": " + progress.valueText
        font.pixelSize: Theme.smallSize
        color: Theme.text
        wrapMode: Text.Wrap
        Accessible.ignored: true
    }
    Rectangle {
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        height: 14
        radius: 7
        color: Theme.raised
        border.width: 1
        border.color: Theme.edge
        Rectangle {
            anchors.left: parent.left
            width: Math.max(parent.height, Math.min(1, progress.fraction) * parent.width)
            height: parent.height
            radius: parent.radius
            color: Theme.accent
            visible: progress.fraction >= 0
        }
    }
}
