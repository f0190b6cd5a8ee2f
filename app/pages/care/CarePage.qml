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
    readonly property string help: qsTr("Tab goes from control to control, the arrow keys from photograph to photograph, Return opens one. Control Z undoes the last step, Control Shift Z redoes it. Escape stops what plays, and ends a recording and keeps it.")
    readonly property bool photoShown: session.photoOpen

    focus: true

    Keys.onPressed: (event) => {
        event.accepted = true
        if (event.key === Qt.Key_Z && event.modifiers === Qt.ControlModifier)
            session.undo()
        else if ((event.key === Qt.Key_Z && event.modifiers === (Qt.ControlModifier | Qt.ShiftModifier))
                 || (event.key === Qt.Key_Y && event.modifiers === Qt.ControlModifier))
            session.redo()
        else if (event.key === Qt.Key_Escape)
            event.accepted = session.stop()
        else
            event.accepted = false
    }
    // Back in the list, or in the photograph that has come back: the keyboard is never left on what is hidden.
    onPhotoShownChanged: {
        giveFocus()
        if (!page.activeFocus)
            return
        if (photoShown)
            photoPane.focusFirst()
        else
            listPane.focusRow()
    }

    // To the part that is seen, for when the keyboard comes to the page.
    function giveFocus() {
        if (!wide)
            (photoShown ? photoPane : listPane).focus = true
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
        visible: page.wide || !page.session.photoOpen
        enabled: !page.session.choosing
        focus: true
        session: page.session
        onPhotosAsked: photosDialog.open()
        onFolderAsked: page.session.importFolder()
        onOpened: photoPane.focusFirst()
    }
    PhotoPane {
        id: photoPane
        anchors { right: parent.right; top: parent.top; bottom: parent.bottom; margins: 2 * Theme.gap }
        width: page.wide ? page.width - listPane.width - 7 * Theme.gap : page.width - 4 * Theme.gap
        visible: page.wide || page.session.photoOpen
        enabled: !page.session.choosing
        session: page.session
        onSoundsAsked: soundsDialog.open()
    }

    // Choosing a folder takes the place of everything else for as long as it lasts.
    Rectangle {
        anchors.fill: parent
        visible: page.session.choosing
        color: Theme.ground
        MouseArea { anchors.fill: parent }
        Loader {
            anchors.fill: parent
            active: page.session.choosing
            sourceComponent: TpScroll {
                margin: 2 * Theme.gap
                FolderChooserView {
                    width: parent.width
                    focus: true
                    chooser: page.session.chooser
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
