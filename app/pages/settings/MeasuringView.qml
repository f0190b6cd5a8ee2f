// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Settings

// A force stick being measured: what to do now, what the scale shows, and the way out.
FocusScope {
    id: view

    required property DeviceSettings devices

    Rectangle {
        anchors.fill: parent
        color: Theme.ground
    }
    TpScroll {
        anchors.fill: parent
        focus: true
        margin: 2 * Theme.gap

        TpHeading { width: parent.width; text: qsTr("Measuring the stick") }
        TpStatus {
            width: parent.width
            text: view.devices.instruction
            wrapMode: Text.Wrap
        }
        TpTextField {
            id: grams
            objectName: "grams"
            width: parent.width
            visible: view.devices.weighing
            onVisibleChanged: if (visible) forceActiveFocus()
            label: qsTr("Grams on the scale")
            placeholder: qsTr("Type, or use the slider below")
            longest: 6
            onEntered: (text) => { if (activeFocus) view.devices.weighed(text) } // not where it is left
        }
        TpSlider {
            id: slider
            objectName: "gramsSlider"
            width: parent.width
            visible: view.devices.weighing
            label: qsTr("Grams, in steps of five")
            valueText: qsTr("%1 grams").arg(Number(value).toLocaleString(Qt.locale(), 'f', 0))
            from: 0
            to: 2000
            stepSize: 5
            setting: 100
            onChosen: (value) => grams.text = value
        }
        TpButton {
            objectName: "weighed"
            width: parent.width
            visible: view.devices.weighing
            text: qsTr("Use this weight")
            onClicked: view.devices.weighed(grams.text)
        }
        TpButton {
            width: parent.width
            focus: true
            text: qsTr("Cancel the measurement")
            hint: qsTr("Nothing is changed. Key: Escape")
            onClicked: view.devices.stop()
        }
    }
}
