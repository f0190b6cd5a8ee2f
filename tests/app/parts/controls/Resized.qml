// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls

// What wraps its words, made in parts while the window changes.
Item {
    id: resized
    width: 400
    height: 600

    readonly property var theme: Theme
    property alias shown: loader.active
    readonly property bool complete: loader.status === Loader.Ready

    Loader {
        id: loader
        width: resized.width
        asynchronous: true
        sourceComponent: Column {
            id: column
            Repeater {
                model: ["Motors switch themselves off", "No readings at all"]
                delegate: Column {
                    id: group
                    required property string modelData
                    width: column.width
                    TpToggle { width: group.width; text: group.modelData }
                    TpButton { width: group.width; text: group.modelData }
                    TpSlider { width: group.width; label: group.modelData; from: 0; to: 1; setting: 0.5 }
                    TpChoice { width: group.width; label: group.modelData; options: ["One of many words", "Another one"]; current: 0 }
                    TpListRow { width: group.width; text: group.modelData; detail: "12 photographs"; position: 1; count: 2 }
                    TpTextField { width: group.width; label: group.modelData; setting: group.modelData }
                    TpTextArea { width: group.width; label: group.modelData; setting: group.modelData }
                    TpProgress { width: group.width; label: group.modelData; fraction: 0.5 }
                }
            }
        }
    }
}
