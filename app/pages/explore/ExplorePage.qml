// SPDX-License-Identifier: Apache-2.0
import QtQuick
import QtQuick.Layouts
import TouchPhoto.Controls
import TouchPhoto.Explore

// The page: the touch surface, and beside it (below it on a tall window) the words and the buttons.
FocusScope {
    id: page

    required property ExploreSession session
    readonly property string help: panel.help
    readonly property bool wide: width > 1.15 * height && width >= 640 * Theme.textScale
    readonly property bool tight: !wide && height > 0 && height < 640 * Theme.textScale // the surface scrolls with the rest

    focus: true
    onTightChanged: Qt.callLater(keyboardToSurface)

    // The surface lies in the panel's focus scope where it scrolls with the rest.
    function keyboardToSurface() {
        surface.focus = true
        if (tight)
            panel.focus = true
    }
    function openDialog() {
        const first = !dialog.active
        dialog.active = true
        if (dialog.status === Loader.Error) {
            session.words.tellProblem(qsTr("The file dialog is not installed. Drop a photograph on this window instead."))
            return
        }
        if (first)
            dialog.item.currentFolder = session.picturesFolder()
        dialog.item.open()
    }

    Keys.onPressed: (event) => {
        const step = event.modifiers & Qt.ShiftModifier ? 10 : 2
        event.accepted = true
        switch (event.key) {
        case Qt.Key_Left: session.hand.nudge(-step, 0); break
        case Qt.Key_Right: session.hand.nudge(step, 0); break
        case Qt.Key_Up: session.hand.nudge(0, -step); break
        case Qt.Key_Down: session.hand.nudge(0, step); break
        case Qt.Key_Space: session.tour.toggle(); break
        case Qt.Key_T: session.tour.toggleFace(); break
        case Qt.Key_Escape: event.accepted = session.stop(); break
        case Qt.Key_Backspace: session.back(); break
        case Qt.Key_Z: event.modifiers & Qt.ShiftModifier ? session.zoom.zoomOut() : session.zoom.zoomIn(); break
        case Qt.Key_G: session.choices.nextGuide(); break
        case Qt.Key_Return:
        case Qt.Key_Enter:
        case Qt.Key_E: session.device.engage(); break
        case Qt.Key_W: session.finger.whereAmI(); break
        case Qt.Key_F: session.zoom.nextFace(); break
        case Qt.Key_N: event.modifiers & Qt.ShiftModifier ? session.walk.previous() : session.walk.next(); break
        case Qt.Key_V: session.words.voiceOn = !session.words.voiceOn; break
        case Qt.Key_O: page.openDialog(); break
        default: event.accepted = false
        }
    }

    Rectangle {
        anchors.fill: parent
        color: Theme.ground
    }

    GridLayout {
        anchors.fill: parent
        anchors.margins: 2 * Theme.gap
        columns: page.wide ? 2 : 1
        columnSpacing: 2 * Theme.gap
        rowSpacing: 2 * Theme.gap

        Item {
            id: slot
            visible: !page.tight
            Layout.fillWidth: true
            Layout.fillHeight: page.wide
            Layout.preferredHeight: page.wide ? -1 : Math.min(0.75 * width, 0.6 * page.height)
            SurfaceView {
                id: surface
                objectName: "surface"
                session: page.session
                parent: page.tight ? panel.slot : slot
                anchors.centerIn: parent
                readonly property real aspect: page.session.view.surfaceWidth / page.session.view.surfaceHeight
                width: Math.min(parent.width, parent.height * aspect)
                height: width / aspect
                focus: true
            }
        }
        SidePanel {
            id: panel
            session: page.session
            holdsSurface: page.tight
            Layout.fillHeight: true
            Layout.fillWidth: !page.wide
            Layout.preferredWidth: page.wide ? Math.min(380 * Theme.textScale, 0.5 * page.width) : -1
            onOpenAsked: page.openDialog()
        }
    }

    DropArea {
        anchors.fill: parent
        onDropped: (drop) => {
            if (drop.hasUrls)
                page.session.open(drop.urls[0])
        }
    }

    Loader {
        id: dialog
        active: false
        source: "OpenDialog.qml"
    }
    Connections {
        target: dialog.item
        function onChosen(file) { page.session.open(file) }
    }
}
