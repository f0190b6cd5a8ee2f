// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Mend

// Words and buttons: everything that a hand can drag on the surface, and the rest.
TpScroll {
    id: panel

    required property MendSession session
    readonly property bool ready: session.state === MendSession.Ready
    readonly property bool there: ready && session.featureThere
    readonly property real half: (width - spacing) / 2

    TpHeading {
        width: parent.width
        text: panel.session.photoName === "" ? qsTr("Mend contours") : panel.session.photoName
        elide: Text.ElideMiddle
        wrapMode: Text.NoWrap
    }
    Row {
        spacing: panel.spacing
        TpButton {
            width: panel.half
            primary: panel.session.unsaved
            enabled: panel.session.unsaved
            text: qsTr("Save")
            hint: qsTr("Leaving this page saves too. Key: Control+S")
            onClicked: panel.session.save()
        }
        TpButton {
            width: panel.half
            enabled: panel.session.canUndo
            text: qsTr("Undo")
            hint: qsTr("Key: Control+Z")
            onClicked: panel.session.undo()
        }
    }
    TpChoice {
        width: parent.width
        visible: panel.ready
        label: qsTr("Feature")
        options: panel.session.features
        current: panel.session.feature
        onPicked: (index) => panel.session.chooseFeature(index)
    }
    TpStatus {
        width: parent.width
        visible: panel.ready && panel.session.featureName !== ""
        label: qsTr("In hand")
        text: !panel.session.featureThere ? qsTr("%1: not there").arg(panel.session.featureName)
            : panel.session.handle < 0 ? panel.session.featureName
            : qsTr("%1 of the %2: %3").arg(panel.session.handleName).arg(panel.session.featureName).arg(panel.session.handlePlace)
        color: Theme.accent
    }
    Row {
        spacing: panel.spacing
        visible: panel.there
        TpButton {
            width: panel.half
            text: qsTr("Previous point")
            hint: qsTr("Key: Shift+Tab on the photograph")
            onClicked: if (!panel.session.stepHandle(-1)) panel.session.stepHandle(-1)
        }
        TpButton {
            width: panel.half
            text: qsTr("Next point")
            hint: qsTr("Key: Tab on the photograph")
            onClicked: if (!panel.session.stepHandle(1)) panel.session.stepHandle(1)
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
                onClicked: panel.session.nudge(modelData.x, modelData.y)
            }
        }
    }
    TpToggle {
        width: parent.width
        visible: panel.there
        text: qsTr("Move the whole feature")
        on: panel.session.wholeFeature
        onSwitched: (on) => panel.session.wholeFeature = on
    }
    Row {
        spacing: panel.spacing
        visible: panel.there
        TpButton {
            width: panel.half
            text: qsTr("Add a point")
            hint: qsTr("Behind the one in hand. Key: A. Or double-click beside a line")
            onClicked: panel.session.addPoint()
        }
        TpButton {
            width: panel.half
            enabled: panel.session.handle >= 0
            text: qsTr("Delete the point")
            hint: qsTr("Key: Delete")
            onClicked: panel.session.deletePoint()
        }
    }
    TpButton {
        width: parent.width
        visible: panel.there
        enabled: panel.session.handleTurns
        text: panel.session.handleIsCorner ? qsTr("Make it smooth") : qsTr("Make it a corner")
        hint: qsTr("Key: C")
        onClicked: panel.session.turnCorner()
    }
    Row {
        spacing: panel.spacing
        visible: panel.there
        TpButton {
            width: panel.half
            enabled: panel.session.featureMended
            text: qsTr("As it was found")
            hint: qsTr("Takes back what was done to this feature alone")
            onClicked: panel.session.resetFeature()
        }
        TpButton {
            width: panel.half
            text: qsTr("Remove the feature")
            hint: qsTr("It will not be felt")
            onClicked: panel.session.removeFeature()
        }
    }
    TpButton {
        width: parent.width
        visible: panel.ready && !panel.session.featureThere && panel.session.featureName !== ""
        primary: true
        text: qsTr("Add the %1").arg(panel.session.featureName)
        onClicked: panel.session.addFeature()
    }
    Row {
        spacing: panel.spacing
        visible: panel.ready
        TpButton {
            width: panel.half
            text: qsTr("Larger")
            hint: qsTr("Key: Plus")
            onClicked: panel.session.zoomBy(1.5)
        }
        TpButton {
            width: panel.half
            text: qsTr("Smaller")
            hint: qsTr("Key: Minus")
            onClicked: panel.session.zoomBy(1 / 1.5)
        }
    }
    Row {
        spacing: panel.spacing
        visible: panel.ready
        TpButton {
            width: panel.half
            text: qsTr("Whole photograph")
            hint: qsTr("Key: 0")
            onClicked: panel.session.showAll()
        }
        TpButton {
            width: panel.half
            text: qsTr("This feature")
            hint: qsTr("Fits it into view. Key: Z")
            onClicked: panel.session.showFeature()
        }
    }
    TpToggle {
        width: parent.width
        visible: panel.ready
        text: qsTr("Show the force")
        on: panel.session.forceShown
        onSwitched: (on) => panel.session.forceShown = on
    }
    TpStatus {
        width: parent.width
        visible: panel.ready && text !== ""
        label: qsTr("What is felt")
        text: panel.session.change
        color: Theme.quiet
    }
    Row {
        spacing: panel.spacing
        visible: panel.ready
        TpButton {
            width: panel.half
            enabled: panel.session.canRedo
            text: qsTr("Do again")
            hint: qsTr("Key: Control+Shift+Z")
            onClicked: panel.session.redo()
        }
        TpButton {
            width: panel.half
            text: qsTr("Add a face")
            hint: qsTr("One of usual shape, to be put in place")
            onClicked: panel.session.addFace()
        }
    }
    TpButton {
        width: parent.width
        visible: panel.ready
        enabled: panel.session.canDiscard
        text: qsTr("Discard all changes")
        hint: qsTr("The contours as they were opened. Can be undone")
        onClicked: panel.session.discard()
    }
    TpText {
        width: parent.width
        visible: panel.ready
        text: qsTr("Keys on the photograph: Tab and Shift+Tab go from point to point; arrows move it by one pixel, with Shift by ten, with Control by a fifth; Page up and Page down change the feature; A adds a point, Delete deletes it, C turns a corner, M moves the whole feature, F shows the force, plus and minus zoom, 0 shows all, Z this feature, W says where one is.")
        font.pixelSize: Theme.smallSize
        color: Theme.quiet
    }
}
