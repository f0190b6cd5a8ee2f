// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Care

// The recordings of the photograph: making one, the list, and what is done to the one that is chosen.
FocusScope {
    id: part

    required property CareSession session
    readonly property RecordingList recordings: session.recordings
    signal filesAsked

    implicitHeight: column.height

    Connections {
        target: part.recordings
        function onChanged() {
            // With the last recording the buttons under it are gone.
            if (part.recordings.count === 0 && part.activeFocus)
                takePart.focusRecord()
        }
    }

    Column {
        id: column
        width: parent.width
        spacing: Theme.gap

        TpHeading {
            width: parent.width
            text: qsTr("Recordings")
        }
        TakePart {
            id: takePart
            width: parent.width
            take: part.session.take
            recordings: part.recordings
            focus: true
            onFilesAsked: part.filesAsked()
        }
        TpText {
            width: parent.width
            visible: part.recordings.count === 0
            text: qsTr("No recordings yet.")
            color: Theme.quiet
        }
        Repeater {
            model: part.recordings.count
            delegate: TpListRow {
                required property int index
                readonly property var entry: part.recordings.rows[index] || {}

                width: column.width
                text: entry.text || ""
                detail: entry.detail || ""
                selected: entry.chosen === true
                position: index + 1
                count: part.recordings.count
                onClicked: part.recordings.choose(index)
            }
        }
        TpHeading {
            width: parent.width
            visible: part.recordings.chosen >= 0
            text: qsTr("Selected: %1").arg(part.recordings.chosenText)
            font.pixelSize: Theme.textSize
        }
        Flow {
            width: parent.width
            visible: part.recordings.chosen >= 0
            spacing: Theme.gap
            TpButton {
                objectName: "play"
                width: Math.min(implicitWidth, parent.width)
                text: part.session.trimming.playing ? qsTr("Stop playing") : qsTr("Play")
                onClicked: part.session.trimming.playOrStop()
            }
            TpButton {
                objectName: "earlier"
                width: Math.min(implicitWidth, parent.width)
                text: qsTr("Play earlier")
                hint: qsTr("Moves it up in the list.")
                onClicked: part.recordings.move(-1)
            }
            TpButton {
                objectName: "later"
                width: Math.min(implicitWidth, parent.width)
                text: qsTr("Play later")
                hint: qsTr("Moves it down in the list.")
                onClicked: part.recordings.move(1)
            }
            TpButton {
                objectName: "recordAgain"
                width: Math.min(implicitWidth, parent.width)
                text: qsTr("Record again")
                hint: qsTr("The old one goes to the trash when the new one is kept.")
                onClicked: {
                    part.session.take.startAgain()
                    takePart.focusRecord()
                }
            }
            TpButton {
                objectName: "label"
                width: Math.min(implicitWidth, parent.width)
                text: labels.open ? qsTr("Close the label") : qsTr("Label…")
                hint: qsTr("Kind, person, speaker and language.")
                onClicked: labels.open = !labels.open
            }
            TpButton {
                objectName: "delete"
                width: Math.min(implicitWidth, parent.width)
                text: qsTr("Delete the recording")
                hint: qsTr("Undo brings it back.")
                onClicked: part.recordings.remove()
            }
        }
        Loader {
            id: labels
            property bool open: false
            width: parent.width
            active: open && part.recordings.chosen >= 0
            visible: active
            sourceComponent: LabelPart {
                recordings: part.recordings
                people: (typed) => part.session.people.known(typed)
            }
        }
        TrimPart {
            width: parent.width
            visible: part.recordings.chosen >= 0
            trimming: part.session.trimming
        }
    }
}
