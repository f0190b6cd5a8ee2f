// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls

TpText {
    text: qsTr("Left, Right: photograph · Up, Down: details · Enter: recordings · Escape: stop · +, −: speed\n"
               + "Home, End: first, last · S: search · P: people · Y: years · L: places · K: keywords · R: surprise\n"
               + "A: all · Backspace: back · E: feel the face · C: look after it · W: where am I · H: keys")
    font.pixelSize: Theme.smallSize
    color: Theme.quiet
    horizontalAlignment: Text.AlignHCenter
}
