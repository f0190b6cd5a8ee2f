// SPDX-License-Identifier: Apache-2.0
import QtQuick
import QtQuick.Layouts
import TouchPhoto.Controls
import TouchPhoto.Explore

// Words and buttons. It scrolls where a small window or large text needs more room.
TpScroll {
    id: panel

    required property ExploreSession session
    readonly property bool ready: session.view.state === ExploreView.Ready
    readonly property alias help: keys.text
    property bool holdsSurface: false   // on a small page the touch surface scrolls with the rest …
    readonly property alias slot: slot  // … and lies here, never so high that there is no room left to scroll by
    signal openAsked

    component Pair: RowLayout {
        width: parent.width
        spacing: Theme.gap
    }
    component Half: TpButton {
        Layout.fillWidth: true
        Layout.fillHeight: true
        Layout.preferredWidth: 1
        enabled: panel.ready
    }

    Item {
        id: slot
        width: parent.width
        height: Math.min(0.75 * width, 0.7 * panel.height)
        visible: panel.holdsSurface
    }
    TpHeading {
        width: parent.width
        text: panel.session.view.title === "" ? qsTr("Explore") : panel.session.view.title
        elide: Text.ElideMiddle
        wrapMode: Text.NoWrap
    }
    TpStatus {
        width: parent.width
        height: (width > 560 ? 1.3 : 2.2) * font.pixelSize // the buttons below keep their place
        fontSizeMode: Text.Fit
        minimumPixelSize: Theme.textSize
        verticalAlignment: Text.AlignVCenter
        text: panel.session.finger.featureName === "" ? "–" : panel.session.finger.featureName
        font.pixelSize: Math.max(Theme.headingSize, Math.min(Theme.bigSize, width / (width > 560 ? 14 : 9)))
        font.bold: true
        lineHeight: 0.95
        color: panel.session.finger.featureName === "" ? Theme.quiet : Theme.accent
        Accessible.name: panel.session.finger.featureName === "" ? qsTr("Under the finger: nothing")
                                                          : qsTr("Under the finger: %1").arg(panel.session.finger.featureName)
    }
    TpStatus {
        width: parent.width
        visible: text !== ""
        text: panel.session.device.faultSentence
        color: Theme.finger
    }
    TpStatus {
        width: parent.width
        visible: panel.session.device.name !== ""
        text: qsTr("Device: %1").arg(panel.session.device.name)
        font.pixelSize: Theme.smallSize
        color: Theme.quiet
    }
    TpStatus {
        width: parent.width
        visible: panel.session.touch.name !== ""
        text: qsTr("Ticks: %1").arg(panel.session.touch.name)
        font.pixelSize: Theme.smallSize
        color: Theme.quiet
    }
    TpStatus {
        width: parent.width
        visible: text !== ""
        text: panel.session.words.voiceProblem
        font.pixelSize: Theme.smallSize
        color: Theme.quiet
    }

    Pair {
        Half {
            primary: panel.ready
            text: panel.session.tour.touring ? qsTr("End the tour") : qsTr("Guided tour")
            hint: qsTr("Leads the finger once round the feature. Key: Space")
            onClicked: panel.session.tour.toggle()
        }
        Half {
            text: qsTr("Tour of the face")
            hint: qsTr("Leads the finger round every feature, naming each one first. Key: T")
            onClicked: panel.session.tour.toggleFace()
        }
    }
    Pair {
        Half {
            enabled: true
            text: qsTr("Where am I?")
            hint: qsTr("Says which face and feature, the direction and the distance. Key: W")
            onClicked: panel.session.finger.whereAmI()
        }
        Half {
            text: panel.session.device.engaged ? qsTr("Stop")
                                               : panel.session.touch.name !== "" ? qsTr("Ticks on") : qsTr("Force on")
            hint: panel.session.device.engaged ? qsTr("Stops tour, speech and force. Key: Escape") : qsTr("Key: Enter")
            onClicked: panel.session.stopOrStart()
        }
    }
    Pair {
        Half {
            text: qsTr("Zoom in")
            hint: qsTr("To the face, its eyes, its mouth, and back. Key: Z")
            onClicked: panel.session.zoom.zoomIn()
        }
        Half {
            text: qsTr("Zoom out")
            hint: qsTr("Key: Shift+Z")
            onClicked: panel.session.zoom.zoomOut()
        }
    }
    Pair {
        Half {
            text: qsTr("Next feature")
            hint: qsTr("Puts the finger on it. Key: Tab")
            onClicked: if (!panel.session.hand.stepFeature(1)) panel.session.hand.stepFeature(1)
        }
        Half {
            visible: panel.session.view.faceCount > 1
            text: qsTr("Next face")
            hint: qsTr("Fits one face after another into the touch surface. Key: F")
            onClicked: panel.session.zoom.nextFace()
        }
    }
    Pair {
        Half {
            enabled: true
            text: qsTr("Next photograph")
            hint: qsTr("The next one in the album with a face. Key: N")
            onClicked: panel.session.walk.next()
        }
        Half {
            enabled: true
            text: qsTr("Previous photograph")
            hint: qsTr("Key: Shift+N")
            onClicked: panel.session.walk.previous()
        }
    }
    TpChoice {
        width: parent.width
        label: qsTr("Guide")
        options: panel.session.choices.guideNames
        current: panel.session.choices.guide
        onPicked: (index) => panel.session.choices.guide = index
    }
    TpSlider {
        width: parent.width
        label: qsTr("Strongest force")
        valueText: qsTr("%1 newtons").arg(value.toFixed(1))
        from: 0.1
        to: 1.5
        stepSize: 0.1
        setting: panel.session.choices.maxForce
        onChosen: (value) => panel.session.choices.maxForce = value
    }
    TpToggle {
        width: parent.width
        text: qsTr("Voice")
        on: panel.session.words.voiceOn
        onSwitched: (on) => panel.session.words.voiceOn = on
    }
    TpButton {
        width: parent.width
        primary: !panel.ready
        text: qsTr("Open photograph…")
        hint: qsTr("Key: O")
        onClicked: panel.openAsked()
    }
    KeyHelp {
        id: keys
        width: parent.width
    }
}
