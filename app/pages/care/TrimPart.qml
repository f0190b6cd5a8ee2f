// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Care

// The chosen recording as a drawing of its loudness, with a handle at each end of what stays.
Column {
    id: part

    required property Trimming trimming
    spacing: Theme.gap

    Item {
        id: track
        width: parent.width
        height: 2 * Theme.target
        readonly property real inset: Theme.target // room for the handles, which lie outside of what stays
        readonly property real span: width - 2 * inset
        readonly property real duration: Math.max(part.trimming.duration, 1e-3)
        function xOf(seconds) { return inset + span * seconds / duration }
        function secondsAt(x) { return Math.round(10 * duration * (x - inset) / span) / 10 }

        Rectangle {
            anchors.fill: parent
            color: Theme.panel
            radius: Theme.radius
        }
        WaveformItem {
            x: track.inset
            y: 8
            width: track.span
            height: parent.height - 16
            peaks: part.trimming.peaks
            from: part.trimming.begin / track.duration
            to: part.trimming.end / track.duration
            color: Theme.line
            dimColor: Theme.edge
            Accessible.ignored: true
        }
        MouseArea { // the nearer end comes to where one taps: for who cannot drag
            anchors.fill: parent
            onClicked: (mouse) => {
                const seconds = track.secondsAt(mouse.x)
                if (Math.abs(seconds - part.trimming.begin) < Math.abs(seconds - part.trimming.end))
                    part.trimming.setBegin(seconds)
                else
                    part.trimming.setEnd(seconds)
            }
        }
        Rectangle { // where it plays
            visible: part.trimming.playing
            x: track.xOf(part.trimming.position) - 1
            width: 3
            height: parent.height
            color: Theme.finger
        }
        TrimHandle {
            objectName: "trimBegin"
            atBegin: true
            x: track.xOf(part.trimming.begin) - width
            height: parent.height
            label: qsTr("Start of the part to keep")
            valueText: part.trimming.beginText
            setting: part.trimming.begin
            duration: part.trimming.duration
            onChosen: (seconds) => part.trimming.setBegin(seconds)
            onDragged: (x) => part.trimming.setBegin(track.secondsAt(x))
        }
        TrimHandle {
            objectName: "trimEnd"
            atBegin: false
            x: track.xOf(part.trimming.end)
            height: parent.height
            label: qsTr("End of the part to keep")
            valueText: part.trimming.endText
            setting: part.trimming.end
            duration: part.trimming.duration
            onChosen: (seconds) => part.trimming.setEnd(seconds)
            onDragged: (x) => part.trimming.setEnd(track.secondsAt(x))
        }
    }
    TpStatus {
        width: parent.width
        text: part.trimming.staysText
        color: Theme.quiet
    }
    Flow {
        width: parent.width
        spacing: Theme.gap
        TpButton {
            objectName: "listenPart"
            width: Math.min(implicitWidth, parent.width)
            text: part.trimming.playing ? qsTr("Stop") : qsTr("Play the part to keep")
            onClicked: part.trimming.playPartOrStop()
        }
        TpButton {
            objectName: "cut"
            width: Math.min(implicitWidth, parent.width)
            text: qsTr("Trim to this part")
            hint: qsTr("The rest can be brought back with Undo.")
            onClicked: part.trimming.cut()
        }
        TpButton {
            width: Math.min(implicitWidth, parent.width)
            text: qsTr("Keep all of it")
            onClicked: part.trimming.whole()
        }
    }
}
