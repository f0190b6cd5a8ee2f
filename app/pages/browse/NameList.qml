// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Browse

// Names, years, places or keywords to choose from, or the search with what it suggests and finds.
FocusScope {
    id: list

    required property BrowseSession session
    readonly property bool searching: session.trail.view === BrowseTrail.Search
    readonly property int count: session.lists.rows.length
    property int current: -1 // the row that the keyboard was on last
    property int lost: -1    // the row that the keyboard was on when the list was made anew

    // Where the keyboard begins: the field of a search, or the row that was chosen last.
    function focusFirst() {
        lost = -1
        if (searching && session.lists.chosenRow < 0)
            field.forceActiveFocus(Qt.OtherFocusReason)
        else
            stepTo(Math.max(0, session.lists.chosenRow))
    }
    function stepTo(index) {
        const row = rows.itemAt(index)
        if (row) {
            row.forceActiveFocus(Qt.OtherFocusReason)
        } else if (searching) {
            current = -1
            field.forceActiveFocus(Qt.OtherFocusReason)
        } else {
            backButton.forceActiveFocus(Qt.OtherFocusReason)
        }
    }
    function comeBack() {
        if (lost >= 0)
            stepTo(Math.min(lost, count - 1))
    }
    function step(by) { stepTo(Math.max(searching ? -1 : 0, Math.min(current + by, rows.count - 1))) }

    Connections {
        target: list.session.lists
        function onRowsChanged() {
            list.lost = list.activeFocus && !field.activeFocus && !letters.activeFocus ? list.current : -1
            list.current = list.session.lists.chosenRow
            if (list.lost >= 0)
                Qt.callLater(list.comeBack)
        }
    }

    TpHeading {
        id: heading
        anchors.left: parent.left
        width: parent.width - backButton.width - Theme.gap
        height: backButton.height
        verticalAlignment: Text.AlignVCenter
        text: list.session.trail.title
    }
    TpButton {
        id: backButton
        anchors.right: parent.right
        width: Math.max(140, implicitWidth)
        text: qsTr("Back")
        hint: qsTr("Key: Backspace")
        onClicked: list.session.lists.back()
    }
    TpTextField {
        id: field
        objectName: "field"
        anchors { top: backButton.bottom; topMargin: visible ? Theme.gap : 0 }
        width: parent.width
        height: visible ? implicitHeight : 0
        visible: list.searching
        label: qsTr("A name, a place or any word")
        setting: list.session.lists.typed
        onTyped: (text) => list.session.lists.type(text)
        onEntered: (text) => {
            list.session.lists.type(text)
            list.session.lists.tellFound()
        }
        Keys.onDownPressed: list.step(1)
    }
    TpStatus {
        id: found
        anchors { top: field.bottom; topMargin: Theme.gap }
        width: parent.width
        text: list.session.lists.found
        color: Theme.quiet
    }
    TpScroll {
        anchors { top: found.bottom; topMargin: Theme.gap; bottom: bar.top; bottomMargin: Theme.gap }
        width: parent.width

        TpLetters {
            id: letters
            objectName: "letters"
            width: parent.width
            visible: list.searching && letters.letters.length > 0
            label: qsTr("Letters to type with")
            letters: list.session.lists.letters
            onReached: (letter) => list.session.lists.reachLetter(letter)
            onChosen: (letter) => {
                list.session.lists.addLetter(letter)
                if (letters.letters.length === 0) // the keyboard is never left on what is gone
                    takeBack.forceActiveFocus(Qt.OtherFocusReason)
            }
        }
        TpButton {
            id: takeBack
            objectName: "takeLetterBack"
            visible: list.searching && list.session.lists.typed !== ""
            text: qsTr("Delete the last letter")
            onClicked: list.session.lists.takeLetterBack()
        }
        Repeater {
            id: rows
            model: list.session.lists.rows
            delegate: TpListRow {
                required property int index
                required property var modelData
                width: parent ? parent.width : 0
                text: modelData.text
                detail: modelData.detail
                position: index + 1
                count: list.count
                selected: index === list.session.lists.chosenRow
                onClicked: list.session.lists.choose(index)
                onActiveFocusChanged: {
                    if (!activeFocus)
                        return
                    list.current = index
                    list.session.lists.reach(index)
                }
            }
        }
    }

    // For a finger that does not see: where it goes from row to row and chooses, these stay.
    Row {
        id: bar
        anchors.bottom: parent.bottom
        width: parent.width
        height: list.count > 0 ? implicitHeight : 0
        visible: list.count > 0
        spacing: Theme.gap
        readonly property real third: (width - 2 * spacing) / 3

        TpButton {
            width: bar.third
            text: qsTr("Up")
            hint: qsTr("To the previous row. Key: up arrow")
            onClicked: list.stepTo(Math.max(0, list.current - 1))
        }
        TpButton {
            width: bar.third
            text: qsTr("Down")
            hint: qsTr("To the next row. Key: down arrow")
            onClicked: list.stepTo(Math.min(list.current + 1, list.count - 1))
        }
        TpButton {
            width: bar.third
            primary: true
            text: qsTr("Choose")
            hint: qsTr("The row read out last. Key: Enter")
            onClicked: list.session.lists.choose(list.current)
        }
    }
}
