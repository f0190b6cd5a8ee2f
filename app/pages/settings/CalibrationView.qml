// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Settings

// The area whose corners are touched one after the other with a finger in the device, and the way out.
FocusScope {
    id: view

    required property DeviceSettings devices
    readonly property int mark: devices.mark

    // Millimetres on the screen.
    function millimetres(x, y) {
        const place = mapToGlobal(x, y)
        return Qt.point(place.x / Screen.pixelDensity, place.y / Screen.pixelDensity)
    }
    function tellArea() {
        const corner = millimetres(0, 0)
        devices.areaLies(corner.x, corner.y, width / Screen.pixelDensity, height / Screen.pixelDensity)
    }
    function touch(x, y) {
        const place = millimetres(x, y)
        devices.touched(place.x, place.y)
    }

    Component.onCompleted: Qt.callLater(tellArea)
    onWidthChanged: Qt.callLater(tellArea)
    onHeightChanged: Qt.callLater(tellArea)

    Rectangle {
        anchors.fill: parent
        color: Theme.ground
    }
    MouseArea {
        anchors.fill: parent
        onPressed: (mouse) => view.touch(mouse.x, mouse.y)
        onPositionChanged: (mouse) => view.touch(mouse.x, mouse.y)
        onReleased: view.devices.lifted()
        onCanceled: view.devices.lifted()
    }
    MultiPointTouchArea {
        anchors.fill: parent
        mouseEnabled: false
        maximumTouchPoints: 1
        onPressed: (points) => view.touch(points[0].x, points[0].y)
        onUpdated: (points) => view.touch(points[0].x, points[0].y)
        onReleased: view.devices.lifted()
        onCanceled: view.devices.lifted()
    }
    Rectangle { // the corner to be touched
        readonly property bool atLeft: view.mark === 0 || view.mark === 3
        readonly property bool atTop: view.mark === 0 || view.mark === 1
        x: atLeft ? Theme.gap : parent.width - width - Theme.gap
        y: atTop ? Theme.gap : parent.height - height - Theme.gap
        width: Theme.target
        height: Theme.target
        radius: Theme.target / 2
        color: "transparent"
        border.width: 6
        border.color: Theme.accent
        Rectangle {
            anchors.centerIn: parent
            width: 12
            height: 12
            radius: 6
            color: Theme.accent
        }
    }
    Column {
        anchors.centerIn: parent
        width: Math.min(parent.width - 4 * Theme.gap, Math.max(320, 0.5 * parent.width))
        spacing: 2 * Theme.gap
        TpHeading { width: parent.width; text: qsTr("Calibration"); horizontalAlignment: Text.AlignHCenter }
        TpStatus {
            width: parent.width
            text: view.devices.instruction
            wrapMode: Text.Wrap
            horizontalAlignment: Text.AlignHCenter
            font.pixelSize: Theme.headingSize
        }
        TpButton {
            width: parent.width
            focus: true
            text: qsTr("Cancel the calibration")
            hint: qsTr("Nothing is changed. Key: Escape")
            onClicked: view.devices.stop()
        }
    }
}
