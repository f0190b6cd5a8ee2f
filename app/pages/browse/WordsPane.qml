// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Browse

// What is known of the photograph: where in the list it is, the summary, the detail one has gone to, what is heard.
Column {
    id: words

    required property BrowseSession session
    readonly property bool ready: session.album.state === BrowseAlbum.Ready
    spacing: 0.5 * Theme.gap

    Item {
        width: parent.width
        height: Math.max(heading.implicitHeight, place.implicitHeight)
        TpHeading {
            id: heading
            anchors.left: parent.left
            width: parent.width - (place.visible ? place.width + Theme.gap : 0)
            text: words.session.trail.title
        }
        TpStatus {
            id: place
            anchors { right: parent.right; baseline: heading.baseline }
            visible: words.ready
            label: qsTr("Photograph")
            text: words.session.trail.placeText
            color: Theme.quiet
        }
    }
    TpStatus {
        width: parent.width
        visible: !words.ready
        text: words.session.album.emptyText
    }
    TpStatus {
        width: parent.width
        visible: words.ready
        text: words.session.details.summary
        font.bold: true
    }
    TpStatus {
        width: parent.width
        visible: words.ready && text !== words.session.details.summary
        label: qsTr("Detail")
        text: words.session.details.detail
        color: Theme.accent
    }
    TpStatus {
        width: parent.width
        visible: text !== ""
        text: words.session.playback.notice
        color: Theme.finger
    }
    TpProgress {
        width: parent.width
        visible: words.session.playback.heard !== ""
        label: words.session.playback.heard
        fraction: words.session.playback.heardValue
    }
    TpProgress {
        width: parent.width
        visible: words.session.album.scanning
        label: words.session.album.scanText
        fraction: words.session.album.scanValue
    }
}
