// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Browse

// Everything that a key or a gesture does, as buttons. None comes, goes or is greyed out, so that each keeps its place.
Column {
    id: buttons

    required property BrowseSession session
    readonly property bool ready: session.state === BrowseSession.Ready
    readonly property real half: Theme.textScale > 1.5 ? width : 0.5 * (width - spacing)
    spacing: Theme.gap

    TpButton {
        width: parent.width
        visible: !buttons.ready
        primary: true
        text: qsTr("Choose folders")
        hint: qsTr("On the settings page")
        onClicked: buttons.session.settingsAsked()
    }
    TpButton {
        width: parent.width
        visible: !buttons.ready
        text: qsTr("Import photographs")
        onClicked: buttons.session.importAsked()
    }
    TpButton {
        width: parent.width
        visible: buttons.ready
        primary: true
        text: buttons.session.playing ? qsTr("Pause") : qsTr("Play recordings")
        hint: qsTr("On the detail of a recording: that one alone. Key: Return")
        onClicked: buttons.session.play()
    }
    Flow {
        width: parent.width
        spacing: parent.spacing
        visible: buttons.ready

        TpButton {
            width: buttons.half
            text: qsTr("Previous")
            hint: qsTr("Photograph. Key: left arrow")
            onClicked: buttons.session.previous()
        }
        TpButton {
            width: buttons.half
            text: qsTr("Next")
            hint: qsTr("Photograph. Key: right arrow")
            onClicked: buttons.session.next()
        }
        TpButton {
            width: buttons.half
            text: qsTr("Detail before")
            hint: qsTr("Key: up arrow")
            onClicked: buttons.session.previousDetail()
        }
        TpButton {
            width: buttons.half
            text: qsTr("Next detail")
            hint: qsTr("People, recordings, descriptions, place and time. Key: down arrow")
            onClicked: buttons.session.nextDetail()
        }
    }
    TpButton {
        width: parent.width
        visible: buttons.ready
        text: qsTr("Feel the face")
        hint: qsTr("Key: E")
        onClicked: buttons.session.askExplore()
    }
    Flow {
        width: parent.width
        spacing: parent.spacing
        visible: buttons.ready

        TpButton {
            width: buttons.half
            text: qsTr("Back")
            hint: qsTr("To the list before. Key: Backspace")
            onClicked: buttons.session.back()
        }
        TpButton {
            width: buttons.half
            text: qsTr("All photographs")
            hint: qsTr("Key: A")
            onClicked: buttons.session.allPhotos()
        }
        TpButton {
            width: buttons.half
            text: qsTr("Search")
            hint: qsTr("Key: S")
            onClicked: buttons.session.openSearch()
        }
        TpButton {
            width: buttons.half
            text: qsTr("Surprise me")
            hint: qsTr("Any photograph. Key: R")
            onClicked: buttons.session.surprise()
        }
        TpButton {
            width: buttons.half
            text: qsTr("People")
            hint: qsTr("Key: P")
            onClicked: buttons.session.openTopic(BrowseSession.People)
        }
        TpButton {
            width: buttons.half
            text: qsTr("Years")
            hint: qsTr("Key: Y")
            onClicked: buttons.session.openTopic(BrowseSession.Years)
        }
        TpButton {
            width: buttons.half
            text: qsTr("Places")
            hint: qsTr("Key: L")
            onClicked: buttons.session.openTopic(BrowseSession.Places)
        }
        TpButton {
            width: buttons.half
            text: qsTr("Keywords")
            hint: qsTr("Key: K")
            onClicked: buttons.session.openTopic(BrowseSession.Keywords)
        }
        TpButton {
            width: buttons.half
            text: qsTr("Slower")
            hint: qsTr("%1. Key: minus").arg(buttons.session.speedText)
            onClicked: buttons.session.slower()
        }
        TpButton {
            width: buttons.half
            text: qsTr("Faster")
            hint: qsTr("%1. Key: plus").arg(buttons.session.speedText)
            onClicked: buttons.session.faster()
        }
        TpButton {
            width: buttons.half
            text: qsTr("Where am I?")
            hint: qsTr("Key: W")
            onClicked: buttons.session.whereAmI()
        }
        TpButton {
            width: buttons.half
            text: qsTr("Look after it")
            hint: qsTr("Names, recordings and descriptions of this photograph. Key: C")
            onClicked: buttons.session.askCare()
        }
    }
}
