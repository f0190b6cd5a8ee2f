// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Care

// What the photograph shows, in words: for a screen reader, and for those who read more.
Column {
    id: part

    required property DescriptionCare descriptions
    required property DescriptionDraft draft
    spacing: Theme.gap

    TpHeading {
        width: parent.width
        text: qsTr("Description")
    }
    TpStatus {
        width: parent.width
        visible: part.draft.text !== ""
        text: qsTr("Suggested: %1").arg(part.draft.text)
        color: Theme.quiet
    }
    TpButton {
        objectName: "takeDraft"
        width: Math.min(implicitWidth, parent.width)
        visible: part.draft.text !== ""
        text: qsTr("Use the suggestion")
        hint: qsTr("It becomes the description in one sentence, which you can change.")
        onClicked: {
            part.draft.take()
            alt.forceActiveFocus(Qt.OtherFocusReason)
        }
    }
    TpTextArea {
        id: alt
        objectName: "altText"
        width: parent.width
        label: qsTr("In one sentence (%1)").arg(part.descriptions.languageName)
        setting: part.descriptions.altText
        onTyped: (text) => part.descriptions.typeAltText(text)
        onEntered: (text) => part.descriptions.typeAltText(text)
        onActiveFocusChanged: if (!activeFocus) part.descriptions.save()
    }
    TpStatus {
        width: parent.width
        text: alt.length > 250 ? qsTr("%1 characters; a screen reader reads up to 250 at once.").arg(alt.length)
                               : qsTr("%1 of 250 characters").arg(alt.length)
        font.pixelSize: Theme.smallSize
        color: Theme.quiet
    }
    TpTextArea {
        id: longer
        objectName: "description"
        width: parent.width
        label: qsTr("In more detail (%1)").arg(part.descriptions.languageName)
        setting: part.descriptions.description
        onTyped: (text) => part.descriptions.typeDescription(text)
        onEntered: (text) => part.descriptions.typeDescription(text)
        onActiveFocusChanged: if (!activeFocus) part.descriptions.save()
    }
    TpStatus {
        width: parent.width
        text: qsTr("%1 characters").arg(longer.length)
        font.pixelSize: Theme.smallSize
        color: Theme.quiet
    }
    TpButton {
        objectName: "saveDescription"
        width: Math.min(implicitWidth, parent.width)
        text: part.descriptions.unsaved ? qsTr("Save the description") : qsTr("The description is saved")
        hint: qsTr("It is also saved when you leave a field.")
        onClicked: part.descriptions.save()
    }
}
