// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Study

// Where the hand of a drawn finger moves. Nothing of the scene is seen, and the finger is not either: only how far the hand goes
// counts, so it may lift and begin anywhere. In a sitting it is an empty field.
FocusScope {
    id: surface

    required property StudySession session
    readonly property StudyRun run: session.run
    readonly property real pixelsPerMm: Math.max(0.5, Math.min(width / Math.max(1, run.surfaceWidth), height / Math.max(1, run.surfaceHeight)))
    readonly property bool moves: run.handMoves
    activeFocusOnTab: true
    Accessible.role: Accessible.Canvas
    Accessible.name: qsTr("Study surface")
    Accessible.description: run.status
    Accessible.focusable: true
    Accessible.onPressAction: run.goOn()

    // A mouse or a fingertip; where it begins does not matter.
    component Way: QtObject {
        property point last: Qt.point(0, 0)
        property bool fresh: true
        function begin() { fresh = true }
        function follow(x, y) {
            if (!fresh && surface.moves)
                surface.session.moveBy((x - last.x) / surface.pixelsPerMm, (y - last.y) / surface.pixelsPerMm)
            last = Qt.point(x, y)
            fresh = false
        }
    }
    // A mouse that would leave the field goes on from its middle, where the system lets it be put there.
    function recentre() {
        mouseWay.begin()
        if (moves && mouse.containsMouse) {
            const middle = mapToGlobal(width / 2, height / 2)
            session.putMouse(middle.x, middle.y)
        }
    }
    onMovesChanged: recentre()

    Rectangle {
        anchors.fill: parent
        color: Theme.panel
        radius: Theme.radius
        border.width: 1
        border.color: Theme.edge
    }
    Loader {
        anchors.fill: parent
        active: surface.run.trying
        sourceComponent: ShownSceneItem {
            run: surface.run
            pixelsPerMm: surface.pixelsPerMm
            lineColor: Theme.line
            fingerColor: Theme.finger
        }
    }
    Way { id: mouseWay }
    Way { id: touchWay }
    MouseArea {
        id: mouse
        readonly property real border: Math.min(width, height) / 8
        anchors.fill: parent
        hoverEnabled: true
        preventStealing: true
        cursorShape: surface.moves ? Qt.BlankCursor : Qt.ArrowCursor
        onPressed: surface.forceActiveFocus(Qt.MouseFocusReason)
        onEntered: mouseWay.begin()
        onPositionChanged: (mouse) => {
            mouseWay.follow(mouse.x, mouse.y)
            if (mouse.x < border || mouse.y < border || mouse.x > width - border || mouse.y > height - border)
                surface.recentre()
        }
    }
    MultiPointTouchArea {
        anchors.fill: parent
        mouseEnabled: false
        maximumTouchPoints: 1
        onPressed: (points) => {
            surface.forceActiveFocus(Qt.MouseFocusReason)
            touchWay.begin()
            touchWay.follow(points[0].x, points[0].y)
        }
        onUpdated: (points) => touchWay.follow(points[0].x, points[0].y)
        onGestureStarted: (gesture) => gesture.grab() // from a column that scrolls
    }
    FocusRing { target: surface; corner: 0 }
}
