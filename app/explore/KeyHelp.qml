// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls

TpText {
    text: "Ring: hand · disc: finger · arrow: pull of the line · arrow keys, Shift: move · Tab: next feature\n"
          + "Space: guided tour · Escape: stop · Enter: force on · W: where am I · F: next face · V: voice · O: open"
    font.pixelSize: Theme.smallSize
    color: Theme.quiet
    horizontalAlignment: Text.AlignHCenter
}
