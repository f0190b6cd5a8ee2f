// SPDX-License-Identifier: Apache-2.0
import QtQuick

// One of a few, all in sight. `current` is what the program says, `picked` what a person wants.
Column {
    id: choice

    property string label: ""
    property var options: [] // of words
    property int current: -1
    signal picked(int index)

    spacing: 6
    Accessible.role: Accessible.Grouping // without a name: each option has the label in its own, and Orca would say it twice

    PlainText {
        width: parent.width
        visible: text !== ""
        text: choice.label
        font.pixelSize: Theme.smallSize
        color: Theme.quiet
        wrapMode: Text.Wrap
        Accessible.ignored: true
    }
    Flow {
        id: flow
        width: parent.width
        spacing: 8
        Repeater {
            model: choice.options
            delegate: TpPressable {
                id: option
                required property int index
                required property string modelData
                readonly property bool chosen: choice.current === index

                width: Math.min(implicitWidth, flow.width)
                implicitWidth: Math.max(Theme.target, Math.ceil(metrics.advanceWidth) + 2 * Theme.gap + 2)
                implicitHeight: Math.max(Theme.target, label.implicitHeight + 2 * Theme.gap)
                onClicked: choice.picked(index)

                Accessible.role: Accessible.RadioButton
                Accessible.name: choice.label === "" ? modelData : qsTr("%1: %2").arg(choice.label).arg(modelData)
                Accessible.checkable: true
                Accessible.checked: chosen
                Accessible.onToggleAction: if (option.enabled) option.clicked()

                Rectangle {
                    anchors.fill: parent
                    radius: Theme.radius
                    color: option.down ? Theme.pressed : Theme.raised
                    border.width: option.chosen ? 3 : 1
                    border.color: option.chosen ? Theme.accent : Theme.edge
                    FocusRing { target: option }
                }
                TextMetrics { // a wrapped Text's own implicit width follows the width that is made of it
                    id: metrics
                    font: label.font
                    text: label.text
                }
                PlainText {
                    id: label
                    anchors { fill: parent; margins: Theme.gap }
                    text: (option.chosen ? "● " : "○ ") + option.modelData
                    font.pixelSize: Theme.textSize
                    font.bold: option.chosen
                    color: Theme.text
                    horizontalAlignment: Text.AlignHCenter
                    verticalAlignment: Text.AlignVCenter
                    wrapMode: Text.Wrap
                    Accessible.ignored: true
                }
            }
        }
    }
}
