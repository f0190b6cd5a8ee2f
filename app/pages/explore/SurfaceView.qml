// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Explore

// The photograph as it lies under the finger: picture, lines, faces and features for a screen reader, the hand.
FocusScope {
    id: surface

    required property ExploreSession session
    readonly property real pixelsPerMm: width / session.view.surfaceWidth
    readonly property rect photoRect: session.view.photoRect

    // Where it lies on the screen, for a device that lies there too.
    function tellPlace() {
        const corner = mapToGlobal(0, 0)
        session.device.sheetLies(corner.x / Screen.pixelDensity, corner.y / Screen.pixelDensity, pixelsPerMm / Screen.pixelDensity)
    }
    onPixelsPerMmChanged: Qt.callLater(tellPlace)
    Window.onWindowChanged: Qt.callLater(tellPlace)
    Connections {
        target: surface.Window.window
        function onXChanged() { Qt.callLater(surface.tellPlace) }
        function onYChanged() { Qt.callLater(surface.tellPlace) }
    }

    activeFocusOnTab: true
    Accessible.role: Accessible.Canvas
    Accessible.name: qsTr("Touch surface")
    Accessible.description: qsTr("Move a finger to hear what is under it. Arrow keys move the hand, Tab goes from feature to feature, Space starts the guided tour, Z zooms in.")
    Accessible.focusable: true
    Accessible.onPressAction: session.finger.whereAmI()
    Accessible.onIncreaseAction: session.zoom.zoomIn()
    Accessible.onDecreaseAction: session.zoom.zoomOut()

    Keys.onTabPressed: (event) => event.accepted = session.hand.stepFeature(1)
    Keys.onBacktabPressed: (event) => event.accepted = session.hand.stepFeature(-1)

    Rectangle {
        anchors.fill: parent
        color: Theme.panel
        radius: Theme.radius
    }
    PictureItem {
        anchors.fill: parent
        picture: surface.session.view.photo
        place: Qt.rect(surface.photoRect.x * surface.pixelsPerMm, surface.photoRect.y * surface.pixelsPerMm,
                       surface.photoRect.width * surface.pixelsPerMm, surface.photoRect.height * surface.pixelsPerMm)
        opacity: surface.session.view.state === ExploreView.Looking ? 0.3 : 0.9
        Behavior on opacity { enabled: Theme.motion; NumberAnimation { duration: 200 } }
    }
    ContoursItem {
        anchors.fill: parent
        session: surface.session
        pixelsPerMm: surface.pixelsPerMm
        lineColor: Theme.line
        highlightColor: Theme.accent
        edgeColor: Theme.ground
    }
    FaceTargets {
        anchors.fill: parent
        session: surface.session
        pixelsPerMm: surface.pixelsPerMm
    }
    FingerMarks {
        anchors.fill: parent
        clip: true
        visible: surface.session.view.state === ExploreView.Ready
        session: surface.session
        pixelsPerMm: surface.pixelsPerMm
    }
    TpText {
        anchors.centerIn: parent
        width: parent.width - 8 * Theme.gap
        visible: surface.session.view.state === ExploreView.Empty
        text: qsTr("No photograph yet. Press O, or drop one here.")
        horizontalAlignment: Text.AlignHCenter
        font.pixelSize: Theme.headingSize
    }

    MouseArea {
        anchors.fill: parent
        hoverEnabled: true
        preventStealing: true
        onEntered: surface.session.hand.touchDown(mouseX / surface.pixelsPerMm, mouseY / surface.pixelsPerMm)
        onExited: surface.session.hand.handGone()
        onPressed: surface.forceActiveFocus(Qt.MouseFocusReason)
        onPositionChanged: (mouse) => surface.session.hand.moveTo(mouse.x / surface.pixelsPerMm, mouse.y / surface.pixelsPerMm)
    }
    MultiPointTouchArea {
        anchors.fill: parent
        mouseEnabled: false
        onPressed: (points) => {
            surface.forceActiveFocus(Qt.MouseFocusReason)
            for (const point of points)
                surface.session.hand.fingerDown(point.pointId, point.x / surface.pixelsPerMm, point.y / surface.pixelsPerMm)
        }
        onUpdated: (points) => {
            for (const point of points)
                surface.session.hand.fingerMoved(point.pointId, point.x / surface.pixelsPerMm, point.y / surface.pixelsPerMm)
        }
        onReleased: (points) => {
            for (const point of points)
                surface.session.hand.fingerUp(point.pointId)
        }
        onCanceled: surface.session.hand.fingersCancelled()
        onGestureStarted: (gesture) => gesture.grab() // from a column that scrolls
    }
    FocusRing { target: surface; corner: 0 }
}
