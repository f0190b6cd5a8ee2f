// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Care

// Recording: what it will be, then the one button that begins and finishes it, a meter, pause, and throwing away.
FocusScope {
    id: part

    required property Take take
    required property RecordingList recordings
    readonly property bool running: take.running
    signal filesAsked

    implicitHeight: column.height
    onRunningChanged: if (activeFocus) focusRecord() // the other buttons come and go
    function focusRecord() { record.forceActiveFocus() }

    Column {
        id: column
        width: parent.width
        spacing: Theme.gap

        TpChoice {
            width: parent.width
            visible: !part.take.running
            label: qsTr("What to record")
            options: part.recordings.kinds
            current: part.take.kind
            onPicked: (index) => part.take.kind = index
        }
        Flow {
            width: parent.width
            spacing: Theme.gap
            TpButton {
                id: record
                objectName: "record"
                width: Math.min(implicitWidth, parent.width)
                primary: true
                focus: true
                text: part.take.running ? qsTr("Finish the recording") : qsTr("Record")
                onClicked: part.take.running ? part.take.finish() : part.take.start()
            }
            TpButton {
                objectName: "pause"
                visible: part.take.running && !part.take.asking
                width: Math.min(implicitWidth, parent.width)
                text: part.take.paused ? qsTr("Continue") : qsTr("Pause")
                onClicked: part.take.pauseOrGoOn()
            }
            TpButton {
                objectName: "discard"
                visible: part.take.running && !part.take.asking
                width: Math.min(implicitWidth, parent.width)
                text: qsTr("Discard…")
                onClicked: {
                    part.take.askDiscard()
                    keepIt.forceActiveFocus()
                }
            }
            TpButton {
                id: keepIt
                objectName: "keepIt"
                visible: part.take.asking
                width: Math.min(implicitWidth, parent.width)
                text: qsTr("Keep it")
                onClicked: {
                    part.take.keepOn()
                    part.focusRecord()
                }
            }
            TpButton {
                objectName: "throwAway"
                visible: part.take.asking
                width: Math.min(implicitWidth, parent.width)
                text: qsTr("Yes, discard it")
                onClicked: {
                    part.take.discard()
                    part.focusRecord()
                }
            }
            TpButton {
                objectName: "addSound"
                visible: !part.take.running
                width: Math.min(implicitWidth, parent.width)
                text: qsTr("Add a sound file…")
                onClicked: part.filesAsked()
            }
        }
        Rectangle {
            width: parent.width
            height: meter.height + 2 * Theme.gap
            visible: part.take.running
            color: Theme.panel
            radius: Theme.radius
            Column {
                id: meter
                x: Theme.gap
                y: Theme.gap
                width: parent.width - 2 * Theme.gap
                spacing: 8
                TpStatus {
                    width: parent.width
                    text: qsTr("%1 %2").arg(part.take.stateText).arg(part.take.time)
                    font.pixelSize: Theme.headingSize
                    font.bold: true
                    color: part.take.paused ? Theme.quiet : Theme.accent
                }
                TpProgress {
                    width: parent.width
                    label: qsTr("Loudness")
                    valueText: part.take.levelText
                    fraction: part.take.level
                }
            }
        }
    }
}
