// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Folders
import TouchPhoto.Study

// A study: set up by the researcher, then done by the participant, who sees nothing of what is felt.
FocusScope {
    id: page

    required property StudySession session
    readonly property StudySetup setup: session.setup
    readonly property StudyRun run: session.run
    readonly property bool active: Window.active
    readonly property string help: run.running
        ? qsTr("Space starts and ends a trial, and goes on after a break. A number key gives an answer. Arrow keys move the hand by 2 millimetres, with Shift by 10, where no device does. P pauses, W says where you are. Escape stops; the force is then off at once.")
        : qsTr("Keys 1 to 9: experiment. O: an experiment's file. F: the study's folder. G: the folder with faces. N, Minus and Plus: participant. M: what moves the finger. L: consent to the force that the study needs. S: start. C: how the study stands. R: makes its report. W: says where you are.")

    onActiveChanged: session.setActive(active)

    function openDialog() {
        dialog.active = true
        if (dialog.item !== null)
            dialog.item.open()
    }
    function setsUp(event) {
        if (setup.choosing)
            return false
        const number = event.key - Qt.Key_1
        switch (event.key) {
        case Qt.Key_O: page.openDialog(); break
        case Qt.Key_F: setup.chooseFolder(); break
        case Qt.Key_G: setup.chooseFaces(); break
        case Qt.Key_Minus: setup.setParticipant(setup.participant - 1); break
        case Qt.Key_Plus: setup.setParticipant(setup.participant + 1); break
        case Qt.Key_N: loader.item.typeNumber(); break
        case Qt.Key_C: session.overview.look(); break
        case Qt.Key_R: session.overview.makeReport(); break
        case Qt.Key_M: setup.chooseHand((setup.hand + 1) % setup.hands.length); break
        case Qt.Key_L: setup.setForceAllowed(!setup.forceAllowed); break
        case Qt.Key_S: session.begin(); break
        case Qt.Key_W: session.tellWhere(); break
        default:
            if (number < 0 || number > 8)
                return false
            setup.choose(number)
        }
        return true
    }
    function runs(event) {
        const far = event.modifiers & Qt.ShiftModifier ? 10 : 2
        const number = event.key - Qt.Key_1
        switch (event.key) {
        case Qt.Key_Space:
            if (!event.isAutoRepeat)
                run.goOn()
            break
        case Qt.Key_Return:
        case Qt.Key_Enter:
            if (!event.isAutoRepeat)
                run.agree()
            break
        case Qt.Key_P: run.pause(); break
        case Qt.Key_W: session.tellWhere(); break
        case Qt.Key_Left: session.moveBy(-far, 0); break
        case Qt.Key_Right: session.moveBy(far, 0); break
        case Qt.Key_Up: session.moveBy(0, -far); break
        case Qt.Key_Down: session.moveBy(0, far); break
        default:
            if (number < 0 || number > 8)
                return false
            run.answer(number)
        }
        return true
    }
    Keys.onPressed: (event) => {
        if (event.key === Qt.Key_Escape)
            event.accepted = event.isAutoRepeat || session.stop()
        else if (event.modifiers & (Qt.ControlModifier | Qt.AltModifier | Qt.MetaModifier))
            event.accepted = false
        else
            event.accepted = run.running ? page.runs(event) : page.setsUp(event)
    }

    Loader {
        id: loader
        anchors.fill: parent
        focus: true
        sourceComponent: page.run.running ? sitting : page.setup.choosing ? choosing : settingUp
        onLoaded: item.forceActiveFocus()
    }
    Component {
        id: settingUp
        SetupView {
            session: page.session
            onOpenAsked: page.openDialog()
        }
    }
    Component {
        id: sitting
        RunView { session: page.session }
    }
    Component {
        id: choosing
        TpScroll {
            margin: 2 * Theme.gap
            FolderChooserView {
                width: parent.width
                focus: true
                chooser: page.setup.chooser
            }
        }
    }
    Loader {
        id: dialog
        active: false
        source: "ExperimentDialog.qml"
    }
    Connections {
        target: dialog.item
        function onChosen(file) { page.setup.openFile(file) }
    }
}
