// SPDX-License-Identifier: Apache-2.0
import QtQuick
import QtQuick.Templates as T

// Words that are typed, with their label above. A screen reader's client cannot set them in Qt 6.4, so a page offers
// what is typed here in another way too, such as a list. `setting` is what the program says; `entered` comes with Return
// and when the field is left with other words in it.
FocusScope {
    id: field

    property string label: ""
    property string setting: ""
    property string placeholder: ""
    property int longest: 32767 // characters
    property alias text: input.text
    readonly property alias length: input.length
    signal entered(string text)
    signal typed(string text)

    function clear() { input.clear() }
    function selectAll() { input.selectAll() }

    implicitWidth: 200
    implicitHeight: caption.height + input.implicitHeight + 6
    activeFocusOnTab: false

    function enter() {
        if (input.text !== field.setting)
            field.entered(input.text)
    }
    onSettingChanged: input.text = setting
    Component.onCompleted: input.text = setting

    PlainText {
        id: caption
        width: parent.width
        text: field.label
        font.pixelSize: Theme.smallSize
        color: Theme.quiet
        wrapMode: Text.Wrap
        Accessible.ignored: true
    }
    T.TextField {
        id: input
        anchors { left: parent.left; right: parent.right; top: caption.bottom; topMargin: 6 }
        implicitHeight: Math.max(Theme.target, contentHeight + 2 * padding)
        padding: Theme.gap
        focus: true
        verticalAlignment: Text.AlignVCenter
        font.pixelSize: Theme.textSize
        color: Theme.text
        selectionColor: Theme.accent
        selectedTextColor: Theme.accentText
        maximumLength: field.longest
        selectByMouse: true
        onTextEdited: field.typed(text)
        onAccepted: field.entered(text)
        onActiveFocusChanged: if (!activeFocus) field.enter()

        Accessible.role: Accessible.EditableText
        Accessible.name: field.label
        Accessible.description: field.placeholder
        Accessible.editable: true
        Accessible.focusable: true

        PlainText {
            anchors.fill: parent
            anchors.margins: parent.padding
            visible: input.text === "" && !input.activeFocus
            text: field.placeholder
            font.pixelSize: Theme.textSize
            color: Theme.quiet
            verticalAlignment: Text.AlignVCenter
            elide: Text.ElideRight
            Accessible.ignored: true
        }
        background: Rectangle {
            radius: Theme.radius
            color: Theme.panel
            border.width: 1
            border.color: Theme.edge
            FocusRing { target: input }
        }
    }
}
