// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Care

// The people of the album, by their faces. Tab comes to one row, the arrow keys go from row to row.
FocusScope {
    id: pane

    required property CareSession session
    readonly property GroupCare groups: session.groups
    readonly property real inset: 2 * Theme.ring // room for the ring round what has the keyboard
    property int row: 0 // that Tab comes to
    property int comesFrom: -1 // the row of who was open, until the keyboard is back
    signal opened

    function focusFirst() { back.forceActiveFocus() }
    function focusRow() {
        if (list.count === 0) {
            focusFirst()
            return
        }
        pane.row = Math.max(0, Math.min(comesFrom < 0 ? pane.row : comesFrom, list.count - 1))
        comesFrom = -1
        list.positionViewAtIndex(pane.row, ListView.Contain)
        list.forceLayout()
        list.itemAtIndex(pane.row).focusRow()
    }

    Connections {
        target: pane.groups
        function onPersonChosen() {
            if (pane.groups.row >= 0)
                pane.comesFrom = pane.groups.row
        }
    }
    Column {
        id: above
        anchors { left: parent.left; right: parent.right; top: parent.top; margins: pane.inset }
        spacing: Theme.gap

        TpButton {
            id: back
            objectName: "backToPhotos"
            anchors.left: parent.left
            focus: true
            width: Math.min(implicitWidth, parent.width)
            text: qsTr("Back to the photographs")
            onClicked: pane.groups.hide()
        }
        TpHeading {
            width: parent.width
            text: qsTr("People")
        }
        TpStatus {
            objectName: "peopleSummary"
            width: parent.width
            text: pane.groups.summary
        }
        UndoBar {
            width: parent.width
            history: pane.session.history
            visible: pane.groups.row < 0 && holdsSteps
        }
    }
    ListView {
        id: list
        objectName: "peopleList"
        anchors { left: parent.left; right: parent.right; top: above.bottom; bottom: parent.bottom; topMargin: Theme.gap }
        spacing: Theme.gap
        clip: true
        leftMargin: pane.inset
        rightMargin: pane.inset
        topMargin: pane.inset
        bottomMargin: pane.inset
        boundsBehavior: Flickable.StopAtBounds
        cacheBuffer: 0 // Qt 6.4 warns where rows go that are still being made
        currentIndex: -1
        model: pane.groups.rows
        Keys.onUpPressed: (event) => event.accepted = step(-1)
        Keys.onDownPressed: (event) => event.accepted = step(1)
        Keys.onPressed: (event) => {
            const page = Math.max(1, Math.floor(list.height / (2 * Theme.target)))
            switch (event.key) {
            case Qt.Key_Home: event.accepted = step(-list.count); break
            case Qt.Key_End: event.accepted = step(list.count); break
            case Qt.Key_PageUp: event.accepted = step(-page); break
            case Qt.Key_PageDown: event.accepted = step(page); break
            }
        }
        function step(by) {
            if (list.count === 0)
                return false
            pane.row = Math.max(0, Math.min(pane.row + by, list.count - 1))
            pane.comesFrom = -1
            pane.focusRow()
            return true
        }

        delegate: FocusScope {
            id: item
            required property int index
            required property string name
            required property string detail
            required property var first
            required property var second
            required property var third
            readonly property real cropsWidth: 0.5 * width

            width: list.width - 2 * pane.inset
            height: row.height
            function focusRow() { row.forceActiveFocus() }
            onIndexChanged: if (row.activeFocus) pane.row = index // one above has gone

            Row {
                id: crops
                anchors { left: parent.left; verticalCenter: row.verticalCenter }
                component Crop: PictureItem {
                    property int place: 0
                    visible: (place + 1) * Theme.target <= item.cropsWidth
                    width: Theme.target
                    height: Theme.target
                    fill: PictureItem.Cover
                    Accessible.ignored: true
                    MouseArea {
                        anchors.fill: parent
                        onClicked: row.clicked()
                    }
                }
                Crop { picture: item.first }
                Crop { place: 1; picture: item.second }
                Crop { place: 2; picture: item.third }
            }
            TpListRow {
                id: row
                anchors { left: crops.right; leftMargin: Theme.gap; right: parent.right }
                height: Math.max(implicitHeight, crops.height)
                focus: true
                activeFocusOnTab: item.index === pane.row || activeFocus
                text: item.name
                detail: item.detail
                position: item.index + 1
                count: list.count
                selected: pane.groups.row === item.index
                onActiveFocusChanged: if (activeFocus) pane.row = item.index
                onClicked: {
                    pane.row = item.index
                    pane.groups.choose(item.index)
                    pane.opened()
                }
            }
        }
    }
}
