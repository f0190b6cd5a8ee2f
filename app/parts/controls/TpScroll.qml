// SPDX-License-Identifier: Apache-2.0
import QtQuick

// A column of a page that scrolls where a small window or large text needs more room. What the keyboard comes to is
// brought into view, and stays there when what lies round it grows, until a finger scrolls. Focus rings have their room
// outside of the column, so that its edges are those of the item.
FocusScope {
    id: scroll

    default property alias content: column.data
    property alias spacing: column.spacing
    property real margin: 0
    readonly property Item focused: Window.activeFocusItem
    readonly property real outset: Math.max(0, Theme.ring + 3 - margin)
    property bool following: false
    signal tappedBeside // on nothing that takes a tap itself

    // Who comes to a page comes to its first control.
    onActiveFocusChanged: if (activeFocus && Window.activeFocusItem === scroll)
        nextItemInFocusChain(true).forceActiveFocus(Qt.TabFocusReason)

    function toTop() { flickable.contentY = 0 }

    onFocusedChanged: {
        following = true
        follow()
    }
    function follow() {
        if (!following)
            return
        for (let item = focused; item; item = item.parent)
            if (item === column) {
                const top = focused.mapToItem(flickable.contentItem, 0, 0).y
                const lowest = Math.max(0, flickable.contentHeight - flickable.height)
                const wanted = Math.max(Math.min(flickable.contentY, top - Theme.gap),
                                        top + focused.height + Theme.gap - flickable.height)
                flickable.contentY = Math.max(0, Math.min(lowest, wanted))
                return
            }
    }

    Flickable {
        id: flickable
        anchors.fill: parent
        anchors.margins: -scroll.outset
        contentHeight: column.height + 2 * (scroll.margin + scroll.outset)
        clip: contentHeight > height
        boundsBehavior: Flickable.StopAtBounds
        onMovementStarted: scroll.following = false
        onHeightChanged: scroll.follow()
        onContentHeightChanged: scroll.follow()

        MouseArea {
            width: flickable.width
            height: Math.max(flickable.height, flickable.contentHeight)
            onClicked: scroll.tappedBeside()
        }
        Column {
            id: column
            x: scroll.margin + scroll.outset
            y: x
            width: flickable.width - 2 * x
            spacing: Theme.gap
        }
    }
}
