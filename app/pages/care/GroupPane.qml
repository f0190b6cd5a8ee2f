// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Care

// One person of the album: who it is, and the faces that seem to be this person's.
FocusScope {
    id: pane

    required property CareSession session
    readonly property GroupCare groups: session.groups
    readonly property bool open: groups.row >= 0
    readonly property Item focused: Window.activeFocusItem
    readonly property real inset: 2 * Theme.ring // room for the ring round what has the keyboard
    property int row: 0 // of the faces, that Tab comes to
    property bool onRows: false // the keyboard is on one of them, or was when it went

    function focusFirst() { list.headerItem.focusFirst() }

    Keys.onPressed: (event) => {
        const face = onRows ? row : groups.selected
        if (event.key === Qt.Key_Delete && face >= 0)
            pane.groups.notThisPerson(face)
        else if (event.key === Qt.Key_Y && pane.groups.offer !== "")
            pane.groups.confirm()
        else
            event.accepted = false
    }
    Connections {
        target: pane.groups
        function onPersonChosen() {
            pane.row = 0
            pane.onRows = false
            list.headerItem.reset()
            if (pane.activeFocus && pane.open)
                pane.focusFirst()
        }
    }
    // The keyboard is never left on nothing: where a face has gone it comes to the one that stands there now. What it
    // comes to above the rows is brought into view.
    onFocusedChanged: Qt.callLater(pane.showFocused)
    function showFocused() {
        if ((focused === list && onRows) || focused === list.headerItem) {
            list.focusRow(row)
            return
        }
        for (let item = focused; item; item = item.parent)
            if (item === list.headerItem) {
                onRows = false
                const top = focused.mapToItem(list.contentItem, 0, 0).y
                const wanted = Math.max(Math.min(list.contentY, top - Theme.gap),
                                        top + focused.height + Theme.gap - list.height)
                list.contentY = Math.max(list.originY - pane.inset, wanted)
                return
            }
    }

    ListView {
        id: list
        objectName: "personFaces"
        anchors.fill: parent
        visible: pane.open
        focus: true
        spacing: Theme.gap
        clip: true
        leftMargin: pane.inset
        rightMargin: pane.inset
        topMargin: pane.inset
        bottomMargin: pane.inset
        boundsBehavior: Flickable.StopAtBounds
        cacheBuffer: 0 // Qt 6.4 warns where rows go that are still being made
        currentIndex: -1
        model: pane.groups.faces
        onActiveFocusChanged: if (activeFocus && Window.activeFocusItem === list) pane.focusFirst()
        Keys.onUpPressed: (event) => event.accepted = step(-1)
        Keys.onDownPressed: (event) => event.accepted = step(1)
        function step(by) {
            if (list.headerItem.activeFocus || list.count === 0)
                return false
            focusRow(pane.row + by)
            return true
        }
        function focusRow(wanted) {
            if (list.count === 0) {
                pane.focusFirst()
                return
            }
            pane.row = Math.max(0, Math.min(wanted, list.count - 1))
            list.positionViewAtIndex(pane.row, ListView.Contain)
            list.forceLayout()
            list.itemAtIndex(pane.row).focusRow()
        }

        header: FocusScope {
            width: list.width - 2 * pane.inset
            height: above.height + Theme.gap
            // To what most people want next: saying yes, else saying who it is.
            function focusFirst() { (yes.visible ? yes : nameField).forceActiveFocus() }
            function reset() { nameField.reset(pane.groups.name) }

            Column {
                id: above
                width: parent.width
                spacing: Theme.gap

                TpButton {
                    objectName: "backToPeople"
                    anchors.left: parent.left
                    width: Math.min(implicitWidth, parent.width)
                    text: qsTr("Back to the people")
                    onClicked: pane.groups.choose(-1)
                }
                TpHeading {
                    width: parent.width
                    text: pane.groups.title
                    wrapMode: Text.Wrap
                }
                TpStatus {
                    width: parent.width
                    text: pane.groups.details
                }
                TpButton {
                    id: yes
                    objectName: "yes"
                    anchors.left: parent.left
                    visible: pane.groups.offer !== ""
                    width: Math.min(implicitWidth, parent.width)
                    text: qsTr("Yes, this is %1").arg(pane.groups.offer)
                    hint: qsTr("Names all of these faces. Key: Y")
                    onClicked: pane.groups.confirm()
                }
                NameField {
                    id: nameField
                    objectName: "personName"
                    width: parent.width
                    label: qsTr("Name")
                    suggest: (typed) => pane.groups.suggestions(typed)
                    onChosen: (name) => pane.groups.nameAll(name)
                }
                UndoBar {
                    width: parent.width
                    history: pane.session.history
                }
                TpHeading {
                    width: parent.width
                    text: qsTr("Faces")
                }
                Flow {
                    width: parent.width
                    spacing: Theme.gap
                    TpButton {
                        objectName: "notThisPerson"
                        width: Math.min(implicitWidth, parent.width)
                        enabled: pane.groups.selected >= 0
                        text: qsTr("Not this person")
                        hint: qsTr("For the face that was chosen below. Key: Delete")
                        onClicked: pane.groups.notThisPerson(pane.groups.selected)
                    }
                    TpButton {
                        objectName: "openPhoto"
                        width: Math.min(implicitWidth, parent.width)
                        enabled: pane.groups.selected >= 0
                        text: qsTr("Open the photograph")
                        onClicked: pane.groups.openPhoto()
                    }
                }
            }
            // In a small window no row is in view, and one that is not there could not be come to.
            Item {
                activeFocusOnTab: !pane.onRows && list.count > 0
                Accessible.ignored: true
                onActiveFocusChanged: if (activeFocus) list.focusRow(pane.row)
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

            PictureItem {
                id: crop
                width: 1.5 * Theme.target
                height: 1.5 * Theme.target
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
                anchors { left: crop.right; leftMargin: Theme.gap; right: parent.right }
                height: Math.max(implicitHeight, crop.height)
                focus: true
                activeFocusOnTab: item.index === pane.row || activeFocus
                text: item.name
                detail: item.detail
                position: item.index + 1
                count: list.count
                selected: pane.groups.selected === item.index
                onActiveFocusChanged: {
                    if (!activeFocus)
                        return
                    pane.row = item.index
                    pane.onRows = true
                }
                onClicked: pane.groups.select(item.index)
            }
        }
    }
    TpText {
        anchors.centerIn: parent
        width: parent.width - 8 * Theme.gap
        visible: !pane.open
        text: qsTr("Choose somebody to say who it is.")
        horizontalAlignment: Text.AlignHCenter
        color: Theme.quiet
        font.pixelSize: Theme.headingSize
    }
}
