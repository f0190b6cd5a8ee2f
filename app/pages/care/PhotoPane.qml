// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Care

// The care of one photograph.
FocusScope {
    id: pane

    required property CareSession session
    signal soundsAsked

    function focusFirst() {
        scroll.toTop()
        back.forceActiveFocus()
    }

    TpScroll {
        id: scroll
        anchors.fill: parent
        visible: pane.session.photoOpen
        spacing: 2 * Theme.gap

        TpButton {
            id: back
            objectName: "back"
            focus: true
            width: Math.min(implicitWidth, parent.width)
            text: qsTr("Back to the photographs")
            onClicked: pane.session.closePhoto()
        }
        TpHeading {
            width: parent.width
            text: pane.session.photoName
            wrapMode: Text.WrapAnywhere
        }
        PictureItem {
            width: parent.width
            height: Math.min(0.6 * width, 0.4 * pane.height)
            visible: height > 100
            picture: pane.session.faces.picture
            Accessible.ignored: true
        }
        UndoBar {
            width: parent.width
            history: pane.session.history
        }
        FacesPart {
            width: parent.width
            height: implicitHeight
            faces: pane.session.faces
        }
        RecordingsPart {
            width: parent.width
            height: implicitHeight
            session: pane.session
            onFilesAsked: pane.soundsAsked()
        }
        DescriptionPart {
            width: parent.width
            descriptions: pane.session.descriptions
            draft: pane.session.draft
        }
        TpHeading {
            width: parent.width
            text: qsTr("The photograph")
        }
        Flow {
            width: parent.width
            spacing: Theme.gap
            TpButton {
                objectName: "mend"
                width: Math.min(implicitWidth, parent.width)
                text: qsTr("Mend contours…")
                onClicked: pane.session.mend()
            }
            TpButton {
                objectName: "print"
                width: Math.min(implicitWidth, parent.width)
                text: qsTr("Print a tactile sheet…")
                onClicked: pane.session.print()
            }
            TpButton {
                objectName: "deletePhoto"
                width: Math.min(implicitWidth, parent.width)
                text: qsTr("Delete the photograph")
                hint: qsTr("With everything that belongs to it. Undo brings it back.")
                onClicked: pane.session.deletePhoto()
            }
        }
    }
    TpText {
        anchors.centerIn: parent
        width: parent.width - 8 * Theme.gap
        visible: !pane.session.photoOpen
        text: qsTr("Choose a photograph to look after it.")
        horizontalAlignment: Text.AlignHCenter
        color: Theme.quiet
        font.pixelSize: Theme.headingSize
    }
}
