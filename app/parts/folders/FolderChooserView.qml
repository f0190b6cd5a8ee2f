// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Folders

// Choosing a folder: where one is, what is below, and a way up. One goes into a folder by pressing its row.
FocusScope {
    id: view

    required property FolderChooser chooser
    implicitHeight: column.implicitHeight

    Column {
        id: column
        width: parent.width
        spacing: Theme.gap

        TpHeading {
            width: parent.width
            text: view.chooser.folder
        }
        TpText {
            width: parent.width
            text: view.chooser.content
            color: Theme.quiet
        }
        TpButton {
            width: parent.width
            primary: true
            focus: true
            text: qsTr("Choose this folder")
            onClicked: view.chooser.choose()
        }
        TpButton {
            width: parent.width
            enabled: view.chooser.hasAbove
            text: qsTr("Up one folder")
            onClicked: view.chooser.goUp()
        }
        Repeater {
            model: view.chooser.below
            delegate: TpListRow {
                required property int index
                required property string modelData
                width: column.width
                text: modelData
                position: index + 1
                count: view.chooser.below.length
                onClicked: view.chooser.goInto(index)
            }
        }
        TpButton {
            width: parent.width
            text: qsTr("Cancel")
            onClicked: view.chooser.cancel()
        }
    }
}
