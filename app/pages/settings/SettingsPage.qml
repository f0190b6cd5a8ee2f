// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Folders
import TouchPhoto.Settings

// What a person can choose, section by section.
FocusScope {
    id: page

    required property SettingsSession session
    readonly property string help: qsTr("Tab moves from setting to setting, Space or Enter changes one, the arrow keys move a slider. Control+Z undoes the last change. Every change is saved at once.")

    Keys.onPressed: (event) => {
        if (event.key === Qt.Key_Z && event.modifiers === Qt.ControlModifier)
            session.steps.undo()
        else if (event.key === Qt.Key_Escape || event.key === Qt.Key_Backspace)
            event.accepted = session.back()
        else
            event.accepted = false
    }

    TpScroll {
        anchors.fill: parent
        focus: page.session.storage.choosing
        visible: page.session.storage.choosing
        enabled: visible
        margin: 2 * Theme.gap
        Loader {
            width: parent.width
            active: page.session.storage.choosing
            focus: true
            sourceComponent: FolderChooserView { chooser: page.session.storage.chooser }
            onLoaded: item.forceActiveFocus()
        }
    }
    Loader {
        anchors.fill: parent
        active: page.session.devices.calibrating
        sourceComponent: CalibrationView { devices: page.session.devices }
        onLoaded: item.forceActiveFocus()
    }
    Loader {
        anchors.fill: parent
        active: page.session.devices.measuring
        sourceComponent: MeasuringView { devices: page.session.devices }
        onLoaded: item.forceActiveFocus()
    }
    TpScroll {
        readonly property bool alone: !page.session.storage.choosing && !page.session.devices.calibrating && !page.session.devices.measuring
        anchors.fill: parent
        focus: alone
        visible: alone
        enabled: visible
        margin: 2 * Theme.gap

        TpHeading { width: parent.width; text: qsTr("Speech and sound") }
        TpChoice {
            objectName: "voice"
            width: parent.width
            label: qsTr("Who speaks")
            options: page.session.speech.voices
            current: page.session.speech.voice
            onPicked: (index) => page.session.speech.chooseVoice(index)
        }
        TpChoice {
            objectName: "rate"
            width: parent.width
            label: qsTr("Speed of speech")
            options: page.session.speech.rates
            current: page.session.speech.rate
            onPicked: (index) => page.session.speech.chooseRate(index)
        }
        TpChoice {
            objectName: "language"
            width: parent.width
            label: qsTr("Language")
            options: page.session.speech.languages
            current: page.session.speech.language
            onPicked: (index) => page.session.speech.chooseLanguage(index)
        }
        TpSlider {
            width: parent.width
            label: qsTr("Speed of recordings")
            valueText: qsTr("%1 times").arg(Number(value).toLocaleString(Qt.locale(), 'f', 2))
            from: 0.5
            to: 2
            stepSize: 0.25
            setting: page.session.speech.playbackSpeed
            onChosen: (value) => page.session.speech.setPlaybackSpeed(value)
        }
        TpToggle {
            objectName: "earcons"
            width: parent.width
            text: qsTr("Sound effects")
            on: page.session.speech.earcons
            onSwitched: (on) => page.session.speech.setEarcons(on)
        }
        TpChoice {
            objectName: "descriptions"
            width: parent.width
            label: qsTr("Descriptions of photographs")
            options: page.session.speech.descriptionLengths
            current: page.session.speech.descriptions
            onPicked: (index) => page.session.speech.chooseDescriptions(index)
        }
        TpChoice {
            objectName: "describedFirst"
            width: parent.width
            label: qsTr("What is said first")
            options: page.session.speech.firstThings
            current: page.session.speech.describedFirst
            onPicked: (index) => page.session.speech.chooseDescribedFirst(index)
        }

        TpHeading { width: parent.width; topPadding: Theme.gap; text: qsTr("Appearance") }
        TpChoice {
            objectName: "theme"
            width: parent.width
            label: qsTr("Colours")
            options: page.session.looks.themes
            current: page.session.looks.theme
            onPicked: (index) => page.session.looks.chooseTheme(index)
        }
        TpSlider {
            objectName: "textScale"
            width: parent.width
            label: qsTr("Text size")
            valueText: qsTr("%1 percent").arg(Math.round(100 * value))
            from: 1
            to: 2
            stepSize: 0.25
            setting: page.session.looks.textScale
            onChosen: (value) => page.session.looks.setTextScale(value)
        }
        TpToggle {
            width: parent.width
            text: qsTr("Animations")
            on: page.session.looks.motion
            onSwitched: (on) => page.session.looks.setMotion(on)
        }
        TpChoice {
            width: parent.width
            label: qsTr("Who uses the tablet most")
            options: page.session.looks.users
            current: page.session.looks.user
            onPicked: (index) => page.session.looks.chooseUser(index)
        }

        TpHeading { width: parent.width; topPadding: Theme.gap; text: qsTr("What is felt") }
        TpSlider {
            objectName: "maxForce"
            width: parent.width
            label: qsTr("Strongest force")
            valueText: qsTr("%1 newtons").arg(Number(value).toLocaleString(Qt.locale(), 'f', 1))
            from: 0.1
            to: 1.5
            stepSize: 0.1
            setting: page.session.feeling.maxForce
            onChosen: (value) => page.session.feeling.setMaxForce(value)
        }
        TpChoice {
            objectName: "device"
            width: parent.width
            label: qsTr("Force device")
            options: page.session.devices.names
            current: page.session.devices.current
            onPicked: (index) => page.session.feeling.chooseDevice(index)
        }
        TpStatus {
            width: parent.width
            visible: text !== ""
            label: qsTr("Calibration")
            text: page.session.devices.calibration
            wrapMode: Text.Wrap
        }
        TpButton {
            objectName: "calibrate"
            width: parent.width
            visible: page.session.devices.there
            text: qsTr("Calibrate the device on this screen")
            hint: qsTr("You touch the four corners of the screen with the device")
            onClicked: page.session.devices.calibrate()
        }
        TpButton {
            objectName: "home"
            width: parent.width
            visible: page.session.devices.there
            text: qsTr("Home the device")
            hint: qsTr("Put its handle on the mark first, and leave it there")
            onClicked: page.session.devices.home()
        }
        TpButton {
            objectName: "measure"
            width: parent.width
            visible: page.session.devices.measurable
            text: qsTr("Measure the stick")
            hint: qsTr("How strong it is and which way it pulls. You need a kitchen scale or a luggage scale")
            onClicked: page.session.devices.measure()
        }
        TpButton {
            objectName: "tryForce"
            width: parent.width
            visible: page.session.devices.there
            text: qsTr("Try the strongest force")
            hint: qsTr("The device pulls to the right and to the left for less than three seconds. Escape ends it")
            onClicked: page.session.devices.tryForce()
        }
        TpButton {
            width: parent.width
            text: qsTr("Try the force on a face")
            onClicked: page.session.pageAsked("explore")
        }
        TpChoice {
            width: parent.width
            label: qsTr("Guide when there is no force")
            options: page.session.feeling.guides
            current: page.session.feeling.guide
            onPicked: (index) => page.session.feeling.chooseGuide(index)
        }
        TpChoice {
            objectName: "ticks"
            width: parent.width
            visible: page.session.ticks.names.length > 0
            label: qsTr("What ticks under the finger")
            options: page.session.ticks.names
            current: page.session.ticks.current
            onPicked: (index) => page.session.ticks.choose(index)
        }
        TpSlider {
            objectName: "tickStrength"
            width: parent.width
            label: qsTr("Strength of ticks")
            valueText: qsTr("%1 percent").arg(Math.round(100 * value))
            from: 0.1
            to: 1
            stepSize: 0.1
            setting: page.session.ticks.strength
            onChosen: (value) => page.session.ticks.setStrength(value)
        }
        TpSlider {
            objectName: "tickSharpness"
            width: parent.width
            label: qsTr("Sharpness of ticks")
            valueText: qsTr("%1 percent").arg(Math.round(100 * value))
            from: 0
            to: 1
            stepSize: 0.1
            setting: page.session.ticks.sharpness
            onChosen: (value) => page.session.ticks.setSharpness(value)
        }
        TpSlider {
            objectName: "tickLatency"
            width: parent.width
            label: qsTr("How late ticks are felt")
            valueText: qsTr("%1 milliseconds").arg(Math.round(1000 * value))
            from: 0
            to: 0.15
            stepSize: 0.005
            setting: page.session.ticks.latency
            onChosen: (value) => page.session.ticks.setLatency(value)
        }
        TpButton {
            objectName: "feelTick"
            width: parent.width
            text: qsTr("Feel a tick now")
            onClicked: page.session.ticks.feelIt()
        }
        TpButton {
            objectName: "measureTicks"
            width: parent.width
            text: page.session.ticks.measuring ? qsTr("I feel it") : qsTr("Measure how late ticks are felt")
            hint: page.session.ticks.measuring ? qsTr("Key: Space") : qsTr("You press Space when you feel a tick")
            onClicked: page.session.ticks.measuring ? page.session.ticks.tap() : page.session.ticks.measure()
        }
        TpToggle {
            width: parent.width
            text: qsTr("Brows")
            on: page.session.feeling.brows
            onSwitched: (on) => page.session.feeling.setBrows(on)
        }
        TpToggle {
            width: parent.width
            text: qsTr("Nose")
            on: page.session.feeling.nose
            onSwitched: (on) => page.session.feeling.setNose(on)
        }
        TpToggle {
            width: parent.width
            text: qsTr("Irises")
            on: page.session.feeling.irises
            onSwitched: (on) => page.session.feeling.setIrises(on)
        }

        TpHeading { width: parent.width; topPadding: Theme.gap; text: qsTr("Folders of the album") }
        TpText {
            width: parent.width
            visible: page.session.storage.folders.length === 0
            text: qsTr("No folder yet.")
        }
        Repeater {
            model: page.session.storage.folders
            delegate: Column {
                id: folder
                required property int index
                required property string modelData
                width: parent.width
                spacing: 6
                TpText {
                    width: parent.width
                    text: folder.modelData
                    wrapMode: Text.WrapAnywhere
                }
                TpButton {
                    width: parent.width
                    text: qsTr("Remove %1 from the album").arg(folder.modelData.split("/").pop())
                    hint: qsTr("The photographs stay where they are")
                    onClicked: page.session.storage.removeFolder(folder.index)
                }
            }
        }
        TpButton {
            objectName: "addFolder"
            width: parent.width
            text: qsTr("Add a folder")
            onClicked: page.session.storage.addFolder()
        }

        TpHeading { width: parent.width; topPadding: Theme.gap; text: qsTr("What is stored about me") }
        TpToggle {
            objectName: "knowFaces"
            width: parent.width
            text: qsTr("Compare faces, to offer names")
            on: page.session.storage.knowFaces
            onSwitched: (on) => page.session.storage.setKnowFaces(on)
        }
        Repeater {
            model: page.session.storage.stored
            delegate: TpText {
                required property string modelData
                width: parent.width
                text: modelData
                wrapMode: Text.Wrap
            }
        }
        TpButton {
            width: parent.width
            text: qsTr("Rebuild the index")
            onClicked: page.session.storage.discardIndex()
        }

        TpHeading { width: parent.width; topPadding: Theme.gap; text: qsTr("All settings") }
        TpButton {
            objectName: "undo"
            width: parent.width
            enabled: page.session.steps.undoable !== ""
            text: page.session.steps.undoable === "" ? qsTr("Nothing to undo") : qsTr("Undo: %1").arg(page.session.steps.undoable)
            hint: qsTr("Key: Control+Z")
            onClicked: page.session.steps.undo()
        }
        TpButton {
            width: parent.width
            text: qsTr("Ask me the five questions again")
            onClicked: page.session.questionsAsked()
        }
        TpButton {
            objectName: "reset"
            width: parent.width
            text: qsTr("Reset all settings")
            hint: qsTr("The album's folders stay. Can be undone")
            onClicked: page.session.steps.reset()
        }
    }
}
