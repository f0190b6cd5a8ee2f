// SPDX-License-Identifier: Apache-2.0
import QtQuick
import QtQuick.Layouts
import TouchPhoto.Capture
import TouchPhoto.Controls

// Words and buttons. It scrolls where a small window or large text needs more room.
TpScroll {
    id: panel

    required property CaptureSession session
    readonly property bool on: session.camera.state === CaptureCamera.On
    readonly property bool failed: session.camera.state === CaptureCamera.Failed
    readonly property alias help: keys.text
    property bool holdsSurface: false  // on a small page the view scrolls with the rest …
    readonly property alias slot: slot // … and lies here, never so high that there is no room left to scroll by

    component Pair: RowLayout {
        width: parent.width
        spacing: Theme.gap
    }
    component Half: TpButton {
        Layout.fillWidth: true
        Layout.fillHeight: true
        Layout.preferredWidth: 1
    }

    Item {
        id: slot
        width: parent.width
        height: Math.min(0.75 * width, 0.6 * panel.height)
        visible: panel.holdsSurface
    }
    TpStatus {
        width: parent.width
        height: 2.4 * Theme.headingSize // the buttons below keep their place
        fontSizeMode: Text.Fit
        minimumPixelSize: Theme.smallSize
        verticalAlignment: Text.AlignVCenter
        wrapMode: Text.Wrap
        label: qsTr("What to do")
        text: panel.session.aiming.advice === "" ? "–" : panel.session.aiming.advice
        font.pixelSize: 1.4 * Theme.headingSize
        font.bold: true
        color: panel.on ? Theme.accent : Theme.quiet
    }
    Pair {
        visible: panel.failed
        Half {
            primary: true
            text: qsTr("Import photographs")
            hint: qsTr("Of another camera, into your album. Key: I")
            onClicked: panel.session.importInstead()
        }
        Half {
            text: qsTr("Try again")
            hint: qsTr("Key: R")
            onClicked: panel.session.tryAgain()
        }
    }
    TpStatus {
        width: parent.width
        visible: text !== ""
        label: qsTr("Last photograph")
        text: panel.session.shutter.taken
        wrapMode: Text.Wrap
    }
    TpButton {
        width: parent.width
        primary: panel.on
        large: true
        enabled: panel.on
        text: qsTr("Take the photograph")
        hint: qsTr("Also by a touch on the camera view. Key: Space")
        onClicked: panel.session.take()
    }
    Pair {
        Half {
            enabled: panel.session.shutter.taken !== ""
            text: panel.session.memo.running ? qsTr("Finish the memo") : qsTr("Record a memo")
            hint: qsTr("For the photograph that was taken last. Key: M")
            onClicked: panel.session.recordMemo()
        }
        Half {
            enabled: panel.session.shutter.canUndo
            text: qsTr("Undo")
            hint: qsTr("Deletes the photograph again. Key: Control+Z")
            onClicked: panel.session.shutter.undo()
        }
    }
    Pair {
        visible: panel.session.shutter.count > 1
        Half {
            text: qsTr("Next frame of the burst")
            hint: qsTr("Steps through the frames before and after it. Key: N; back: P")
            onClicked: panel.session.shutter.look(1)
        }
        Half {
            enabled: panel.session.shutter.shown >= 0
            text: qsTr("Keep this one too")
            hint: qsTr("Key: K")
            onClicked: panel.session.shutter.keepShown()
        }
    }
    TpButton {
        width: parent.width
        enabled: panel.on
        text: qsTr("What is in view?")
        hint: qsTr("Says who is in the picture and what to do. Key: W")
        onClicked: panel.session.tellAll()
    }
    TpChoice {
        width: parent.width
        label: qsTr("Aim")
        options: panel.session.choices.aims
        current: panel.session.choices.aim
        onPicked: (index) => panel.session.choices.chooseAim(index)
    }
    TpToggle {
        width: parent.width
        text: qsTr("Take it automatically when all is well")
        on: panel.session.choices.byItself
        onSwitched: (on) => panel.session.choices.setByItself(on)
    }
    TpToggle {
        width: parent.width
        text: qsTr("Keep the sound of the moment")
        on: panel.session.choices.moment
        onSwitched: (on) => panel.session.choices.setMoment(on)
    }
    TpStatus {
        width: parent.width
        visible: panel.session.moment.hears
        text: qsTr("The microphone is on.")
        color: Theme.finger
    }
    TpButton {
        width: parent.width
        visible: panel.session.camera.both
        text: panel.session.camera.front ? qsTr("Back camera") : qsTr("Front camera")
        hint: qsTr("Key: C")
        onClicked: panel.session.turnRound()
    }
    TpToggle {
        width: parent.width
        visible: panel.session.camera.torch
        text: qsTr("Light")
        on: panel.session.camera.lit
        onSwitched: (on) => panel.session.setLight(on)
    }
    TpText {
        id: keys
        width: parent.width
        text: [qsTr("Point the camera at somebody and do what is said. A tone says where to move the camera: faster is nearer, high is up, and it comes from the side to move to. It rises when all is well. Where ticks are chosen as the guide, they are felt too: faster and stronger is nearer."),
               qsTr("Space, or a touch on the camera view: take the photograph. Then M: record a memo, and M again to finish it. N, P: look through the other frames; K: keep one. Control+Z: undo."),
               qsTr("1 to 4: aim at one face in the middle, one by thirds, head and shoulders, everybody. W: what is seen. S: take it automatically or not. A: with the sound of the moment or without. C: other camera. L: light. Escape: silence."),
               panel.session.camera.movedByKeys ? qsTr("This camera is simulated. Arrow keys turn it, Page up and Page down move it closer and back, Shift with left and right tilts it.") : ""].join("\n\n").trim()
        font.pixelSize: Theme.smallSize
        color: Theme.quiet
    }
}
