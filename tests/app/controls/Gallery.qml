// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls

Column {
    id: gallery
    width: 400
    spacing: 10

    readonly property var theme: Theme
    property int presses: 0
    property bool wanted: false
    property real picked: 0.5

    TpHeading { text: "A heading" }
    TpText { text: "Some text" }
    TpStatus { label: "State"; text: "ready" }
    TpButton {
        objectName: "button"
        text: "A button"
        hint: "What it does"
        focus: true
        onClicked: gallery.presses += 1
    }
    TpButton {
        objectName: "disabled"
        text: "Not now"
        enabled: false
        onClicked: gallery.presses += 1
    }
    TpToggle {
        objectName: "toggle"
        text: "A toggle"
        on: gallery.wanted
        onSwitched: (on) => gallery.wanted = on
    }
    TpSlider {
        objectName: "slider"
        label: "A slider"
        from: 0
        to: 1
        stepSize: 0.1
        setting: gallery.picked
        onChosen: (value) => gallery.picked = value
    }
}
