// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Folders
import TouchPhoto.Care

// The page: on a wide window the photographs at the left and the care of one at the right; on a tall one, one after the
// other.
FocusScope {
    id: page

    required property CareSession session
    readonly property bool wide: width > 1.15 * height && width > 900 * Theme.textScale
    readonly property string help: peopleShown
        ? qsTr("Each row is a person. Tab moves from control to control, the arrow keys from row to row, Enter opens one. Type who it is, or press Y where a name is offered. On a face, Delete says that it is somebody else's. Control+Z undoes the last step. Escape leads back.")
        : qsTr("Tab moves from control to control, the arrow keys from photograph to photograph, Enter opens one. Control+Z undoes the last step, Control+Shift+Z redoes it. Escape stops playback; it also ends a recording and keeps it.")
    readonly property bool photoShown: session.photoOpen
    readonly property bool peopleShown: session.groups.shown
    readonly property bool personShown: peopleShown && session.groups.row >= 0
    // What is seen of it: in a narrow window one pane.
    readonly property Item list: peopleShown ? groupListPane : listPane
    readonly property Item one: peopleShown ? groupPane : photoPane
    readonly property bool oneShown: peopleShown ? personShown : photoShown

    focus: true

    Keys.onPressed: (event) => {
        event.accepted = true
        if (event.key === Qt.Key_Z && event.modifiers === Qt.ControlModifier)
            session.history.undo()
        else if ((event.key === Qt.Key_Z && event.modifiers === (Qt.ControlModifier | Qt.ShiftModifier))
                 || (event.key === Qt.Key_Y && event.modifiers === Qt.ControlModifier))
            session.history.redo()
        else if (event.key === Qt.Key_Escape)
            event.accepted = session.stop()
        else
            event.accepted = false
    }
    // Back in the list, or in the photograph that has come back: the keyboard is never left on what is hidden. Later,
    // because until then some of the bindings tell of the panes before.
    onOneShownChanged: Qt.callLater(page.moveFocus)
    onPeopleShownChanged: {
        page.peopleBegin = peopleShown
        Qt.callLater(page.moveFocus)
    }
    property bool peopleBegin: false // they were opened just now
    function moveFocus() {
        const first = peopleBegin
        peopleBegin = false
        giveFocus()
        if (!page.activeFocus)
            return
        if (oneShown)
            one.focusFirst()
        else if (first)
            list.focusFirst()
        else
            list.focusRow()
    }

    // To the part that is seen, for when the keyboard comes to the page.
    function giveFocus() {
        if (peopleShown || !wide || groupListPane.focus || groupPane.focus)
            (oneShown ? one : list).focus = true
    }
    onWideChanged: giveFocus()
    Component.onCompleted: giveFocus()

    Rectangle {
        anchors.fill: parent
        color: Theme.ground
    }
    PhotoListPane {
        id: listPane
        anchors { left: parent.left; top: parent.top; bottom: parent.bottom; margins: 2 * Theme.gap - inset }
        width: Math.round(page.wide ? 0.38 * page.width : page.width - 4 * Theme.gap) + 2 * inset
        visible: !page.peopleShown && (page.wide || !page.session.photoOpen)
        enabled: !page.session.folders.choosing
        focus: true
        session: page.session
        onPhotosAsked: photosDialog.open()
        onFolderAsked: page.session.folders.importFolder()
        onOpened: photoPane.focusFirst()
    }
    PhotoPane {
        id: photoPane
        anchors { right: parent.right; top: parent.top; bottom: parent.bottom; margins: 2 * Theme.gap }
        width: page.wide ? page.width - listPane.width - 7 * Theme.gap : page.width - 4 * Theme.gap
        visible: !page.peopleShown && (page.wide || page.session.photoOpen)
        enabled: !page.session.folders.choosing
        session: page.session
        onSoundsAsked: soundsDialog.open()
    }
    GroupListPane {
        id: groupListPane
        anchors.fill: listPane
        visible: page.peopleShown && (page.wide || !page.personShown)
        session: page.session
        onOpened: groupPane.focusFirst()
    }
    GroupPane {
        id: groupPane
        anchors.fill: photoPane
        visible: page.peopleShown && (page.wide || page.personShown)
        session: page.session
    }

    // Choosing a folder takes the place of everything else for as long as it lasts.
    Rectangle {
        anchors.fill: parent
        visible: page.session.folders.choosing
        color: Theme.ground
        MouseArea { anchors.fill: parent }
        Loader {
            anchors.fill: parent
            active: page.session.folders.choosing
            sourceComponent: TpScroll {
                margin: 2 * Theme.gap
                FolderChooserView {
                    width: parent.width
                    focus: true
                    chooser: page.session.folders.chooser
                }
            }
            onLoaded: item.forceActiveFocus()
            onActiveChanged: if (!active) listPane.forceActiveFocus()
        }
    }
    DropArea {
        anchors.fill: parent
        onDropped: (drop) => {
            if (drop.hasUrls)
                page.session.importing.import(drop.urls)
        }
    }
    DialogLoader {
        id: photosDialog
        objectName: "photosDialog"
        session: page.session
        file: "PhotosDialog.qml"
        onChosen: (files) => page.session.importing.import(files)
    }
    DialogLoader {
        id: soundsDialog
        objectName: "soundsDialog"
        session: page.session
        file: "SoundsDialog.qml"
        onChosen: (files) => page.session.recordings.addFiles(files, page.session.take.kind)
    }
}
