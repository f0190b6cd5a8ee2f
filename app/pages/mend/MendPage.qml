// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Mend

// The photograph with its contours, and beside it (below it on a tall window) the words and the buttons.
FocusScope {
    id: page

    required property MendSession session
    readonly property bool wide: width > 1.15 * height
    readonly property string help: qsTr("Tab goes from point to point of the photograph's lines, Page Up and Page Down from feature to feature. Arrow keys move a point by one pixel, with Shift by ten, with Control by a fifth. A adds a point, Delete deletes it, C turns a corner into a smooth point. Control+Z undoes the last step, Control+S saves; leaving the page saves too.")
    readonly property real side: Math.min(360 * Theme.textScale, 0.5 * width)

    focus: true

    Keys.onPressed: (event) => {
        const control = event.modifiers & Qt.ControlModifier
        event.accepted = true
        if (control && event.key === Qt.Key_Z && event.modifiers & Qt.ShiftModifier || control && event.key === Qt.Key_Y)
            session.history.redo()
        else if (control && event.key === Qt.Key_Z)
            session.history.undo()
        else if (control && event.key === Qt.Key_S)
            session.file.save()
        else if (event.key === Qt.Key_Escape)
            event.accepted = session.drag.cancel()
        else
            event.accepted = false
    }

    Rectangle {
        anchors.fill: parent
        color: Theme.ground
    }
    MendSurface {
        objectName: "surface"
        session: page.session
        x: page.wide && Theme.mirrored ? page.side + 4 * Theme.gap : 2 * Theme.gap
        y: 2 * Theme.gap
        width: (page.wide ? page.width - page.side - 2 * Theme.gap : page.width) - 4 * Theme.gap
        height: (page.wide ? page.height : 0.52 * page.height) - 4 * Theme.gap
        focus: true
    }
    MendPanel {
        session: page.session
        x: page.wide && !Theme.mirrored ? page.width - page.side - 2 * Theme.gap : 2 * Theme.gap
        y: page.wide ? 2 * Theme.gap : 0.52 * page.height
        width: page.wide ? page.side : page.width - 4 * Theme.gap
        height: page.height - y - 2 * Theme.gap
    }
}
