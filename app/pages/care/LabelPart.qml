// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Care

// What the chosen recording says of itself.
Column {
    id: part

    required property RecordingList recordings
    required property var people // (typed) => names
    spacing: Theme.gap

    TpChoice {
        width: parent.width
        label: qsTr("Kind")
        options: part.recordings.kinds
        current: part.recordings.kind
        onPicked: (index) => part.recordings.setKind(index)
    }
    NameField {
        width: parent.width
        label: qsTr("Who it is about")
        suggest: part.people
        initial: part.recordings.person
        none: qsTr("About nobody in particular")
        onChosen: (name) => part.recordings.setPerson(name)
    }
    NameField {
        width: parent.width
        label: qsTr("Who speaks")
        suggest: part.people
        initial: part.recordings.speaker
        none: qsTr("Speaker not given")
        onChosen: (name) => part.recordings.setSpeaker(name)
    }
    TpChoice {
        width: parent.width
        label: qsTr("Language")
        options: part.recordings.languageNames
        current: part.recordings.language
        onPicked: (index) => part.recordings.setLanguage(index)
    }
}
