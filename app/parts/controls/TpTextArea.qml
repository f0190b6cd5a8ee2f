// SPDX-License-Identifier: Apache-2.0
import QtQuick
import QtQuick.Templates as T

// Several lines of words with their label above. Tab leaves it, as it leaves every control. See TpTextField.
FocusScope {
    id: field

    property string label: ""
    property string setting: ""
    property alias text: input.text
    readonly property alias length: input.length
    signal entered(string text)
    signal typed(string text)

    implicitWidth: 200
    implicitHeight: caption.height + input.implicitHeight + 6

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
    T.TextArea {
        id: input
        anchors { left: parent.left; right: parent.right; top: caption.bottom; topMargin: 6 }
        implicitHeight: Math.max(2 * Theme.target, contentHeight + 2 * padding)
        padding: Theme.gap
        focus: true
        font.pixelSize: Theme.textSize
        color: Theme.text
        selectionColor: Theme.accent
        selectedTextColor: Theme.accentText
        wrapMode: TextEdit.Wrap
        textFormat: TextEdit.PlainText
        selectByMouse: true
        onTextChanged: if (activeFocus) field.typed(text)
        onActiveFocusChanged: if (!activeFocus) field.enter()
        KeyNavigation.priority: KeyNavigation.BeforeItem
        Keys.onTabPressed: nextItemInFocusChain(true).forceActiveFocus(Qt.TabFocusReason)
        Keys.onBacktabPressed: nextItemInFocusChain(false).forceActiveFocus(Qt.BacktabFocusReason)

        Accessible.role: Accessible.EditableText
        Accessible.name: field.label
        Accessible.editable: true
        Accessible.multiLine: true
        Accessible.focusable: true

        background: Rectangle {
            radius: Theme.radius
            color: Theme.panel
            border.width: 1
            border.color: Theme.edge
            FocusRing { target: input }
        }
    }
}
