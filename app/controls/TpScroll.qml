// SPDX-License-Identifier: Apache-2.0
import QtQuick

// A column of a page that scrolls where a small window or large text needs more room. What the keyboard comes to is
// brought into view.
FocusScope {
    id: scroll

    default property alias content: column.data
    property alias spacing: column.spacing
    property real margin: 0
    readonly property Item focused: Window.activeFocusItem
    signal tappedBeside // on nothing that takes a tap itself

    // Who comes to a page comes to its first control.
    onActiveFocusChanged: if (activeFocus && Window.activeFocusItem === scroll)
        nextItemInFocusChain(true).forceActiveFocus(Qt.TabFocusReason)

    function toTop() { flickable.contentY = 0 }

    onFocusedChanged: {
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
        contentHeight: column.height + 2 * scroll.margin
        clip: contentHeight > height
        boundsBehavior: Flickable.StopAtBounds

        MouseArea {
            width: flickable.width
            height: Math.max(flickable.height, flickable.contentHeight)
            onClicked: scroll.tappedBeside()
        }
        Column {
            id: column
            x: scroll.margin
            y: scroll.margin
            width: flickable.width - 2 * scroll.margin
            spacing: Theme.gap
        }
    }
}
