// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Lab

// The surface stays in sight; beside it (below it on a tall window) the plots and everything that can be turned.
FocusScope {
    id: page

    required property LabSession session
    readonly property string help: qsTr("On the surface, arrow keys move the hand and Space starts and stops the servo. R records, W says where the finger is, P reads out the plots, O opens a photograph, Control+Z undoes a change. Escape stops whatever is running.")
    readonly property bool wide: width > 1.15 * height
    readonly property bool plotsBeside: wide && Theme.textScale < 1.4 && height > 640
    readonly property real margin: 2 * Theme.gap

    function openDialog() {
        dialog.active = true
        if (dialog.item !== null)
            dialog.item.open()
    }

    Keys.onPressed: (event) => {
        event.accepted = true
        if (event.key === Qt.Key_Escape)
            event.accepted = session.stop()
        else if (event.key === Qt.Key_Z && event.modifiers === Qt.ControlModifier)
            session.tuning.undo()
        else if (event.modifiers !== Qt.NoModifier)
            event.accepted = false
        else if (event.key === Qt.Key_R)
            session.files.toggleRecording()
        else if (event.key === Qt.Key_W)
            session.hand.whereAmI()
        else if (event.key === Qt.Key_P)
            session.plots.readPlots()
        else if (event.key === Qt.Key_O)
            page.openDialog()
        else
            event.accepted = false
    }

    LabSurface {
        id: surface
        objectName: "surface"
        session: page.session
        focus: true
        x: page.wide && Theme.mirrored ? page.width - page.margin - width : page.margin
        y: page.margin
        width: (page.wide ? 0.56 * page.width : page.width - page.margin) - page.margin
        height: page.wide ? Math.min(implicitHeight, (page.plotsBeside ? 0.5 : 1) * (page.height - 2 * page.margin))
                          : Math.min(implicitHeight, 0.42 * page.height)
    }
    Loader {
        anchors { left: surface.left; right: surface.right; top: surface.bottom; bottom: parent.bottom }
        anchors { topMargin: Theme.gap; bottomMargin: page.margin }
        active: page.plotsBeside
        asynchronous: true // the page is there sooner than its plots and controls
        visible: active
        sourceComponent: LabPlots {
            session: page.session
            columns: 2
            cellHeight: 0.5 * (height - spacing)
        }
    }
    TpScroll {
        id: panel
        objectName: "panel"
        x: page.wide && !Theme.mirrored ? surface.x + surface.width : 0
        y: page.wide ? 0 : surface.y + surface.height
        width: page.wide ? page.width - page.margin - surface.width : page.width
        height: page.height - y
        margin: page.margin

        TpStatus {
            width: parent.width
            text: page.session.status
            wrapMode: Text.Wrap
        }
        TpText { // the legend of the picture, which does not grow with the text
            width: parent.width
            text: page.session.scene.fieldWords
            font.pixelSize: Theme.smallSize
            color: Theme.quiet
            Accessible.ignored: true // the surface's name
        }
        Flow {
            width: parent.width
            spacing: Theme.gap
            TpButton {
                objectName: "run"
                width: Math.min(implicitWidth, parent.width)
                primary: true
                text: page.session.activity.stopped ? qsTr("Start the servo") : qsTr("Stop")
                hint: qsTr("Key: Space on the surface; Escape stops")
                onClicked: page.session.activity.stopped ? page.session.servo.start() : page.session.stop()
            }
            TpButton {
                objectName: "record"
                width: Math.min(implicitWidth, parent.width)
                text: page.session.activity.recording ? qsTr("Stop recording") : qsTr("Record")
                hint: qsTr("Key: R")
                onClicked: page.session.files.toggleRecording()
            }
            TpButton {
                width: Math.min(implicitWidth, parent.width)
                text: qsTr("Where is the finger?")
                hint: qsTr("Key: W")
                onClicked: page.session.hand.whereAmI()
            }
            TpButton {
                width: Math.min(implicitWidth, parent.width)
                text: qsTr("Read out the plots")
                hint: qsTr("Key: P")
                onClicked: page.session.plots.readPlots()
            }
        }
        Loader {
            width: parent.width
            active: !page.plotsBeside
            asynchronous: true
            visible: active
            sourceComponent: LabPlots {
                session: page.session
                columns: width > 700 ? 2 : 1
            }
        }
        Loader {
            width: parent.width
            asynchronous: true
            sourceComponent: LabControls {
                session: page.session
                onOpenAsked: page.openDialog()
            }
        }
    }

    DropArea {
        anchors.fill: parent
        onDropped: (drop) => {
            if (drop.hasUrls)
                page.session.scene.openPhoto(drop.urls[0])
        }
    }
    Loader {
        id: dialog
        active: false
        source: "LabOpenDialog.qml"
    }
    Connections {
        target: dialog.item
        function onChosen(file) { page.session.scene.openPhoto(file) }
    }
}
