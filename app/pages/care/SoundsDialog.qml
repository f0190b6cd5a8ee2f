// SPDX-License-Identifier: Apache-2.0
import QtQuick
import QtQuick.Dialogs
import Qt.labs.folderlistmodel // see PhotosDialog.qml

FileDialog {
    signal chosen(var files)

    title: qsTr("Add sound files")
    fileMode: FileDialog.OpenFiles
    nameFilters: [qsTr("Sounds (%1)").arg("*.wav *.flac *.mp3 *.ogg *.oga *.opus *.aiff *.aif *.caf *.au *.w64"),
                  qsTr("All files (%1)").arg("*")]
    onAccepted: chosen(selectedFiles)
}
