// SPDX-License-Identifier: Apache-2.0
import QtQuick

// Letters to spell with: a finger goes over them, hears each, and is lifted on the one it wants, as on the keyboards of
// screen readers. One Tab stop for them all, the arrow keys go from one to the next; a screen reader has a button for each.
Item {
    id: board

    property string label: ""
    property var letters: []
    property int current: 0
    readonly property real cell: Theme.target
    readonly property int columns: Math.max(1, Math.floor((width + 6) / (cell + 6)))
    signal reached(int letter) // a finger or the keyboard has come to it
    signal chosen(int letter)

    implicitHeight: Math.ceil(letters.length / columns) * (cell + 6) - 6
    activeFocusOnTab: letters.length > 0 || activeFocus // Qt lets no item leave the order while it has the keyboard
    Accessible.role: Accessible.Grouping
    Accessible.name: label
    Accessible.focusable: true
    Accessible.onPressAction: board.chosen(board.current)
    onLettersChanged: current = Math.max(0, Math.min(current, letters.length - 1))

    function columnAt(column) { return Theme.mirrored ? columns - 1 - column : column }
    function at(x, y) {
        const column = columnAt(Math.floor(x / (cell + 6))), letter = Math.floor(y / (cell + 6)) * columns + column
        return x >= 0 && y >= 0 && column >= 0 && column < columns && letter < letters.length ? letter : -1
    }
    function go(letter) {
        if (letter < 0 || letter >= letters.length)
            return
        current = letter
        reached(letter)
    }
    Keys.onPressed: (event) => {
        event.accepted = true
        switch (event.key) {
        case Qt.Key_Left: board.go(board.current - (Theme.mirrored ? -1 : 1)); break
        case Qt.Key_Right: board.go(board.current + (Theme.mirrored ? -1 : 1)); break
        case Qt.Key_Up: board.current >= board.columns ? board.go(board.current - board.columns) : event.accepted = false; break
        case Qt.Key_Down: board.current + board.columns < board.letters.length ? board.go(board.current + board.columns)
                                                                              : event.accepted = false; break
        case Qt.Key_Space:
        case Qt.Key_Return:
        case Qt.Key_Enter: board.chosen(board.current); break
        default: event.accepted = false
        }
    }

    Repeater {
        model: board.letters
        delegate: Rectangle {
            id: key
            required property int index
            required property string modelData
            readonly property bool under: area.held && area.letter === index

            x: board.columnAt(index % board.columns) * (board.cell + 6)
            y: Math.floor(index / board.columns) * (board.cell + 6)
            width: board.cell
            height: board.cell
            radius: Theme.radius
            color: under ? Theme.accent : Theme.raised
            border.width: board.activeFocus && board.current === index ? 3 : 1
            border.color: board.activeFocus && board.current === index ? Theme.accent : Theme.edge
            Accessible.role: Accessible.Button
            Accessible.name: modelData
            Accessible.onPressAction: board.chosen(index)
            PlainText {
                anchors.centerIn: parent
                text: key.modelData
                font.pixelSize: 1.4 * Theme.textSize
                font.bold: true
                color: key.under ? Theme.accentText : Theme.text
                Accessible.ignored: true
            }
        }
    }
    MultiPointTouchArea {
        id: area
        property bool held: false
        property int letter: -1
        anchors.fill: parent
        maximumTouchPoints: 1
        function follow(point) {
            const under = board.at(point.x, point.y)
            if (under !== letter && under >= 0)
                board.go(under)
            letter = under
        }
        onPressed: (points) => {
            board.forceActiveFocus(Qt.MouseFocusReason)
            held = true
            letter = -1
            follow(points[0])
        }
        onUpdated: (points) => follow(points[0])
        onReleased: {
            held = false
            if (letter >= 0)
                board.chosen(letter)
        }
        onCanceled: held = false
        onGestureStarted: (gesture) => gesture.grab() // from a column that scrolls
    }
    FocusRing { target: board }
}
