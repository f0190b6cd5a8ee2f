// SPDX-License-Identifier: Apache-2.0
import QtQuick
import QtQuick.Layouts
import TouchPhoto.Controls
import TouchPhoto.Browse

// Everything that a key or a gesture does, as buttons. None comes, goes or is greyed out, so that each keeps its place.
Column {
    id: buttons

    required property BrowseSession session
    readonly property bool ready: session.album.state === BrowseAlbum.Ready
    readonly property int columns: width < 270 * Theme.textScale ? 1 : 2

    // Side by side, equally wide and high.
    component Pairs: GridLayout {
        width: parent.width
        columns: buttons.columns
        columnSpacing: buttons.spacing
        rowSpacing: buttons.spacing
        visible: buttons.ready
    }
    component Half: TpButton {
        Layout.fillWidth: true
        Layout.fillHeight: true
        Layout.preferredWidth: 1
    }
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
        text: buttons.session.playback.playing ? qsTr("Pause") : qsTr("Play recordings")
        hint: qsTr("On the detail of a recording: only that one. Key: Enter")
        onClicked: buttons.session.playback.play()
    }
    Pairs {
        Half {
            text: qsTr("Previous")
            hint: qsTr("Photograph. Key: left arrow")
            onClicked: buttons.session.trail.previous()
        }
        Half {
            text: qsTr("Next")
            hint: qsTr("Photograph. Key: right arrow")
            onClicked: buttons.session.trail.next()
        }
        Half {
            text: qsTr("Previous detail")
            hint: qsTr("Key: up arrow")
            onClicked: buttons.session.details.previous()
        }
        Half {
            text: qsTr("Next detail")
            hint: qsTr("People, recordings, descriptions, place and time. Key: down arrow")
            onClicked: buttons.session.details.next()
        }
    }
    TpButton {
        width: parent.width
        visible: buttons.ready
        text: qsTr("Feel the face")
        hint: qsTr("Key: E")
        onClicked: buttons.session.askExplore()
    }
    Pairs {
        Half {
            text: qsTr("Back")
            hint: qsTr("To the previous list. Key: Backspace")
            onClicked: buttons.session.lists.back()
        }
        Half {
            text: qsTr("All photographs")
            hint: qsTr("Key: A")
            onClicked: buttons.session.lists.allPhotos()
        }
        Half {
            text: qsTr("Search")
            hint: qsTr("Key: S")
            onClicked: buttons.session.lists.openSearch()
        }
        Half {
            text: qsTr("Surprise me")
            hint: qsTr("A random photograph. Key: R")
            onClicked: buttons.session.trail.surprise()
        }
        Half {
            text: qsTr("People")
            hint: qsTr("Key: P")
            onClicked: buttons.session.lists.openTopic(BrowseLists.People)
        }
        Half {
            text: qsTr("Years")
            hint: qsTr("Key: Y")
            onClicked: buttons.session.lists.openTopic(BrowseLists.Years)
        }
        Half {
            text: qsTr("Places")
            hint: qsTr("Key: L")
            onClicked: buttons.session.lists.openTopic(BrowseLists.Places)
        }
        Half {
            text: qsTr("Keywords")
            hint: qsTr("Key: K")
            onClicked: buttons.session.lists.openTopic(BrowseLists.Keywords)
        }
        Half {
            text: qsTr("Slower")
            hint: qsTr("%1. Key: minus").arg(buttons.session.playback.speedText)
            onClicked: buttons.session.playback.slower()
        }
        Half {
            text: qsTr("Faster")
            hint: qsTr("%1. Key: plus").arg(buttons.session.playback.speedText)
            onClicked: buttons.session.playback.faster()
        }
        Half {
            text: qsTr("Where am I?")
            hint: qsTr("Key: W")
            onClicked: buttons.session.whereAmI()
        }
        Half {
            text: qsTr("Look after it")
            hint: qsTr("Names, recordings and descriptions of this photograph. Key: C")
            onClicked: buttons.session.askCare()
        }
    }
}
