// SPDX-License-Identifier: Apache-2.0
import QtQuick
import QtQuick.Dialogs
import TouchPhoto.Controls
import Qt.labs.folderlistmodel // not used here, but without it Qt 6.4's own file dialog crashes as it opens

// In a file of its own, so that the page works where one of these modules is not installed.
FileDialog {
    signal chosen(var files)

    title: qsTr("Import photographs")
    fileMode: FileDialog.OpenFiles
    nameFilters: [qsTr("Photographs and bundles (%1)").arg(PhotoPatterns.all + " *.touchphoto *.zip"),
                  qsTr("All files (%1)").arg("*")]
    onAccepted: chosen(selectedFiles)
}
