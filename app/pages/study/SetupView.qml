// SPDX-License-Identifier: Apache-2.0
import QtQuick
import QtQuick.Layouts
import TouchPhoto.Controls
import TouchPhoto.Folders
import TouchPhoto.Study

// What the researcher chooses before a participant comes.
TpScroll {
    id: view

    required property StudySession session
    readonly property StudySetup setup: session.setup
    signal openAsked

    function typeNumber() {
        number.forceActiveFocus(Qt.OtherFocusReason)
        number.selectAll()
    }

    margin: 2 * Theme.gap

    component Pair: RowLayout {
        width: parent.width
        spacing: Theme.gap
    }
    component Half: TpButton {
        Layout.fillWidth: true
        Layout.fillHeight: true
        Layout.preferredWidth: 1
    }

    TpStatus {
        objectName: "problem"
        width: parent.width
        visible: text !== ""
        text: view.setup.problem
        color: Theme.finger
    }
    TpChoice {
        width: parent.width
        label: qsTr("Experiment")
        options: view.setup.experiments
        current: view.setup.experiment
        onPicked: (index) => view.setup.choose(index)
    }
    TpStatus {
        width: parent.width
        visible: view.setup.needsFaces
        text: qsTr("Faces: %1").arg(view.setup.faces)
        wrapMode: Text.WrapAnywhere
    }
    TpButton {
        width: parent.width
        visible: view.setup.needsFaces
        text: qsTr("Choose the folder with faces")
        hint: qsTr("Photographs or drawings named after person and expression. Key: G")
        onClicked: view.setup.chooseFaces()
    }
    TpStatus {
        width: parent.width
        text: qsTr("The study's folder: %1").arg(view.setup.folder)
        wrapMode: Text.WrapAnywhere
    }
    Pair {
        Half {
            text: qsTr("Open an experiment's file")
            hint: qsTr("Another experiment is a file, not a program. Key: O")
            onClicked: view.openAsked()
        }
        Half {
            text: qsTr("Choose another folder for the study")
            hint: qsTr("One with this study in it is continued. Key: F")
            onClicked: view.setup.chooseFolder()
        }
    }
    TpStatus {
        objectName: "progress"
        width: parent.width
        visible: text !== ""
        text: view.setup.progress
        font.bold: true
    }
    TpTextField {
        id: number
        objectName: "number"
        width: parent.width
        label: qsTr("The participant's number, in place of a name. Key: N")
        setting: view.setup.participant
        longest: 6
        onEntered: (text) => {
            view.setup.typeParticipant(text)
            number.text = number.setting
            if (number.activeFocus)
                start.forceActiveFocus(Qt.OtherFocusReason)
        }
    }
    Pair {
        Half {
            text: qsTr("Previous participant")
            enabled: view.setup.participant > 1
            hint: qsTr("Key: Minus")
            onClicked: view.setup.setParticipant(view.setup.participant - 1)
        }
        Half {
            text: qsTr("Next participant")
            hint: qsTr("Key: Plus")
            onClicked: view.setup.setParticipant(view.setup.participant + 1)
        }
    }
    TpChoice {
        width: parent.width
        label: qsTr("What moves the finger")
        options: view.setup.hands
        current: view.setup.hand
        onPicked: (index) => view.setup.chooseHand(index)
    }
    TpStatus {
        objectName: "force"
        width: parent.width
        visible: text !== ""
        text: view.setup.force
        wrapMode: Text.Wrap
    }
    TpToggle {
        objectName: "consentToForce"
        width: parent.width
        visible: view.setup.force !== ""
        text: qsTr("I consent to the force that this study asks for")
        on: view.setup.forceAllowed
        onSwitched: (on) => view.setup.setForceAllowed(on)
    }
    TpToggle {
        width: parent.width
        text: qsTr("Show the scene, to try it out; nothing is kept")
        on: view.setup.showScene
        onSwitched: (on) => view.setup.setShowScene(on)
    }
    TpButton {
        id: start
        objectName: "begin"
        width: parent.width
        primary: true
        large: true
        enabled: view.setup.problem === ""
        text: qsTr("Start with participant %1").arg(view.setup.participant)
        hint: qsTr("Asks for consent first. Key: S")
        onClicked: view.session.begin()
    }
    Pair {
        Half {
            text: qsTr("How the study stands")
            hint: qsTr("Trials, errors and times so far, and what is wrong in the folder. Key: C")
            onClicked: view.session.overview.look()
        }
        Half {
            text: qsTr("Make the report")
            hint: qsTr("Tables, plots and a page, beside the study's folder. Key: R")
            onClicked: view.session.overview.makeReport()
        }
    }
    Repeater {
        model: view.session.overview.lines
        delegate: TpStatus {
            required property string modelData
            width: parent ? parent.width : 0
            text: modelData
            wrapMode: Text.Wrap
        }
    }
}
