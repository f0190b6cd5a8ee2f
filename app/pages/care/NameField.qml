// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls

// A name that is typed, or chosen from the people whom the album knows: a screen reader's client cannot type into a
// field of Qt 6.4. Nothing is taken over before Return or a press.
FocusScope {
    id: field

    required property string label
    required property var suggest // (typed) => names
    property string initial: ""
    property string none: ""      // the row for nobody; empty: there is none
    property var names: []
    signal chosen(string name)

    implicitHeight: column.height

    function reset(name) {
        input.setting = name
        input.text = name
        names = suggest("")
    }
    function look(typed) {
        input.setting = typed // so that leaving the field enters nothing
        names = suggest(typed)
    }
    function take(name) {
        input.forceActiveFocus() // the rows are made anew
        chosen(name)
    }
    onInitialChanged: reset(initial)
    Component.onCompleted: reset(initial)

    Column {
        id: column
        width: parent.width
        spacing: 6

        TpTextField {
            id: input
            width: parent.width
            focus: true
            label: field.label
            placeholder: qsTr("Type, or choose below")
            onTyped: (text) => field.look(text)
            onEntered: (text) => field.chosen(text)
        }
        Flow {
            width: parent.width
            spacing: 8
            Repeater {
                model: field.names
                delegate: TpListRow {
                    required property string modelData
                    required property int index
                    width: Math.min(parent.width, 220 * Theme.textScale)
                    text: modelData
                    position: index + 1
                    count: field.names.length
                    selected: modelData === field.initial
                    onClicked: field.take(modelData)
                }
            }
            TpButton {
                visible: field.none !== ""
                width: Math.min(implicitWidth, parent.width)
                text: field.none
                onClicked: field.take("")
            }
        }
    }
}
