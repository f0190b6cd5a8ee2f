// SPDX-License-Identifier: Apache-2.0
import QtQuick

// One of a list, pressed like a button. Its place in the list stands in its name, because NVDA reads it no other way.
TpPressable {
    id: row

    property string text: ""
    property string detail: ""
    property bool selected: false
    property bool large: false // one of the few things that a page is for
    property int position: 0 // from 1; 0: said nowhere
    property int count: 0
    property url picture: ""

    implicitWidth: 200
    implicitHeight: Math.max(Theme.target, words.implicitHeight + 2 * Theme.gap)

    Accessible.role: Accessible.ListItem
    Accessible.name: {
        const words = detail === "" ? text : text + ", " + detail
        return position > 0 ? qsTr("%1, %2 of %3").arg(words).arg(position).arg(count) : words
    }
    Accessible.selectable: true
    Accessible.selected: selected

    Rectangle {
        anchors.fill: parent
        radius: Theme.radius
        color: row.down ? Theme.pressed : Theme.raised
        border.width: row.selected ? 3 : 1
        border.color: row.selected ? Theme.accent : Theme.edge
        FocusRing { target: row }
    }
    Row {
        anchors { fill: parent; margins: Theme.gap; leftMargin: row.large ? 2 * Theme.gap : Theme.gap }
        spacing: Theme.gap
        Image {
            id: thumbnail
            visible: source != ""
            width: visible ? height : 0
            height: 0.9 * Theme.target
            anchors.verticalCenter: parent.verticalCenter
            source: row.picture
            fillMode: Image.PreserveAspectCrop
            asynchronous: true
            Accessible.ignored: true
        }
        Column {
            id: words
            anchors.verticalCenter: parent.verticalCenter
            width: parent.width - (thumbnail.visible ? thumbnail.width + parent.spacing : 0)
            PlainText {
                width: parent.width
                text: row.text
                font.pixelSize: row.large ? 1.4 * Theme.headingSize : Theme.textSize
                font.bold: row.selected
                color: Theme.text
                wrapMode: Text.Wrap
                Accessible.ignored: true
            }
            PlainText {
                width: parent.width
                visible: text !== ""
                text: row.detail
                font.pixelSize: row.large ? Theme.textSize : Theme.smallSize
                color: Theme.quiet
                wrapMode: Text.Wrap
                Accessible.ignored: true
            }
        }
    }
}
