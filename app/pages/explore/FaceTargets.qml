// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Explore

// Faces and their features where they lie, for a screen reader: its hit test finds them, a press goes there. They
// take no mouse and no touch.
Item {
    id: targets

    required property ExploreSession session
    required property real pixelsPerMm

    Repeater {
        model: targets.session.view.faces
        delegate: Item {
            id: face
            required property var modelData
            required property int index

            visible: modelData.rect.width > 0 && modelData.rect.height > 0
            x: modelData.rect.x * targets.pixelsPerMm
            y: modelData.rect.y * targets.pixelsPerMm
            width: modelData.rect.width * targets.pixelsPerMm
            height: modelData.rect.height * targets.pixelsPerMm
            Accessible.role: Accessible.Button
            Accessible.name: modelData.name
            Accessible.description: qsTr("Fits this face into the touch surface")
            Accessible.onPressAction: targets.session.zoom.chooseFace(face.index)

            Repeater {
                model: face.modelData.features
                delegate: Item {
                    required property var modelData

                    x: modelData.rect.x * targets.pixelsPerMm - face.x
                    y: modelData.rect.y * targets.pixelsPerMm - face.y
                    width: modelData.rect.width * targets.pixelsPerMm
                    height: modelData.rect.height * targets.pixelsPerMm
                    z: -width * height // the outline lies round all others and must not hide them
                    Accessible.role: Accessible.Button
                    Accessible.name: modelData.name
                    Accessible.description: qsTr("Puts the finger there")
                    Accessible.onPressAction: targets.session.hand.goToFeature(modelData.index)
                }
            }
        }
    }
}
