// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Browse

// The page: a photograph with its words and buttons beside it (below it on a tall window), or a list to choose from.
FocusScope {
    id: page

    required property BrowseSession session
    readonly property string help: session.keys
    readonly property bool wide: width > 1.15 * height
    readonly property bool listing: session.trail.view !== BrowseTrail.Photos
    readonly property bool ready: session.album.state === BrowseAlbum.Ready

    focus: true

    function focusOnWhatIsShown() {
        if (listing)
            list.focusFirst()
        else
            pane.forceActiveFocus(Qt.OtherFocusReason)
    }
    onListingChanged: focusOnWhatIsShown()

    Connections {
        target: page.session.trail
        function onLevelChanged() { page.focusOnWhatIsShown() }
    }

    Keys.onPressed: (event) => {
        event.accepted = true
        switch (event.key) {
        case Qt.Key_Left: page.listing ? event.accepted = false : session.trail.previous(); break
        case Qt.Key_Right: page.listing ? event.accepted = false : session.trail.next(); break
        case Qt.Key_Up: page.listing ? list.step(-1) : session.details.previous(); break
        case Qt.Key_Down: page.listing ? list.step(1) : session.details.next(); break
        case Qt.Key_Home: page.listing ? list.stepTo(0) : session.trail.first(); break
        case Qt.Key_End: page.listing ? list.stepTo(list.count - 1) : session.trail.last(); break
        case Qt.Key_Return:
        case Qt.Key_Enter:
        case Qt.Key_Space: page.listing ? event.accepted = false : session.playback.play(); break
        case Qt.Key_Escape: event.accepted = session.stop(); break
        case Qt.Key_Plus:
        case Qt.Key_Equal: session.playback.faster(); break
        case Qt.Key_Minus: session.playback.slower(); break
        case Qt.Key_Backspace: session.lists.back(); break
        case Qt.Key_S: session.lists.openSearch(); break
        case Qt.Key_P: session.lists.openTopic(BrowseLists.People); break
        case Qt.Key_Y: session.lists.openTopic(BrowseLists.Years); break
        case Qt.Key_L: session.lists.openTopic(BrowseLists.Places); break
        case Qt.Key_K: session.lists.openTopic(BrowseLists.Keywords); break
        case Qt.Key_A: session.lists.allPhotos(); break
        case Qt.Key_R: session.trail.surprise(); break
        case Qt.Key_E: session.askExplore(); break
        case Qt.Key_C: session.askCare(); break
        case Qt.Key_W: session.whereAmI(); break
        case Qt.Key_H: session.tellKeys(); break
        default: event.accepted = false
        }
    }

    Rectangle {
        anchors.fill: parent
        color: Theme.ground
    }

    // The photograph and its words share a place of fixed size, so that the buttons stay where a hand expects them.
    Item {
        id: left
        visible: !page.listing && page.ready
        anchors { left: parent.left; leftMargin: 2 * Theme.gap }
        y: 2 * Theme.gap
        width: page.wide ? page.width - panel.width - 6 * Theme.gap : page.width - 4 * Theme.gap
        height: page.wide ? page.height - 4 * Theme.gap : 0.56 * page.height

        PhotoPane {
            id: pane
            objectName: "pane"
            session: page.session
            focus: true
            width: parent.width
            height: scroll.y - Theme.gap
        }
        TpScroll {
            id: scroll
            width: parent.width
            height: Math.min(words.implicitHeight, 0.55 * parent.height)
            y: parent.height - height - (keys.visible ? keys.height + Theme.gap : 0)

            WordsPane {
                id: words
                width: parent.width
                session: page.session
            }
        }
        BrowseKeys {
            id: keys
            visible: page.wide && implicitHeight < 0.12 * page.height
            anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        }
    }
    TpScroll {
        id: panel
        objectName: "panel"
        visible: !page.listing
        width: !page.ready ? Math.min(page.width - 4 * Theme.gap, 640 * Theme.textScale)
               : page.wide ? Math.min(380 * Theme.textScale, 0.45 * page.width) : page.width - 4 * Theme.gap
        anchors { right: parent.right; rightMargin: page.ready ? 2 * Theme.gap : 0.5 * (page.width - width) }
        y: page.wide || !page.ready ? 2 * Theme.gap : left.y + left.height + Theme.gap
        height: page.height - y - 2 * Theme.gap

        WordsPane {
            width: parent.width
            visible: !page.ready
            session: page.session
        }
        BrowseButtons {
            width: parent.width
            session: page.session
        }
    }

    NameList {
        id: list
        objectName: "list"
        session: page.session
        visible: page.listing
        width: Math.min(page.width - 4 * Theme.gap, 760 * Theme.textScale)
        anchors.horizontalCenter: parent.horizontalCenter
        y: 2 * Theme.gap
        height: page.height - 4 * Theme.gap
    }
}
