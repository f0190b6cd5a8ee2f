// SPDX-License-Identifier: Apache-2.0
import QtQuick
import QtQuick.Dialogs
import Qt.labs.folderlistmodel // see PhotosDialog.qml

FolderDialog {
    signal chosen(var files) // one folder
    signal dropped

    onAccepted: chosen([selectedFolder])
    onRejected: dropped()
}
