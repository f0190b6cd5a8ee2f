// SPDX-License-Identifier: Apache-2.0
import QtQuick
import QtQuick.Layouts
import TouchPhoto.Controls
import TouchPhoto.Explore

// Words and buttons. It scrolls where a small window or large text needs more room.
FocusScope {
    id: panel

    required property ExploreSession session
    readonly property bool ready: session.state === ExploreSession.Ready
    readonly property Item focused: Window.activeFocusItem
    signal openAsked

    // What the keyboard comes to is brought into view.
    onFocusedChanged: {
        for (let item = focused; item; item = item.parent)
            if (item === column) {
                const top = focused.mapToItem(column, 0, 0).y
                flickable.contentY = Math.max(Math.min(flickable.contentY, top - Theme.gap),
                                              top + focused.height + Theme.gap - flickable.height)
            }
    }

    Flickable {
        id: flickable
        anchors.fill: parent
        contentHeight: column.implicitHeight
        clip: contentHeight > height
        boundsBehavior: Flickable.StopAtBounds

        ColumnLayout {
            id: column
            width: parent.width
            spacing: Theme.gap

            TpHeading {
                Layout.fillWidth: true
                text: panel.session.photoName === "" ? "TouchPhoto" : panel.session.photoName
                elide: Text.ElideMiddle
                wrapMode: Text.NoWrap
            }
            TpStatus {
                Layout.fillWidth: true
                Layout.minimumHeight: 2.4 * Theme.bigSize
                verticalAlignment: Text.AlignVCenter
                label: "Under the finger"
                text: panel.session.featureName === "" ? "–" : panel.session.featureName
                font.pixelSize: Theme.bigSize
                font.bold: true
                lineHeight: 0.95
                color: panel.session.featureName === "" ? Theme.quiet : Theme.accent
                Accessible.name: "Under the finger: " + (panel.session.featureName === "" ? "nothing" : panel.session.featureName)
            }
            TpStatus {
                Layout.fillWidth: true
                Layout.minimumHeight: 3.8 * Theme.textSize
                text: panel.session.sentence
                color: panel.session.state === ExploreSession.Problem ? Theme.accent : Theme.text
            }
            TpStatus {
                Layout.fillWidth: true
                visible: text !== ""
                text: panel.session.faultSentence
                color: Theme.finger
            }
            TpStatus {
                Layout.fillWidth: true
                visible: text !== ""
                text: panel.session.voiceProblem
                font.pixelSize: Theme.smallSize
                color: Theme.quiet
            }

            TpButton {
                Layout.fillWidth: true
                primary: panel.ready
                enabled: panel.ready
                text: panel.session.touring ? "End the tour" : "Guided tour"
                hint: "Leads the finger once round the feature. Key: Space"
                onClicked: panel.session.toggleTour()
            }
            RowLayout {
                Layout.fillWidth: true
                spacing: Theme.gap
                TpButton {
                    Layout.fillWidth: true
                    Layout.preferredWidth: 1
                    enabled: panel.ready
                    text: "Where am I?"
                    hint: "Key: W"
                    onClicked: panel.session.whereAmI()
                }
                TpButton {
                    Layout.fillWidth: true
                    Layout.preferredWidth: 1
                    enabled: panel.ready
                    text: panel.session.engaged ? "Stop" : "Force on"
                    hint: panel.session.engaged ? "Ends tour, speech and force. Key: Escape" : "Key: Enter"
                    onClicked: panel.session.stopOrStart()
                }
            }
            RowLayout {
                Layout.fillWidth: true
                spacing: Theme.gap
                TpButton {
                    Layout.fillWidth: true
                    Layout.preferredWidth: 1
                    enabled: panel.ready
                    text: "Next feature"
                    hint: "Sets the finger down on it. Key: Tab"
                    onClicked: if (!panel.session.stepFeature(1)) panel.session.stepFeature(1)
                }
                TpButton {
                    Layout.fillWidth: true
                    Layout.preferredWidth: 1
                    visible: panel.session.faceCount > 1
                    enabled: panel.ready
                    text: "Next face"
                    hint: "Fits one face after the other into the surface. Key: F"
                    onClicked: panel.session.nextFace()
                }
            }
            TpSlider {
                Layout.fillWidth: true
                label: "Strongest force"
                valueText: value.toFixed(1) + " newtons"
                from: 0.1
                to: 1.5
                stepSize: 0.1
                setting: panel.session.maxForce
                onChosen: (value) => panel.session.maxForce = value
            }
            TpToggle {
                Layout.fillWidth: true
                text: "Voice"
                on: panel.session.voiceOn
                onSwitched: (on) => panel.session.voiceOn = on
            }
            TpButton {
                Layout.fillWidth: true
                primary: !panel.ready
                text: "Open photograph…"
                hint: "Key: O"
                onClicked: panel.openAsked()
            }
        }
    }
}
