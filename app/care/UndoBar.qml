// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Care

// Taking the last step back, and doing it again; each button says what it is about.
Flow {
    id: bar

    required property CareSession session

    spacing: Theme.gap
    visible: session.undoText !== "" || session.redoText !== ""

    TpButton {
        id: undo
        objectName: "undo"
        visible: bar.session.undoText !== ""
        width: Math.min(implicitWidth, bar.width)
        text: qsTr("Undo: %1").arg(bar.session.undoText)
        hint: qsTr("Key: Control Z")
        onClicked: bar.session.undo()
    }
    TpButton {
        id: redo
        objectName: "redo"
        visible: bar.session.redoText !== ""
        width: Math.min(implicitWidth, bar.width)
        text: qsTr("Do again: %1").arg(bar.session.redoText)
        hint: qsTr("Key: Control Shift Z")
        onClicked: bar.session.redo()
    }
}
