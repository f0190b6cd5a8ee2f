// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Care

// Who is on the photograph: a row for each face, and naming the one that was pressed.
FocusScope {
    id: part

    required property FaceCare faces
    implicitHeight: column.height

    Connections {
        target: part.faces
        function onFaceChosen() {
            nameField.reset(part.faces.chosenName)
            if (!part.activeFocus)
                return
            if (part.faces.chosen >= 0)
                nameField.forceActiveFocus()
            else if (rows.count > 0)
                rows.itemAt(0).focusRow()
        }
    }

    Column {
        id: column
        width: parent.width
        spacing: Theme.gap

        TpHeading {
            width: parent.width
            text: qsTr("Faces")
        }
        TpStatus {
            width: parent.width
            text: part.faces.summary
        }
        Repeater {
            id: rows
            model: part.faces.count
            delegate: FocusScope {
                id: face
                required property int index
                readonly property var entry: part.faces.faces[index] || {}

                width: column.width
                height: row.height
                function focusRow() { row.forceActiveFocus() }

                PictureItem {
                    id: crop
                    anchors.left: parent.left
                    width: 1.5 * Theme.target
                    height: 1.5 * Theme.target
                    fill: PictureItem.Cover
                    picture: face.entry.picture
                    Accessible.ignored: true
                    MouseArea {
                        anchors.fill: parent
                        onClicked: part.faces.choose(face.index)
                    }
                }
                TpListRow {
                    id: row
                    anchors { left: crop.right; leftMargin: Theme.gap; right: yes.visible ? yes.left : parent.right; rightMargin: yes.visible ? Theme.gap : 0 }
                    height: Math.max(implicitHeight, crop.height)
                    focus: true
                    text: face.entry.text || ""
                    detail: face.entry.problem ? face.entry.problem : face.entry.named ? "" : qsTr("Press to name this face")
                    position: face.index + 1
                    count: part.faces.count
                    selected: face.entry.chosen === true
                    onClicked: part.faces.choose(face.index)
                }
                TpButton {
                    id: yes
                    objectName: "yes" + face.index
                    anchors { right: parent.right; verticalCenter: row.verticalCenter }
                    visible: (face.entry.offer || "") !== ""
                    width: Math.min(implicitWidth, 0.4 * face.width)
                    text: qsTr("Yes, %1").arg(face.entry.offer || "")
                    hint: qsTr("Key: Y")
                    onClicked: {
                        row.forceActiveFocus() // this button goes
                        part.faces.accept(face.index)
                    }
                }
                Keys.onPressed: (event) => {
                    event.accepted = event.key === Qt.Key_Y && yes.visible
                    if (event.accepted)
                        part.faces.accept(face.index)
                }
            }
        }
        Rectangle {
            width: parent.width
            height: naming.height + 2 * Theme.gap
            visible: part.faces.chosen >= 0
            color: Theme.panel
            radius: Theme.radius
            Column {
                id: naming
                x: Theme.gap
                y: Theme.gap
                width: parent.width - 2 * Theme.gap
                spacing: Theme.gap
                NameField {
                    id: nameField
                    width: parent.width
                    label: qsTr("Who is face %1?").arg(part.faces.chosen + 1)
                    suggest: (typed) => part.faces.suggestions(typed)
                    none: qsTr("Nobody I know")
                    onChosen: (name) => part.faces.name(name)
                }
                TpChoice {
                    width: parent.width
                    visible: part.faces.chosenName !== ""
                    label: qsTr("Language of the name")
                    options: [qsTr("Same as the page")].concat(part.faces.languages)
                    current: part.faces.language + 1
                    onPicked: (index) => part.faces.readNameIn(index - 1)
                }
                TpButton {
                    width: Math.min(implicitWidth, parent.width)
                    text: qsTr("Close")
                    hint: qsTr("Leaves the face as it is.")
                    onClicked: part.faces.choose(-1)
                }
            }
        }
    }
}
