// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Browse

// The photograph, which fingers, keys and a screen reader go on from and listen to.
FocusScope {
    id: pane

    required property BrowseSession session

    activeFocusOnTab: true
    Accessible.role: Accessible.Graphic
    Accessible.name: session.trail.placeText === "" ? session.details.summary : qsTr("%1 %2").arg(session.details.summary).arg(session.trail.placeText)
    Accessible.description: qsTr("Left and right arrow: other photographs. Up and down: details. Enter: recordings.")
    Accessible.focusable: true
    Accessible.onPressAction: session.playback.play()
    Accessible.onNextPageAction: session.trail.next()
    Accessible.onPreviousPageAction: session.trail.previous()
    Accessible.onIncreaseAction: session.details.next()
    Accessible.onDecreaseAction: session.details.previous()

    Rectangle {
        anchors.fill: parent
        color: Theme.panel
        radius: Theme.radius
    }
    PictureItem {
        anchors.fill: parent
        anchors.margins: 4
        picture: pane.session.details.picture
    }
    TpText {
        anchors.centerIn: parent
        width: parent.width - 4 * Theme.gap
        visible: text !== ""
        text: pane.session.details.pictureProblem
        horizontalAlignment: Text.AlignHCenter
    }
    GestureArea {
        objectName: "gestures"
        anchors.fill: parent
        onTapped: { pane.forceActiveFocus(Qt.MouseFocusReason); pane.session.details.tap() }
        onDoubleTapped: pane.session.playback.play()
        onSwipedRight: pane.session.trail.next()
        onSwipedLeft: pane.session.trail.previous()
        onSwipedDown: pane.session.details.next()
        onSwipedUp: pane.session.details.previous()
        onTwoFingerTapped: pane.session.twoFingerTap()
        onTwoFingerDoubleTapped: pane.session.twoFingerDoubleTap()
        onDrawnZ: pane.session.lists.back()
        onThreeFingerTapped: pane.session.whereAmI()
    }
    FocusRing { target: pane }
}
