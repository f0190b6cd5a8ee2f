// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Browse

// Names, years, places or keywords to choose from, or the search with what it suggests and finds.
FocusScope {
    id: list

    required property BrowseSession session
    readonly property bool searching: session.view === BrowseSession.Search
    readonly property int count: session.rows.length

    // Where the keyboard begins: the field of a search, or the row that was chosen last.
    function focusFirst() {
        if (searching && session.chosenRow < 0)
            field.forceActiveFocus(Qt.OtherFocusReason)
        else
            stepTo(Math.max(0, session.chosenRow))
    }
    function stepTo(index) {
        const row = rows.itemAt(index)
        if (row)
            row.forceActiveFocus(Qt.OtherFocusReason)
        else if (searching)
            field.forceActiveFocus(Qt.OtherFocusReason)
        else
            backButton.forceActiveFocus(Qt.OtherFocusReason)
    }
    function step(by) {
        let now = -1
        for (let i = 0; i < rows.count; ++i)
            if (rows.itemAt(i).activeFocus)
                now = i
        stepTo(Math.min(now + by, rows.count - 1))
    }

    TpHeading {
        id: heading
        width: parent.width - backButton.width - Theme.gap
        height: backButton.height
        verticalAlignment: Text.AlignVCenter
        text: list.session.title
    }
    TpButton {
        id: backButton
        anchors.right: parent.right
        text: qsTr("Back")
        hint: qsTr("Key: Backspace")
        onClicked: list.session.back()
    }
    TpTextField {
        id: field
        objectName: "field"
        anchors { top: backButton.bottom; topMargin: visible ? Theme.gap : 0 }
        width: parent.width
        height: visible ? implicitHeight : 0
        visible: list.searching
        label: qsTr("A name, a place or any word")
        setting: list.session.typed
        onTyped: (text) => list.session.type(text)
        onEntered: (text) => {
            list.session.type(text)
            list.session.tellFound()
        }
        Keys.onDownPressed: list.step(1)
    }
    TpStatus {
        id: found
        anchors { top: field.bottom; topMargin: Theme.gap }
        width: parent.width
        text: list.session.found
        color: Theme.quiet
    }
    TpScroll {
        anchors { top: found.bottom; topMargin: Theme.gap; bottom: parent.bottom }
        width: parent.width
        margin: 6

        Repeater {
            id: rows
            model: list.session.rows
            delegate: TpListRow {
                required property int index
                required property var modelData
                width: parent ? parent.width : 0
                text: modelData.text
                detail: modelData.detail
                position: index + 1
                count: list.count
                selected: index === list.session.chosenRow
                onClicked: list.session.choose(index)
                onActiveFocusChanged: if (activeFocus) list.session.reach(index)
            }
        }
    }
}
