// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Care

// Bringing photographs into the album: what to import, how far it is, what became of it.
Column {
    id: part

    required property ImportCare importing
    readonly property Item firstControl: first
    signal photosAsked
    signal folderAsked

    spacing: Theme.gap

    TpButton {
        id: first
        objectName: "importPhotos"
        width: parent.width
        primary: !part.importing.running
        // One button, so that the keyboard stays where it is when an import begins and ends.
        text: part.importing.running ? qsTr("Stop the import") : qsTr("Import photographs…")
        hint: part.importing.running ? "" : qsTr("Or drop them on this window.")
        onClicked: part.importing.running ? part.importing.stop() : part.photosAsked()
    }
    TpButton {
        objectName: "importFolder"
        width: parent.width
        text: qsTr("Import a folder…")
        onClicked: part.folderAsked()
    }
    TpChoice {
        width: parent.width
        visible: part.importing.folders.length > 1 && !part.importing.running
        label: qsTr("Import into")
        options: part.importing.folders
        current: part.importing.folder
        onPicked: (index) => part.importing.folder = index
    }
    TpProgress {
        width: parent.width
        visible: part.importing.running
        label: qsTr("Import")
        valueText: part.importing.progressText
        fraction: part.importing.fraction
    }
    TpStatus {
        width: parent.width
        visible: part.importing.report !== ""
        text: part.importing.report
    }
    Repeater {
        model: part.importing.problems
        delegate: TpText {
            required property string modelData
            width: part.width
            text: modelData
            font.pixelSize: Theme.smallSize
            color: Theme.quiet
        }
    }
    TpButton {
        width: parent.width
        visible: part.importing.unfinished
        text: qsTr("Continue the unfinished import")
        hint: part.importing.unfinishedText
        onClicked: {
            first.forceActiveFocus() // this one vanishes
            part.importing.goOn()
        }
    }
    TpButton {
        width: parent.width
        visible: part.importing.unfinished
        text: qsTr("Discard the unfinished import")
        hint: qsTr("What was imported stays.")
        onClicked: {
            first.forceActiveFocus()
            part.importing.giveUp()
        }
    }
}
