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
    Accessible.name: session.placeText === "" ? session.summary : qsTr("%1 %2").arg(session.summary).arg(session.placeText)
    Accessible.description: qsTr("Left and right arrow: other photographs. Up and down: what is known. Return: recordings.")
    Accessible.focusable: true
    Accessible.onPressAction: session.play()
    Accessible.onNextPageAction: session.next()
    Accessible.onPreviousPageAction: session.previous()
    Accessible.onIncreaseAction: session.nextDetail()
    Accessible.onDecreaseAction: session.previousDetail()

    Rectangle {
        anchors.fill: parent
        color: Theme.panel
        radius: Theme.radius
    }
    PictureItem {
        anchors.fill: parent
        anchors.margins: 4
        picture: pane.session.picture
    }
    TpText {
        anchors.centerIn: parent
        width: parent.width - 4 * Theme.gap
        visible: text !== ""
        text: pane.session.pictureProblem
        horizontalAlignment: Text.AlignHCenter
    }
    GestureArea {
        objectName: "gestures"
        anchors.fill: parent
        onTapped: { pane.forceActiveFocus(Qt.MouseFocusReason); pane.session.tap() }
        onDoubleTapped: pane.session.play()
        onSwipedRight: pane.session.next()
        onSwipedLeft: pane.session.previous()
        onSwipedDown: pane.session.nextDetail()
        onSwipedUp: pane.session.previousDetail()
        onTwoFingerTapped: pane.session.twoFingerTap()
        onTwoFingerDoubleTapped: pane.session.twoFingerDoubleTap()
        onDrawnZ: pane.session.back()
        onThreeFingerTapped: pane.session.whereAmI()
    }
    FocusRing { target: pane }
}
