// SPDX-License-Identifier: Apache-2.0
import QtQuick
import QtQuick.Layouts
import TouchPhoto.Controls
import TouchPhoto.Study

// A sitting: how far it is and what can be done; nothing that would tell the participant what is felt.
FocusScope {
    id: view

    required property StudySession session
    readonly property StudyRun run: session.run
    readonly property int now: run.state
    readonly property bool wide: width > 1.15 * height && width >= 640 * Theme.textScale
    readonly property bool waits: now === StudyRun.Ready || now === StudyRun.Break || now === StudyRun.Paused
                                  || now === StudyRun.Stopping || now === StudyRun.Done

    // What had the keyboard may be gone with the state that it belonged to.
    onNowChanged: if (!surface.activeFocus && (now === StudyRun.Ready || now === StudyRun.Answering)) surface.forceActiveFocus()

    GridLayout {
        anchors { fill: parent; margins: 2 * Theme.gap }
        columns: view.wide ? 2 : 1
        columnSpacing: 2 * Theme.gap
        rowSpacing: 2 * Theme.gap

        StudySurface {
            id: surface
            objectName: "surface"
            session: view.session
            focus: true
            Layout.fillWidth: true
            Layout.fillHeight: view.wide
            Layout.preferredHeight: view.wide ? -1 : 0.35 * view.height
        }
        TpScroll {
            id: panel
            Layout.fillHeight: true
            Layout.fillWidth: !view.wide
            Layout.preferredWidth: view.wide ? Math.min(520 * Theme.textScale, 0.55 * view.width) : -1

            TpStatus {
                objectName: "trial"
                width: parent.width
                visible: text !== ""
                text: view.run.trial
                font.pixelSize: 1.4 * Theme.headingSize
                font.bold: true
            }
            TpStatus {
                objectName: "status"
                width: parent.width
                text: view.run.status
                color: Theme.accent
            }
            TpText {
                width: parent.width
                visible: view.run.trying
                text: qsTr("This is tried out. Nothing is kept.")
            }
            TpProgress {
                width: parent.width
                visible: view.run.progress !== ""
                label: view.run.progress
                fraction: view.run.fraction
            }
            TpText {
                objectName: "consent"
                width: parent.width
                visible: text !== ""
                text: view.run.consent
            }
            TpButton {
                width: parent.width
                visible: view.now === StudyRun.Consent
                primary: true
                text: qsTr("I agree")
                hint: qsTr("Key: Enter")
                onClicked: view.run.agree()
            }
            Repeater {
                model: view.run.answers
                delegate: TpButton {
                    required property int index
                    required property string modelData
                    width: panel.width
                    text: qsTr("%1: %2").arg(index + 1).arg(modelData)
                    onClicked: view.run.answer(index)
                }
            }
            TpButton {
                width: parent.width
                visible: view.waits || view.now === StudyRun.Feeling
                primary: true
                text: view.now === StudyRun.Ready ? qsTr("Start the trial")
                    : view.now === StudyRun.Feeling ? qsTr("End the trial")
                    : view.now === StudyRun.Done ? qsTr("End") : qsTr("Go on")
                hint: qsTr("Key: Space")
                onClicked: view.run.goOn()
            }
            TpButton {
                width: parent.width
                visible: view.now === StudyRun.Ready || view.now === StudyRun.Feeling || view.now === StudyRun.Answering
                text: qsTr("Pause")
                hint: qsTr("The force is off at once. Key: P")
                onClicked: view.run.pause()
            }
            TpButton {
                width: parent.width
                text: view.now === StudyRun.Consent ? qsTr("I do not agree") : qsTr("Stop")
                hint: qsTr("Key: Escape")
                onClicked: view.session.stop()
            }
        }
    }
}
