// SPDX-License-Identifier: Apache-2.0
import QtQuick
import QtQuick.Layouts
import TouchPhoto.Capture
import TouchPhoto.Controls

// What the camera sees, and beside it (below it on a tall window) the words and the buttons.
FocusScope {
    id: page

    required property CaptureSession session
    readonly property string help: panel.help
    readonly property bool wide: width > 1.15 * height && width >= 640 * Theme.textScale
    readonly property bool tight: !wide && height > 0 && height < 640 * Theme.textScale // the view scrolls with the rest
    readonly property bool inSight: Window.visibility !== Window.Hidden && Window.visibility !== Window.Minimized

    focus: true
    onInSightChanged: session.setInSight(inSight)
    onTightChanged: Qt.callLater(keyboardToSurface)

    // The view lies in the panel's focus scope where it scrolls with the rest.
    function keyboardToSurface() {
        surface.focus = true
        if (tight)
            panel.focus = true
    }
    // At a desk keys are the hand.
    function moved(event) {
        if (!session.camera.movedByKeys)
            return false
        const turned = event.modifiers & Qt.ShiftModifier
        switch (event.key) {
        case Qt.Key_Left: turned ? session.moveCamera(0, 0, -1, 0) : session.moveCamera(-1, 0, 0, 0); break
        case Qt.Key_Right: turned ? session.moveCamera(0, 0, 1, 0) : session.moveCamera(1, 0, 0, 0); break
        case Qt.Key_Up: session.moveCamera(0, 1, 0, 0); break
        case Qt.Key_Down: session.moveCamera(0, -1, 0, 0); break
        case Qt.Key_PageUp: session.moveCamera(0, 0, 0, 1); break
        case Qt.Key_PageDown: session.moveCamera(0, 0, 0, -1); break
        default: return false
        }
        return true
    }

    Keys.onPressed: (event) => {
        event.accepted = true
        if (event.key === Qt.Key_Escape) {
            event.accepted = session.stop()
            return
        }
        if (event.modifiers & (Qt.AltModifier | Qt.MetaModifier)) {
            event.accepted = false
            return
        }
        if (event.modifiers & Qt.ControlModifier) {
            event.accepted = event.key === Qt.Key_Z
            if (event.accepted)
                session.shutter.undo()
            return
        }
        if (!session.memo.running)
            session.listen()
        switch (event.key) {
        case Qt.Key_Space:
            if (!event.isAutoRepeat)
                session.take()
            break
        case Qt.Key_M:
            if (!event.isAutoRepeat)
                session.recordMemo()
            break
        case Qt.Key_N: session.shutter.look(1); break
        case Qt.Key_P: session.shutter.look(-1); break
        case Qt.Key_K: session.shutter.keepShown(); break
        case Qt.Key_1: session.choices.chooseAim(0); break
        case Qt.Key_2: session.choices.chooseAim(1); break
        case Qt.Key_3: session.choices.chooseAim(2); break
        case Qt.Key_4: session.choices.chooseAim(3); break
        case Qt.Key_C: session.turnRound(); break
        case Qt.Key_L: session.setLight(!session.camera.lit); break
        case Qt.Key_S: session.choices.setByItself(!session.choices.byItself); break
        case Qt.Key_A: session.choices.setMoment(!session.choices.moment); break
        case Qt.Key_W: session.tellAll(); break
        case Qt.Key_R: session.tryAgain(); break
        case Qt.Key_I: session.importInstead(); break
        default: event.accepted = page.moved(event)
        }
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
            Layout.preferredHeight: page.wide ? -1 : Math.min(0.75 * width, 0.5 * page.height)
            CaptureSurface {
                id: surface
                objectName: "surface"
                session: page.session
                parent: page.tight ? panel.slot : slot
                anchors.fill: parent
                focus: true
            }
        }
        CapturePanel {
            id: panel
            session: page.session
            holdsSurface: page.tight
            Layout.fillHeight: true
            Layout.fillWidth: !page.wide
            Layout.preferredWidth: page.wide ? Math.min(420 * Theme.textScale, 0.5 * page.width) : -1
        }
    }
}
