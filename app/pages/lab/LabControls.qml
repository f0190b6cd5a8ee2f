// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Lab

// Everything that can be turned, section by section.
Column {
    id: controls

    required property LabSession session
    readonly property LabTuning tuning: session.tuning
    readonly property bool free: !session.activity.fixed
    readonly property bool exact: tuning.law === 0
    readonly property bool simulated: session.devices.simulated
    signal openAsked

    spacing: Theme.gap

    TpHeading { width: parent.width; topPadding: Theme.gap; text: qsTr("What is felt") }
    TpChoice {
        objectName: "scene"
        width: parent.width
        enabled: controls.free
        label: qsTr("Scene")
        options: controls.session.scene.names
        current: controls.session.scene.current
        onPicked: (index) => controls.session.scene.choose(index)
    }
    TpButton {
        width: parent.width
        enabled: controls.free
        text: qsTr("Open photograph…")
        hint: qsTr("Key: O. One can be dropped on the page too")
        onClicked: controls.openAsked()
    }

    TpHeading { width: parent.width; topPadding: Theme.gap; text: qsTr("Guidance") }
    TpChoice {
        objectName: "law"
        width: parent.width
        enabled: controls.free
        label: qsTr("Law")
        options: controls.tuning.laws
        current: controls.tuning.law
        onPicked: (index) => controls.tuning.chooseLaw(index)
    }
    LabSlider { width: parent.width; tuning: controls.tuning; key: "stiffness"; enabled: controls.free; label: qsTr("Stiffness K") }
    LabSlider { width: parent.width; tuning: controls.tuning; key: "range"; enabled: controls.free; label: qsTr("Range d") }
    LabSlider {
        width: parent.width
        tuning: controls.tuning
        key: "hold"
        enabled: controls.free && controls.exact
        label: qsTr("Hysteresis at switches")
    }
    LabSlider {
        width: parent.width
        tuning: controls.tuning
        key: "blend"
        enabled: controls.free && controls.exact
        label: qsTr("Blending at switches")
    }
    LabToggle {
        width: parent.width
        tuning: controls.tuning
        key: "cornerCue"
        enabled: controls.free && controls.exact
        text: qsTr("Corner cue")
    }
    LabSlider {
        width: parent.width
        tuning: controls.tuning
        key: "vertexSpacing"
        enabled: controls.free && !controls.exact
        label: qsTr("Spacing of vertices")
    }

    TpHeading { width: parent.width; topPadding: Theme.gap; text: qsTr("Servo") }
    LabSlider { width: parent.width; tuning: controls.tuning; key: "maxForce"; enabled: controls.free; label: qsTr("Strongest force") }
    LabSlider { width: parent.width; tuning: controls.tuning; key: "lineDamping"; enabled: controls.free; label: qsTr("Damping across a line") }
    LabToggle { width: parent.width; tuning: controls.tuning; key: "energyObserver"; enabled: controls.free; text: qsTr("Energy observer") }
    LabToggle {
        width: parent.width
        tuning: controls.tuning
        key: "strictLimits"
        enabled: controls.free && controls.simulated
        text: qsTr("Limits of a real device")
    }

    TpHeading { width: parent.width; topPadding: Theme.gap; text: qsTr("Device") }
    TpChoice {
        objectName: "device"
        width: parent.width
        enabled: controls.free
        label: qsTr("Device")
        options: controls.session.devices.names
        current: controls.session.devices.current
        onPicked: (index) => controls.session.devices.choose(index)
    }
    TpButton {
        width: parent.width
        enabled: controls.free
        text: qsTr("Look for devices again")
        onClicked: controls.session.devices.find()
    }
    TpButton {
        width: parent.width
        enabled: controls.free
        text: qsTr("Set the strongest force of real devices")
        hint: qsTr("Opens the settings")
        onClicked: controls.session.pageAsked("settings")
    }
    Repeater {
        model: [["mass", qsTr("Mass")], ["damping", qsTr("Damping of the device")], ["friction", qsTr("Dry friction")],
                ["quantum", qsTr("Encoder step")], ["delay", qsTr("Delay")], ["handStiffness", qsTr("Grip of the hand")],
                ["handDamping", qsTr("Damping of the hand")]]
        delegate: LabSlider {
            required property var modelData
            width: controls.width
            tuning: controls.tuning
            key: modelData[0]
            enabled: controls.free && controls.simulated
            label: modelData[1]
        }
    }

    TpHeading { width: parent.width; topPadding: Theme.gap; text: qsTr("Faults of the simulated device") }
    LabSlider {
        width: parent.width
        tuning: controls.tuning
        key: "drop"
        enabled: controls.free && controls.simulated
        label: qsTr("Missing readings")
    }
    Repeater {
        model: [["silent", qsTr("No readings at all")], ["refuses", qsTr("Accepts no force")],
                ["motorsOff", qsTr("Motors switch themselves off")], ["unplugged", qsTr("Unplugged")]]
        delegate: LabToggle {
            required property var modelData
            width: controls.width
            tuning: controls.tuning
            key: modelData[0]
            enabled: controls.free && controls.simulated
            text: modelData[1]
        }
    }
    TpButton {
        width: parent.width
        enabled: controls.simulated && controls.session.activity.running
        text: qsTr("Hang for 200 milliseconds")
        onClicked: controls.session.servo.hang()
    }

    TpHeading { width: parent.width; topPadding: Theme.gap; text: qsTr("All parameters") }
    TpButton {
        objectName: "undo"
        width: parent.width
        enabled: controls.free && controls.tuning.undoable !== ""
        text: controls.tuning.undoable === "" ? qsTr("Nothing to undo") : qsTr("Undo: %1").arg(controls.tuning.undoable)
        hint: qsTr("Key: Control+Z")
        onClicked: controls.tuning.undo()
    }
    TpButton {
        objectName: "reset"
        width: parent.width
        enabled: controls.free
        text: qsTr("Reset all parameters")
        hint: qsTr("Can be undone")
        onClicked: controls.tuning.reset()
    }

    TpHeading { width: parent.width; topPadding: Theme.gap; text: qsTr("Files") }
    TpText {
        width: parent.width
        text: qsTr("In %1").arg(controls.session.files.folder)
        color: Theme.quiet
        wrapMode: Text.WrapAnywhere
    }
    TpButton {
        objectName: "table"
        width: parent.width
        text: qsTr("Save the plots as a table")
        hint: qsTr("CSV, with the parameters as JSON beside it")
        onClicked: controls.session.files.writeTable()
    }
    TpText {
        width: parent.width
        visible: controls.session.files.recordings.length === 0
        text: qsTr("No recordings yet.")
    }
    Repeater {
        model: controls.session.files.recordings
        delegate: TpListRow {
            required property int index
            required property string modelData
            width: controls.width
            enabled: !controls.session.activity.recording
            text: qsTr("Replay %1").arg(modelData)
            position: index + 1
            count: controls.session.files.recordings.length
            onClicked: controls.session.playback.replay(index)
        }
    }
}
