// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls

Column {
    id: gallery
    width: 400
    spacing: 10

    readonly property var theme: Theme
    readonly property string photos: PhotoPatterns.all
    property int presses: 0
    property bool wanted: false
    property real picked: 0.5
    property string words: "Anna"
    property string story: "In the garden"
    property int keystrokes: 0
    property int choice: 1
    property var reachedLetters: []
    property string spelt: ""

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
    TpListRow {
        objectName: "row"
        width: parent.width
        text: "Anna"
        detail: "12 photographs"
        position: 2
        count: 9
        onClicked: gallery.presses += 1
    }
    TpTextField {
        objectName: "field"
        width: parent.width
        label: "A field"
        setting: gallery.words
        onEntered: (text) => gallery.words = text
        onTyped: gallery.keystrokes += 1
    }
    TpTextArea {
        objectName: "area"
        width: parent.width
        label: "An area"
        setting: gallery.story
        onEntered: (text) => gallery.story = text
    }
    TpChoice {
        objectName: "choice"
        width: parent.width
        label: "A choice"
        options: ["one", "two", "three"]
        current: gallery.choice
        onPicked: (index) => gallery.choice = index
    }
    TpLetters {
        objectName: "letters"
        width: parent.width
        label: "Some letters"
        letters: ["A", "B", "C", "D", "E", "F", "G", "H"]
        onReached: (letter) => gallery.reachedLetters = gallery.reachedLetters.concat([letters[letter]])
        onChosen: (letter) => gallery.spelt += letters[letter]
    }
    TpProgress {
        objectName: "progress"
        width: parent.width
        label: "Import"
        valueText: "3 of 12"
        fraction: 0.25
    }
    TpScroll {
        objectName: "scroll"
        width: parent.width
        height: 100
        TpButton { objectName: "first"; text: "First" }
        TpButton { objectName: "second"; text: "Second" }
        Item { width: 1; height: 300 }
        TpButton { objectName: "last"; text: "Last" }
    }
}
