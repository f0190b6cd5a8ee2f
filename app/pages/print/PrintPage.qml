// SPDX-License-Identifier: Apache-2.0
import QtQuick
import QtQuick.Layouts
import TouchPhoto.Controls
import TouchPhoto.Print

// A tactile sheet before it is printed: the sheet as it will lie on the table, and what can be chosen.
FocusScope {
    id: page

    required property PrintSession session
    readonly property bool wide: width > 1.15 * height
    readonly property string help: qsTr("Choose the paper and the face, then save the sheet as PDF for a printer or as SVG for a drawing program. Swell paper and embossers raise its black lines and dots.")

    GridLayout {
        anchors.fill: parent
        anchors.margins: 2 * Theme.gap
        columns: page.wide ? 2 : 1
        columnSpacing: 2 * Theme.gap
        rowSpacing: 2 * Theme.gap

        Rectangle {
            Layout.fillWidth: true
            Layout.fillHeight: page.wide
            Layout.preferredHeight: page.wide ? -1 : 0.4 * page.height
            color: Theme.panel
            radius: Theme.radius
            Image {
                anchors { fill: parent; margins: Theme.gap }
                source: page.session.sheet.preview
                fillMode: Image.PreserveAspectFit
                Accessible.role: Accessible.Graphic
                Accessible.name: page.session.sheet.ready ? qsTr("The sheet, %1").arg(page.session.sheet.size) : qsTr("No sheet yet")
            }
        }
        ColumnLayout {
            Layout.fillHeight: true
            Layout.fillWidth: !page.wide
            Layout.preferredWidth: page.wide ? 420 * Math.min(1.4, Theme.textScale) : -1
            spacing: 2 * Theme.gap // rings of both have room

            TpScroll {
                Layout.fillHeight: true
                Layout.fillWidth: true
                focus: true
                TpHeading {
                    width: parent.width
                    text: page.session.photo.name === "" ? qsTr("No photograph") : page.session.photo.name
                }
                TpProgress {
                    width: parent.width
                    visible: page.session.photo.looking
                    label: qsTr("Looking for faces")
                    fraction: -1
                }
                TpChoice {
                    width: parent.width
                    label: qsTr("Paper")
                    options: page.session.sheet.papers
                    current: page.session.sheet.paper
                    onPicked: (index) => page.session.sheet.choosePaper(index)
                }
                TpToggle {
                    width: parent.width
                    text: qsTr("Turn by 90 degrees")
                    on: page.session.sheet.landscape
                    onSwitched: (on) => page.session.sheet.setLandscape(on)
                }
                TpChoice {
                    width: parent.width
                    visible: page.session.photo.faces.length > 1
                    label: qsTr("Who")
                    options: page.session.photo.faces
                    current: page.session.sheet.face
                    onPicked: (index) => page.session.sheet.chooseFace(index)
                }
                TpToggle {
                    width: parent.width
                    text: qsTr("Name in print")
                    on: page.session.sheet.titled
                    onSwitched: (on) => page.session.sheet.setTitled(on)
                }
                Repeater {
                    model: page.session.sheet.notes
                    delegate: TpText {
                        required property string modelData
                        width: parent.width
                        text: modelData
                        color: Theme.quiet
                    }
                }
            }
            // Where a hand and an eye find them, however long the list above is.
            RowLayout {
                Layout.fillWidth: true
                Layout.fillHeight: false
                spacing: Theme.gap
                component Store: TpButton {
                    Layout.fillWidth: true
                    Layout.fillHeight: true
                    Layout.preferredWidth: 1
                    enabled: page.session.sheet.ready
                }
                Store {
                    primary: true
                    text: qsTr("Save as PDF")
                    onClicked: page.session.store("pdf")
                }
                Store {
                    text: qsTr("Save as SVG")
                    onClicked: page.session.store("svg")
                }
            }
        }
    }
}
