// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Folders
import TouchPhoto.Start

// Where the program begins: the questions of the first start, then the way to each page.
FocusScope {
    id: page

    required property StartSession session
    readonly property string help: session.asking
        ? qsTr("Press the number of an answer, or the answer itself. 0 or Backspace: previous question. R: repeat the question.")
        : qsTr("Press the number of what you want to do, or go through the buttons with Tab. R: repeat this page.")

    Keys.onPressed: (event) => {
        const number = event.key - Qt.Key_1
        event.accepted = true
        if (event.modifiers & ~Qt.KeypadModifier)
            event.accepted = false
        else if (number >= 0 && number < 9)
            session.asking ? session.questions.answer(number) : session.go(number)
        else if (event.key === Qt.Key_R)
            session.repeat()
        else if (event.key === Qt.Key_0 || event.key === Qt.Key_Backspace || event.key === Qt.Key_Escape)
            event.accepted = session.questions.back()
        else
            event.accepted = false
    }

    Loader {
        anchors.fill: parent
        focus: true
        sourceComponent: page.session.questions.choosing ? choosing : page.session.asking ? asking : hub
        onLoaded: item.forceActiveFocus()
    }

    Component {
        id: asking
        TpScroll {
            margin: 2 * Theme.gap
            onTappedBeside: page.session.repeat()
            TpText {
                width: parent.width
                text: qsTr("Question %1 of %2").arg(page.session.questions.number).arg(page.session.questions.count)
                color: Theme.quiet
            }
            TpHeading {
                width: parent.width
                text: page.session.questions.question
                font.pixelSize: 1.4 * Theme.headingSize
            }
            Repeater {
                model: page.session.questions.answers
                delegate: TpButton {
                    required property int index
                    required property string modelData
                    objectName: "answer" + index
                    width: parent.width
                    height: Math.max(implicitHeight, Math.floor((page.height - 260 * Theme.textScale) / page.session.questions.answers.length - Theme.gap))
                    focus: index === Math.max(0, page.session.questions.current)
                    primary: index === page.session.questions.current
                    large: true
                    text: qsTr("%1: %2").arg(index + 1).arg(modelData)
                    onClicked: page.session.questions.answer(index)
                }
            }
            Row {
                spacing: Theme.gap
                TpButton {
                    text: qsTr("Repeat")
                    hint: qsTr("Key: R")
                    onClicked: page.session.repeat()
                }
                TpButton {
                    visible: page.session.questions.number > 1
                    text: qsTr("Previous question")
                    hint: qsTr("Key: 0")
                    onClicked: page.session.questions.back()
                }
            }
        }
    }
    Component {
        id: choosing
        TpScroll {
            margin: 2 * Theme.gap
            FolderChooserView {
                width: parent.width
                focus: true
                chooser: page.session.questions.chooser
            }
        }
    }
    Component {
        id: hub
        TpScroll {
            margin: 2 * Theme.gap
            onTappedBeside: page.session.repeat()
            TpStatus {
                objectName: "news"
                width: parent.width
                visible: text !== ""
                text: page.session.news
                wrapMode: Text.Wrap
            }
            Repeater {
                model: page.session.destinations
                delegate: TpListRow {
                    required property int index
                    required property var modelData
                    readonly property bool main: index < 2
                    objectName: "destination" + index
                    width: parent.width
                    height: main ? Math.max(implicitHeight, Math.round(0.2 * page.height)) : implicitHeight
                    focus: index === 0
                    selected: main
                    large: main
                    text: qsTr("%1: %2").arg(index + 1).arg(modelData.title)
                    detail: modelData.hint
                    onClicked: page.session.go(index)
                }
            }
        }
    }
}
