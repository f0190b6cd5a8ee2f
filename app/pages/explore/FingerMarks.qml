// SPDX-License-Identifier: Apache-2.0
import QtQuick
import QtQuick.Shapes
import TouchPhoto.Controls
import TouchPhoto.Explore

// The hand as a ring, the finger as a disc, the spring between them, and the force on the finger as an arrow.
Item {
    id: marks

    required property ExploreSession session
    required property real pixelsPerMm

    readonly property real millimetresPerNewton: 24
    readonly property point finger: session.finger.place
    readonly property point pointer: session.finger.pointer
    readonly property point force: session.finger.force
    readonly property real fingerX: finger.x * pixelsPerMm
    readonly property real fingerY: finger.y * pixelsPerMm
    readonly property real pointerX: pointer.x * pixelsPerMm
    readonly property real pointerY: pointer.y * pixelsPerMm
    readonly property real arrowLength: session.finger.newtons * millimetresPerNewton * pixelsPerMm
    readonly property real arrowAngle: Math.atan2(force.y, force.x) * 180 / Math.PI
    readonly property bool arrowShown: session.finger.newtons > 0.02

    Rectangle { // the spring
        readonly property real dx: marks.fingerX - marks.pointerX
        readonly property real dy: marks.fingerY - marks.pointerY
        x: marks.pointerX
        y: marks.pointerY - height / 2
        width: Math.hypot(dx, dy)
        height: 3
        color: Theme.text
        antialiasing: true
        transformOrigin: Item.Left
        rotation: Math.atan2(dy, dx) * 180 / Math.PI
    }
    Rectangle { // the hand
        x: marks.pointerX - width / 2
        y: marks.pointerY - height / 2
        width: 28
        height: 28
        radius: 14
        color: "transparent"
        border.width: 6
        border.color: Theme.ground
        Rectangle {
            anchors.fill: parent
            anchors.margins: 1.5
            radius: width / 2
            color: "transparent"
            border.width: 3
            border.color: Theme.text
        }
    }
    Item { // the force
        x: marks.fingerX
        y: marks.fingerY
        visible: marks.arrowShown
        rotation: marks.arrowAngle
        transformOrigin: Item.TopLeft
        Shape {
            ShapePath {
                fillColor: Theme.accent
                strokeColor: Theme.ground
                strokeWidth: 2
                joinStyle: ShapePath.RoundJoin
                PathPolyline {
                    readonly property real tip: Math.max(18, marks.arrowLength)
                    path: [Qt.point(0, -3), Qt.point(tip - 16, -3), Qt.point(tip - 16, -10), Qt.point(tip, 0),
                           Qt.point(tip - 16, 10), Qt.point(tip - 16, 3), Qt.point(0, 3), Qt.point(0, -3)]
                }
            }
        }
    }
    Rectangle { // where ticks lead it
        x: marks.session.finger.leader.x * marks.pixelsPerMm - width / 2
        y: marks.session.finger.leader.y * marks.pixelsPerMm - height / 2
        width: 14
        height: 14
        radius: 7
        visible: marks.session.finger.led
        color: Theme.accent
        border.width: 2
        border.color: Theme.ground
    }
    Rectangle { // the finger
        x: marks.fingerX - width / 2
        y: marks.fingerY - height / 2
        width: 18
        height: 18
        radius: 9
        color: Theme.finger
        border.width: 2
        border.color: Theme.ground
    }
    Rectangle { // how strong: beyond the arrow's tip, or behind the hand where there is no room
        readonly property real angle: marks.arrowAngle * Math.PI / 180
        readonly property real reach: 0.5 * Math.hypot(width * Math.cos(angle), height * Math.sin(angle)) + 10
        readonly property real away: Math.max(18, marks.arrowLength) + reach
        readonly property real behind: Math.hypot(marks.fingerX - marks.pointerX, marks.fingerY - marks.pointerY) + 16 + reach
        readonly property real beyondX: marks.fingerX + away * Math.cos(angle)
        readonly property real beyondY: marks.fingerY + away * Math.sin(angle)
        readonly property bool room: beyondX > width / 2 && beyondX < marks.width - width / 2
                                     && beyondY > height / 2 && beyondY < marks.height - height / 2
        readonly property real middleX: room ? beyondX : marks.fingerX - behind * Math.cos(angle)
        readonly property real middleY: room ? beyondY : marks.fingerY - behind * Math.sin(angle)
        x: Math.max(0, Math.min(marks.width - width, middleX - width / 2))
        y: Math.max(0, Math.min(marks.height - height, middleY - height / 2))
        width: newtons.width + 14
        height: newtons.height + 6
        radius: 6
        visible: marks.arrowShown
        color: Theme.panel
        PlainText {
            id: newtons
            anchors.centerIn: parent
            text: qsTr("%1 N").arg(marks.session.finger.newtons.toFixed(2))
            font.pixelSize: Theme.smallSize
            font.bold: true
            color: Theme.text
            Accessible.ignored: true
        }
    }
}
