// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Care

// A dialog that is made when it is needed first. Where it is not installed, the page says so and goes on.
Loader {
    id: loader

    required property CareSession session
    required property string file
    signal chosen(var files)

    active: false

    function open() {
        if (!active)
            setSource(file)
        active = true
        if (status !== Loader.Ready) {
            session.tellProblem(qsTr("The file dialog is not installed. Drop files or folders on this window instead."))
            return
        }
        item.open()
    }
    onLoaded: item.currentFolder = session.folders.picturesFolder()

    Connections {
        target: loader.item
        ignoreUnknownSignals: true
        function onChosen(files) { loader.chosen(files) }
    }
}
