// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Capture
import TouchPhoto.Controls

// What the camera sees, for those who see something. A frame round it shows that all is well.
FocusScope {
    id: surface

    required property CaptureSession session
    readonly property bool on: session.camera.state === CaptureCamera.On

    activeFocusOnTab: true
    Accessible.role: Accessible.Canvas
    Accessible.name: qsTr("Camera view")
    Accessible.description: session.aiming.advice
    Accessible.focusable: true
    Accessible.onPressAction: session.take()

    Rectangle {
        anchors.fill: parent
        color: Theme.panel
        radius: Theme.radius
    }
    PictureItem {
        anchors { fill: parent; margins: 8 }
        visible: surface.on
        picture: surface.session.shutter.shown >= 0 ? surface.session.shutter.picture : surface.session.camera.picture
    }
    Rectangle {
        anchors.fill: parent
        visible: surface.session.aiming.good
        color: "transparent"
        radius: Theme.radius
        border.width: 6
        border.color: Theme.accent
    }
    TpText {
        anchors.centerIn: parent
        width: parent.width - 4 * Theme.gap
        visible: !surface.on
        text: surface.session.camera.state === CaptureCamera.Failed ? surface.session.camera.problem : qsTr("The camera is starting.")
        horizontalAlignment: Text.AlignHCenter
        font.pixelSize: Theme.headingSize
    }
    MultiPointTouchArea {
        anchors.fill: parent
        maximumTouchPoints: 1
        onPressed: surface.forceActiveFocus(Qt.MouseFocusReason)
        onReleased: surface.session.take()
        onGestureStarted: (gesture) => gesture.grab() // from a column that scrolls
    }
    FocusRing { target: surface; corner: 0 }
}
