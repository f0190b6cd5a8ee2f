// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Care

// The photographs of the album. Tab comes to one row, the arrow keys go from row to row.
FocusScope {
    id: pane

    required property CareSession session
    readonly property Item focused: Window.activeFocusItem
    readonly property real inset: 2 * Theme.ring // room for the ring round what has the keyboard
    property int row: 0 // that Tab comes to; the list's own current item would take the keyboard whenever rows change
    property bool keepFocus: false
    signal photosAsked
    signal folderAsked
    signal opened

    function focusRow() {
        if (list.count === 0) {
            list.headerItem.focusFirst()
            return
        }
        pane.row = Math.max(0, Math.min(pane.row, list.count - 1))
        list.positionViewAtIndex(pane.row, ListView.Contain)
        list.forceLayout()
        list.itemAtIndex(pane.row).focusRow()
    }

    // What the keyboard comes to above the rows is brought into view; when it has come to rest, for a list that moves lets
    // go of rows, and with a row that was just taken away the keyboard moves once more.
    onFocusedChanged: Qt.callLater(pane.showFocused)
    function showFocused() {
        for (let item = focused; item; item = item.parent)
            if (item === list.headerItem) {
                const top = focused.mapToItem(list.contentItem, 0, 0).y
                const wanted = Math.max(Math.min(list.contentY, top - Theme.gap),
                                        top + focused.height + Theme.gap - list.height)
                list.contentY = Math.max(list.originY - pane.inset, wanted)
                return
            }
    }

    Connections {
        target: pane.session.photos
        function onModelAboutToBeReset() {
            pane.keepFocus = pane.keepFocus || (list.activeFocus && !list.headerItem.activeFocus)
        }
        function onModelReset() { Qt.callLater(pane.settle) } // when the list has its new rows
    }
    function settle() {
        const open = pane.session.photoRow
        pane.row = open >= 0 ? open : Math.max(0, Math.min(pane.row, list.count - 1))
        if (pane.keepFocus && pane.activeFocus) // nobody has opened a photograph meanwhile
            pane.focusRow()
        pane.keepFocus = false
    }

    ListView {
        id: list
        objectName: "photoList"
        anchors.fill: parent
        spacing: Theme.gap
        clip: true
        leftMargin: pane.inset
        rightMargin: pane.inset
        topMargin: pane.inset
        bottomMargin: pane.inset
        focus: true
        boundsBehavior: Flickable.StopAtBounds
        currentIndex: -1
        model: pane.session.photos
        cacheBuffer: 400
        // Who comes to the page comes to its first control.
        onActiveFocusChanged: if (activeFocus && !pane.keepFocus && Window.activeFocusItem === list) list.headerItem.focusFirst()
        Keys.onUpPressed: (event) => event.accepted = step(-1)
        Keys.onDownPressed: (event) => event.accepted = step(1)
        Keys.onPressed: (event) => {
            if (list.headerItem.activeFocus)
                return
            const page = Math.max(1, Math.floor(list.height / (2 * Theme.target)))
            switch (event.key) {
            case Qt.Key_Home: event.accepted = step(-list.count); break
            case Qt.Key_End: event.accepted = step(list.count); break
            case Qt.Key_PageUp: event.accepted = step(-page); break
            case Qt.Key_PageDown: event.accepted = step(page); break
            }
        }
        function step(by) {
            if (list.headerItem.activeFocus || list.count === 0)
                return false
            pane.row = Math.max(0, Math.min(pane.row + by, list.count - 1))
            pane.focusRow()
            return true
        }

        header: FocusScope {
            width: list.width - 2 * pane.inset
            height: above.height + Theme.gap
            function focusFirst() { importPart.firstControl.forceActiveFocus() }

            Column {
                id: above
                width: parent.width
                spacing: Theme.gap

                TpHeading {
                    width: parent.width
                    text: qsTr("Photographs of the album")
                }
                ImportPart {
                    id: importPart
                    width: parent.width
                    importing: pane.session.importing
                    onPhotosAsked: pane.photosAsked()
                    onFolderAsked: pane.folderAsked()
                }
                UndoBar {
                    width: parent.width
                    history: pane.session.history
                    visible: !pane.session.photoOpen && holdsSteps
                }
                TpButton {
                    objectName: "people"
                    anchors.left: parent.left
                    visible: pane.session.photos.total > 0 && pane.session.groups.on
                    width: Math.min(implicitWidth, parent.width)
                    text: qsTr("People…")
                    hint: qsTr("Says once who somebody is, for all photographs.")
                    onClicked: pane.session.groups.show()
                }
                TpChoice {
                    width: parent.width
                    visible: pane.session.photos.total > 0
                    label: qsTr("Order")
                    options: [qsTr("Newest first"), qsTr("Check these first")]
                    current: pane.session.photos.order
                    onPicked: (index) => pane.session.photos.order = index
                }
                TpStatus {
                    width: parent.width
                    visible: pane.session.photos.leftToJudge > 0
                    text: qsTr("Checking faces, %n photograph(s) left…", "", pane.session.photos.leftToJudge)
                    color: Theme.quiet
                }
                TpText {
                    width: parent.width
                    visible: pane.session.photos.total === 0
                    text: pane.session.folders.hasFolders ? qsTr("There are no photographs in the album yet.")
                                                  : qsTr("The album has no folder yet. You will be asked for one when you import.")
                }
            }
        }

        delegate: FocusScope {
            id: item
            required property int index
            required property string name
            required property string detail
            required property var picture

            width: list.width - 2 * pane.inset
            height: row.height
            function focusRow() { row.forceActiveFocus() }
            onIndexChanged: if (row.activeFocus) pane.row = index // it was moved

            PictureItem {
                id: thumbnail
                width: Theme.target
                height: Theme.target
                anchors { left: parent.left; verticalCenter: row.verticalCenter }
                fill: PictureItem.Cover
                picture: item.picture
                Accessible.ignored: true
                MouseArea {
                    anchors.fill: parent
                    onClicked: row.clicked()
                }
            }
            TpListRow {
                id: row
                anchors { left: thumbnail.right; leftMargin: Theme.gap; right: parent.right }
                height: Math.max(implicitHeight, thumbnail.height)
                focus: true
                activeFocusOnTab: item.index === pane.row || activeFocus
                text: item.name
                detail: item.detail
                position: item.index + 1
                count: pane.session.photos.total
                selected: pane.session.photoOpen && pane.session.photoRow === item.index
                onActiveFocusChanged: if (activeFocus) pane.row = item.index
                onClicked: {
                    pane.row = item.index
                    pane.session.openRow(item.index)
                    pane.opened()
                }
            }
        }
    }
}
