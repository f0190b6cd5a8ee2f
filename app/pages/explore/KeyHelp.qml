// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls

TpText {
    text: [qsTr("Arrow keys, with Shift faster: move the hand. Tab: next feature. W: where am I. Z, Shift+Z: zoom in and out. Space: tour of the feature. T: tour of the face. G: guide. F: next face. N, Shift+N: next and previous photograph with a face. Enter: force on. Escape: stop. V: voice. O: open."),
           qsTr("Touch: one finger explores. Double tap: where am I. Double tap and hold: zoom to what is there, or out. Two-finger tap: stop. Two-finger double tap: tour. Three-finger tap: where am I. Two-finger swipe to the right or left: next or previous photograph with a face."),
           qsTr("In the picture: ring, the hand; disc, the finger; arrow, the pull of the line; small disc, where ticks lead.")].join("\n\n")
    font.pixelSize: Theme.smallSize
    color: Theme.quiet
}
