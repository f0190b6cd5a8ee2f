// SPDX-License-Identifier: Apache-2.0
import QtQuick
import QtQuick.Layouts
import TouchPhoto.Controls
import TouchPhoto.Shell

// The window's content: a bar with the way home, the page, and the words that were said last.
FocusScope {
    id: view

    required property Shell shell
    required property var announcer
    required property var sessions // page → its session, made when the page is opened first
    required property var pages    // page → its QML file
    readonly property Item pageItem: current === null ? null : current.item
    property Loader current: null

    // What scrolls on a page ends here.
    component BarEdge: Rectangle {
        width: parent.width
        height: 1
        z: 1
        color: Theme.edge
    }

    focus: true
    LayoutMirroring.enabled: Theme.mirrored
    LayoutMirroring.childrenInherit: true

    // A page has the first word about Escape, and none about the keys that hold everywhere.
    Keys.onEscapePressed: view.shell.home ? view.shell.open(view.shell.page) : view.shell.goHome()
    Shortcut { sequence: "F1"; onActivated: view.help() }
    Shortcut { sequence: "F2"; onActivated: view.shell.repeat() }
    Shortcut { sequence: "F3"; onActivated: view.shell.toggleVoice() }
    Shortcut { sequence: "Alt+Left"; onActivated: view.shell.back() }
    Shortcut { sequence: "Alt+Home"; onActivated: view.shell.goHome() }

    function help() {
        shell.help(pageItem !== null && pageItem.help !== undefined ? pageItem.help : "")
    }
    // Each page is loaded when it is opened first and kept, so that going back to it takes no time.
    function show() {
        for (let i = 0; i < loaders.count; ++i) {
            const loader = loaders.itemAt(i)
            const shown = loader.page === shell.page
            if (shown && loader.source == "")
                loader.setSource(pages[loader.page], { session: sessions.session(loader.page) })
            loader.visible = shown
            loader.enabled = shown
            loader.focus = shown
            if (shown) {
                current = loader
                giveKeyboard()
            }
        }
    }
    function giveKeyboard() {
        current.forceActiveFocus()
        const focused = view.Window.activeFocusItem
        if (focused !== null && !focused.activeFocusOnTab) // the keyboard begins at the page's first control
            focused.nextItemInFocusChain(true).forceActiveFocus(Qt.TabFocusReason)
    }
    // A page may hide or take away what has the keyboard: then nobody would hear Escape.
    readonly property Item keyboard: Window.activeFocusItem
    onKeyboardChanged: Qt.callLater(keepKeyboard)
    function keepKeyboard() {
        if (current !== null && keyboard !== null && keyboard === Window.contentItem)
            giveKeyboard()
    }
    Component.onCompleted: show()
    Connections {
        target: view.shell
        function onPageChanged() {
            if (view.current === null || view.current.page !== view.shell.page)
                view.show()
        }
    }

    Binding { target: Theme; property: "scheme"; value: view.sessions.scheme }
    Binding { target: Theme; property: "textScale"; value: view.sessions.textScale }
    Binding { target: Theme; property: "motion"; value: view.sessions.motion }
    Rectangle {
        anchors.fill: parent
        color: Theme.ground
    }
    ColumnLayout {
        anchors.fill: parent
        spacing: 0

        Rectangle {
            Layout.fillWidth: true
            Layout.preferredHeight: bar.implicitHeight + 2 * Theme.gap
            z: 1 // over the page, with its edge
            color: Theme.panel
            BarEdge { anchors.top: parent.bottom }
            RowLayout {
                id: bar
                anchors { fill: parent; margins: Theme.gap; leftMargin: 2 * Theme.gap; rightMargin: 2 * Theme.gap }
                Keys.forwardTo: view.pageItem === null ? [] : [view.pageItem] // the page's keys hold here too
                spacing: 2 * Theme.gap
                TpButton {
                    objectName: "home"
                    visible: !view.shell.home
                    text: qsTr("Home")
                    hint: qsTr("Key: Escape")
                    onClicked: view.shell.goHome()
                }
                TpHeading {
                    objectName: "title"
                    Layout.fillWidth: true
                    text: view.shell.title
                }
                TpButton {
                    objectName: "help"
                    text: qsTr("Help")
                    hint: qsTr("Says what you can do here. Key: F1")
                    onClicked: view.help()
                }
            }
        }
        Item {
            Layout.fillWidth: true
            Layout.fillHeight: true
            Repeater {
                id: loaders
                model: Object.keys(view.pages)
                delegate: Loader {
                    required property string modelData
                    readonly property string page: modelData
                    anchors.fill: parent
                    visible: false
                }
            }
        }
        Rectangle {
            Layout.fillWidth: true
            Layout.preferredHeight: said.implicitHeight + 2 * Theme.gap
            visible: said.text !== ""
            z: 1
            color: Theme.panel
            BarEdge { anchors.bottom: parent.top }
            TpStatus {
                id: said
                objectName: "said"
                label: qsTr("Last sentence")
                anchors { left: parent.left; right: parent.right; verticalCenter: parent.verticalCenter; margins: 2 * Theme.gap }
                font.pixelSize: Theme.smallSize
                maximumLineCount: Math.max(3, Math.floor(0.25 * view.height / saidMetrics.height))
                elide: Text.ElideRight
                FontMetrics { id: saidMetrics; font: said.font }
                text: view.shell.voiceProblem !== "" ? view.shell.sentence + " " + view.shell.voiceProblem : view.shell.sentence
            }
        }
    }
    TpNotification { announcer: view.announcer }
}
