// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Mend

// The part of the photograph that is worked on: picture, force field, lines and their points. One area takes mouse and
// touch, because the places where points may be pressed overlap and the nearest one must win.
FocusScope {
    id: surface

    required property MendSession session
    readonly property real reach: Math.max(24, 0.5 * Theme.target) // px round a point in which it is taken

    activeFocusOnTab: true
    Accessible.role: Accessible.Canvas
    Accessible.name: qsTr("Contours")
    Accessible.description: qsTr("Tab goes from point to point. Arrow keys move it by one pixel of the photograph, with Shift by ten, with Control by a fifth. Page Up and Page Down change the feature.")
    Accessible.focusable: true

    onWidthChanged: session.view.setWindow(width, height)
    onHeightChanged: session.view.setWindow(width, height)
    Component.onCompleted: session.view.setWindow(width, height)

    Keys.onTabPressed: (event) => event.accepted = session.selection.stepHandle(1)
    Keys.onBacktabPressed: (event) => event.accepted = session.selection.stepHandle(-1)
    Keys.onPressed: (event) => {
        const step = event.modifiers & Qt.ShiftModifier ? 10 : event.modifiers & Qt.ControlModifier ? 0.2 : 1
        if (event.modifiers & Qt.ControlModifier && event.key >= Qt.Key_A && event.key <= Qt.Key_Z) {
            event.accepted = false
            return
        }
        event.accepted = true
        switch (event.key) {
        case Qt.Key_Left: session.editing.nudge(-step, 0); break
        case Qt.Key_Right: session.editing.nudge(step, 0); break
        case Qt.Key_Up: session.editing.nudge(0, -step); break
        case Qt.Key_Down: session.editing.nudge(0, step); break
        case Qt.Key_PageDown: session.selection.stepFeature(1); break
        case Qt.Key_PageUp: session.selection.stepFeature(-1); break
        case Qt.Key_Insert:
        case Qt.Key_A: session.editing.addPoint(); break
        case Qt.Key_Delete: session.editing.deletePoint(); break
        case Qt.Key_C: session.editing.turnCorner(); break
        case Qt.Key_M: session.selection.wholeFeature = !session.selection.wholeFeature; break
        case Qt.Key_F: session.preview.forceShown = !session.preview.forceShown; break
        case Qt.Key_W: session.selection.whereAmI(); break
        case Qt.Key_Plus:
        case Qt.Key_Equal: session.selection.zoomBy(1.5); break
        case Qt.Key_Minus: session.selection.zoomBy(1 / 1.5); break
        case Qt.Key_0: session.view.showAll(); break
        case Qt.Key_Z: session.selection.fitIntoView(); break
        default: event.accepted = false
        }
    }

    Rectangle {
        anchors.fill: parent
        color: Theme.panel
        radius: Theme.radius
    }
    MendPictureItem {
        anchors.fill: parent
        clip: true
        session: surface.session
        opacity: surface.session.photo.state === MendedPhoto.Looking ? 0.3 : 1
    }
    MendLinesItem {
        anchors.fill: parent
        clip: true
        session: surface.session
        visible: surface.session.photo.state === MendedPhoto.Ready
        lineColor: Theme.line
        highlightColor: "#ffd166" // on the photograph, whatever the scheme
    }

    TpText {
        anchors.centerIn: parent
        width: parent.width - 4 * Theme.gap
        visible: surface.session.photo.state === MendedPhoto.Empty
        text: qsTr("No photograph yet.")
        horizontalAlignment: Text.AlignHCenter
        font.pixelSize: Theme.headingSize
    }

    // The points for a screen reader. They take no mouse and no touch.
    Repeater {
        model: surface.session.selection.handles
        delegate: Item {
            id: point
            required property int index
            required property point place
            required property string name

            x: (place.x - surface.session.view.origin.x) * surface.session.view.scale - width / 2
            y: (place.y - surface.session.view.origin.y) * surface.session.view.scale - height / 2
            width: 2 * surface.reach
            height: width
            Accessible.role: Accessible.Button
            Accessible.name: point.name
            Accessible.description: qsTr("%1 across, %2 down").arg(point.place.x.toFixed(1)).arg(point.place.y.toFixed(1))
            Accessible.onPressAction: surface.session.selection.chooseHandle(point.index)
            Accessible.onScrollLeftAction: surface.session.editing.nudgeHandle(point.index, -1, 0)
            Accessible.onScrollRightAction: surface.session.editing.nudgeHandle(point.index, 1, 0)
            Accessible.onScrollUpAction: surface.session.editing.nudgeHandle(point.index, 0, -1)
            Accessible.onScrollDownAction: surface.session.editing.nudgeHandle(point.index, 0, 1)
            Accessible.onNextPageAction: surface.session.selection.stepHandle(1)
            Accessible.onPreviousPageAction: surface.session.selection.stepHandle(-1)
        }
    }

    MouseArea {
        id: area
        property point from
        property bool held: false  // a point is
        property bool moved: false // more than a finger trembles

        anchors.fill: parent
        preventStealing: true
        onPressed: (mouse) => {
            surface.forceActiveFocus(Qt.MouseFocusReason)
            from = Qt.point(mouse.x, mouse.y)
            moved = false
            held = surface.session.drag.grab(mouse.x, mouse.y, surface.reach)
        }
        onPositionChanged: (mouse) => {
            if (!moved && Math.hypot(mouse.x - from.x, mouse.y - from.y) < 4)
                return
            moved = true
            if (held) {
                surface.session.drag.dragTo(mouse.x, mouse.y)
            } else {
                surface.session.view.panBy(mouse.x - from.x, mouse.y - from.y)
                from = Qt.point(mouse.x, mouse.y)
            }
        }
        onReleased: (mouse) => {
            if (held)
                surface.session.drag.drop()
            else if (!moved)
                surface.session.selection.tap(mouse.x, mouse.y, surface.reach)
        }
        onCanceled: surface.session.drag.cancel()
        onDoubleClicked: (mouse) => {
            if (!held)
                surface.session.editing.addPointAt(mouse.x, mouse.y)
        }
        onWheel: (wheel) => surface.session.view.zoomAt(Math.pow(1.0015, wheel.angleDelta.y), wheel.x, wheel.y)
    }
    FocusRing { target: surface; corner: 0 }
}
