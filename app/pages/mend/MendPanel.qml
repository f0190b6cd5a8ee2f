// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Mend

// Words and buttons: everything that a hand can drag on the surface, and the rest.
TpScroll {
    id: panel

    required property MendSession session
    readonly property MendSelection selection: session.selection
    readonly property bool ready: session.photo.state === MendedPhoto.Ready
    readonly property bool there: ready && selection.featureThere
    readonly property real half: (width - spacing) / 2

    TpHeading {
        width: parent.width
        text: panel.session.photo.name === "" ? qsTr("Mend contours") : panel.session.photo.name
        elide: Text.ElideMiddle
        wrapMode: Text.NoWrap
    }
    Row {
        spacing: panel.spacing
        TpButton {
            width: panel.half
            primary: panel.session.file.unsaved
            enabled: panel.session.file.unsaved
            text: qsTr("Save")
            hint: qsTr("Leaving this page saves too. Key: Control+S")
            onClicked: panel.session.file.save()
        }
        TpButton {
            width: panel.half
            enabled: panel.session.history.canUndo
            text: qsTr("Undo")
            hint: qsTr("Key: Control+Z")
            onClicked: panel.session.history.undo()
        }
    }
    TpChoice {
        width: parent.width
        visible: panel.ready
        label: qsTr("Feature")
        options: panel.selection.features
        current: panel.selection.feature
        onPicked: (index) => panel.selection.chooseFeature(index)
    }
    TpStatus {
        width: parent.width
        visible: panel.ready && panel.selection.featureName !== ""
        label: qsTr("Selected")
        text: !panel.selection.featureThere ? qsTr("%1: missing").arg(panel.selection.featureName)
            : panel.selection.handle < 0 ? panel.selection.featureName
            : qsTr("%1 of the %2: %3").arg(panel.selection.handleName).arg(panel.selection.featureName).arg(panel.selection.handlePlace)
        color: Theme.accent
    }
    Row {
        spacing: panel.spacing
        visible: panel.there
        TpButton {
            width: panel.half
            text: qsTr("Previous point")
            hint: qsTr("Key: Shift+Tab on the photograph")
            onClicked: if (!panel.selection.stepHandle(-1)) panel.selection.stepHandle(-1)
        }
        TpButton {
            width: panel.half
            text: qsTr("Next point")
            hint: qsTr("Key: Tab on the photograph")
            onClicked: if (!panel.selection.stepHandle(1)) panel.selection.stepHandle(1)
        }
    }
    Grid {
        columns: 4
        spacing: 6
        visible: panel.there
        LayoutMirroring.enabled: false // they point to where they lie
        Repeater {
            model: [{ sign: "←", name: qsTr("Move left"), x: -1, y: 0 }, { sign: "→", name: qsTr("Move right"), x: 1, y: 0 },
                    { sign: "↑", name: qsTr("Move up"), x: 0, y: -1 }, { sign: "↓", name: qsTr("Move down"), x: 0, y: 1 }]
            delegate: TpButton {
                required property var modelData
                width: Math.floor((panel.width - 18) / 4)
                text: modelData.sign
                Accessible.name: modelData.name
                hint: qsTr("By one pixel of the photograph. Arrow keys: with Shift by ten, with Control by a fifth")
                autoRepeat: true
                onClicked: panel.session.editing.nudge(modelData.x, modelData.y)
            }
        }
    }
    TpToggle {
        width: parent.width
        visible: panel.there
        text: qsTr("Move the whole feature")
        on: panel.selection.wholeFeature
        onSwitched: (on) => panel.selection.wholeFeature = on
    }
    Row {
        spacing: panel.spacing
        visible: panel.there
        TpButton {
            width: panel.half
            text: qsTr("Add a point")
            hint: qsTr("After the selected one. Key: A. Or double-click beside a line")
            onClicked: panel.session.editing.addPoint()
        }
        TpButton {
            width: panel.half
            enabled: panel.selection.handle >= 0
            text: qsTr("Delete the point")
            hint: qsTr("Key: Delete")
            onClicked: panel.session.editing.deletePoint()
        }
    }
    TpButton {
        width: parent.width
        visible: panel.there
        enabled: panel.selection.handleTurns
        text: panel.selection.handleIsCorner ? qsTr("Make it smooth") : qsTr("Make it a corner")
        hint: qsTr("Key: C")
        onClicked: panel.session.editing.turnCorner()
    }
    Row {
        spacing: panel.spacing
        visible: panel.there
        TpButton {
            width: panel.half
            enabled: panel.selection.featureMended
            text: qsTr("Reset the feature")
            hint: qsTr("Undoes the changes to this feature only")
            onClicked: panel.session.editing.resetFeature()
        }
        TpButton {
            width: panel.half
            text: qsTr("Remove the feature")
            hint: qsTr("It will not be felt")
            onClicked: panel.session.editing.removeFeature()
        }
    }
    TpButton {
        width: parent.width
        visible: panel.ready && !panel.selection.featureThere && panel.selection.featureName !== ""
        primary: true
        text: qsTr("Add the %1").arg(panel.selection.featureName)
        onClicked: panel.session.editing.addFeature()
    }
    Row {
        spacing: panel.spacing
        visible: panel.ready
        TpButton {
            width: panel.half
            text: qsTr("Zoom in")
            hint: qsTr("Key: Plus")
            onClicked: panel.selection.zoomBy(1.5)
        }
        TpButton {
            width: panel.half
            text: qsTr("Zoom out")
            hint: qsTr("Key: Minus")
            onClicked: panel.selection.zoomBy(1 / 1.5)
        }
    }
    Row {
        spacing: panel.spacing
        visible: panel.ready
        TpButton {
            width: panel.half
            text: qsTr("Whole photograph")
            hint: qsTr("Key: 0")
            onClicked: panel.session.view.showAll()
        }
        TpButton {
            width: panel.half
            text: qsTr("This feature")
            hint: qsTr("Fits it into view. Key: Z")
            onClicked: panel.selection.fitIntoView()
        }
    }
    TpToggle {
        width: parent.width
        visible: panel.ready
        text: qsTr("Show the force")
        on: panel.session.preview.forceShown
        onSwitched: (on) => panel.session.preview.forceShown = on
    }
    TpStatus {
        width: parent.width
        visible: panel.ready && text !== ""
        label: qsTr("Shows what is felt")
        text: panel.session.preview.change
        color: Theme.quiet
    }
    Row {
        spacing: panel.spacing
        visible: panel.ready
        TpButton {
            width: panel.half
            enabled: panel.session.history.canRedo
            text: qsTr("Redo")
            hint: qsTr("Key: Control+Shift+Z")
            onClicked: panel.session.history.redo()
        }
        TpButton {
            width: panel.half
            text: qsTr("Add a face")
            hint: qsTr("One of the usual shape, for you to move into place")
            onClicked: panel.session.editing.addFace()
        }
    }
    TpButton {
        width: parent.width
        visible: panel.ready
        enabled: panel.session.file.canDiscard
        text: qsTr("Discard all changes")
        hint: qsTr("The contours as they were when opened. Can be undone")
        onClicked: panel.session.file.discard()
    }
    TpText {
        width: parent.width
        visible: panel.ready
        text: qsTr("Keys on the photograph: Tab and Shift+Tab go from point to point; arrow keys move it by one pixel, with Shift by ten, with Control by a fifth; Page Up and Page Down change the feature; A adds a point, Delete deletes it, C makes it a corner or smooth, M moves the whole feature, F shows the force, plus and minus zoom, 0 shows all, Z this feature, W says where you are.")
        font.pixelSize: Theme.smallSize
        color: Theme.quiet
    }
}
