// SPDX-License-Identifier: Apache-2.0
import QtQuick
import QtQuick.Dialogs
import Qt.labs.folderlistmodel // not used here, but without it Qt 6.4's own file dialog crashes as it opens

// In a file of its own, so that the page works where one of these modules is not installed.
FileDialog {
    signal chosen(url file)

    title: qsTr("Open an experiment")
    nameFilters: [qsTr("Experiments (%1)").arg("*.study"), qsTr("All files (%1)").arg("*")]
    onAccepted: chosen(selectedFile)
}
