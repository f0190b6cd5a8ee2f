// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Care

// Taking the last step back, and doing it again; each button says what it is about.
FocusScope {
    id: bar

    required property CareHistory history
    readonly property bool holdsSteps: history.undoText !== "" || history.redoText !== ""

    implicitHeight: flow.height
    height: implicitHeight
    visible: holdsSteps

    // The keyboard is never left on a button that is gone: what was undone can be done again.
    function keepFocus() {
        const on_one = (undo.activeFocus && undo.visible) || (redo.activeFocus && redo.visible)
        if (bar.activeFocus && !on_one)
            (redo.visible ? redo : undo).forceActiveFocus()
    }
    Connections {
        target: bar.history
        function onChanged() { Qt.callLater(bar.keepFocus) }
    }

    Flow {
        id: flow
        width: parent.width
        spacing: Theme.gap

        TpButton {
            id: undo
            objectName: "undo"
            visible: bar.history.undoText !== ""
            width: Math.min(implicitWidth, flow.width)
            text: qsTr("Undo: %1").arg(bar.history.undoText)
            hint: qsTr("Key: Control+Z")
            onClicked: bar.history.undo()
        }
        TpButton {
            id: redo
            objectName: "redo"
            visible: bar.history.redoText !== ""
            width: Math.min(implicitWidth, flow.width)
            text: qsTr("Redo: %1").arg(bar.history.redoText)
            hint: qsTr("Key: Control+Shift+Z")
            onClicked: bar.history.redo()
        }
    }
}
