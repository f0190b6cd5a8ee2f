// SPDX-License-Identifier: Apache-2.0
import QtQuick
import QtQuick.Shapes
import TouchPhoto.Controls
import TouchPhoto.Lab

// The hand as a ring, the finger as a disc, the spring between them, and the force on the finger as an arrow.
Item {
    id: marks

    required property LabSession session
    required property real pixelsPerMm

    readonly property real millimetresPerNewton: 24
    readonly property point finger: Qt.point(session.hand.finger.x * pixelsPerMm, session.hand.finger.y * pixelsPerMm)
    readonly property point hand: Qt.point(session.hand.pointer.x * pixelsPerMm, session.hand.pointer.y * pixelsPerMm)

    Rectangle { // the spring
        x: marks.hand.x
        y: marks.hand.y - height / 2
        width: Math.hypot(marks.finger.x - marks.hand.x, marks.finger.y - marks.hand.y)
        height: 3
        color: "white"
        antialiasing: true
        transformOrigin: Item.Left
        rotation: Math.atan2(marks.finger.y - marks.hand.y, marks.finger.x - marks.hand.x) * 180 / Math.PI
    }
    Rectangle { // the hand
        x: marks.hand.x - width / 2
        y: marks.hand.y - height / 2
        width: 24
        height: 24
        radius: 12
        color: "transparent"
        border.width: 3
        border.color: "white"
    }
    Item { // the force
        x: marks.finger.x
        y: marks.finger.y
        visible: marks.session.hand.newtons > 0.02
        rotation: Math.atan2(marks.session.hand.force.y, marks.session.hand.force.x) * 180 / Math.PI
        transformOrigin: Item.TopLeft
        Shape {
            ShapePath {
                fillColor: "#ffd166"
                strokeColor: "#0a0e13"
                strokeWidth: 2
                joinStyle: ShapePath.RoundJoin
                PathPolyline {
                    readonly property real tip: Math.max(18, marks.session.hand.newtons * marks.millimetresPerNewton * marks.pixelsPerMm)
                    path: [Qt.point(0, -3), Qt.point(tip - 14, -3), Qt.point(tip - 14, -9), Qt.point(tip, 0),
                           Qt.point(tip - 14, 9), Qt.point(tip - 14, 3), Qt.point(0, 3), Qt.point(0, -3)]
                }
            }
        }
    }
    Rectangle { // the finger
        x: marks.finger.x - width / 2
        y: marks.finger.y - height / 2
        width: 16
        height: 16
        radius: 8
        color: "#ff9eb0"
        border.width: 2
        border.color: "#0a0e13"
    }
}
