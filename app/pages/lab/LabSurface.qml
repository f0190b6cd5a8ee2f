// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Lab

// The force field over the surface with its scale, the hand, the finger and the force on it. As large as fits.
FocusScope {
    id: surface

    required property LabSession session
    readonly property real legend: session.scene.legendPixels / Screen.devicePixelRatio
    readonly property real sheetWidth: Math.max(64, Math.min(width, (height - legend) * session.scene.surfaceWidth / session.scene.surfaceHeight))
    readonly property real pixelsPerMm: sheetWidth / session.scene.surfaceWidth
    readonly property real step: 2 // millimetres

    implicitHeight: width * session.scene.surfaceHeight / session.scene.surfaceWidth + legend
    activeFocusOnTab: true
    Accessible.role: Accessible.Canvas
    Accessible.name: session.scene.fieldWords
    Accessible.description: qsTr("Arrow keys move the hand by 2 millimetres, with Shift by 10. Space starts and stops the servo.")
    Accessible.focusable: true
    Accessible.onPressAction: surface.toggle()

    function toggle() {
        if (session.activity.stopped)
            session.servo.start()
        else
            session.stop()
    }
    onPixelsPerMmChanged: session.scene.setFieldScale(pixelsPerMm * Screen.devicePixelRatio)
    Component.onCompleted: session.scene.setFieldScale(pixelsPerMm * Screen.devicePixelRatio)

    Keys.onPressed: (event) => {
        const far = event.modifiers & Qt.ShiftModifier ? 5 * step : step
        event.accepted = true
        switch (event.key) {
        case Qt.Key_Left: session.hand.nudge(-far, 0); break
        case Qt.Key_Right: session.hand.nudge(far, 0); break
        case Qt.Key_Up: session.hand.nudge(0, -far); break
        case Qt.Key_Down: session.hand.nudge(0, far); break
        case Qt.Key_Space:
        case Qt.Key_Return:
        case Qt.Key_Enter: surface.toggle(); break
        default: event.accepted = false
        }
    }

    Item {
        id: sheet
        width: surface.sheetWidth
        height: width * surface.session.scene.surfaceHeight / surface.session.scene.surfaceWidth
        anchors.horizontalCenter: parent.horizontalCenter

        PictureItem {
            width: parent.width
            height: parent.height + surface.legend
            fill: PictureItem.Stretch
            picture: surface.session.scene.field
        }
        LabMarks {
            anchors.fill: parent
            clip: true
            session: surface.session
            pixelsPerMm: surface.pixelsPerMm
        }
        MouseArea {
            anchors.fill: parent
            hoverEnabled: true
            preventStealing: true
            onEntered: surface.session.hand.touchDown(mouseX / surface.pixelsPerMm, mouseY / surface.pixelsPerMm)
            onPressed: (mouse) => {
                surface.forceActiveFocus(Qt.MouseFocusReason)
                if (mouse.source !== Qt.MouseEventNotSynthesized)
                    surface.session.hand.touchDown(mouse.x / surface.pixelsPerMm, mouse.y / surface.pixelsPerMm)
            }
            onPositionChanged: (mouse) => surface.session.hand.moveTo(mouse.x / surface.pixelsPerMm, mouse.y / surface.pixelsPerMm)
        }
        Item {
            width: parent.width
            height: parent.height + surface.legend
            FocusRing { target: surface; corner: 0 }
        }
    }
}
