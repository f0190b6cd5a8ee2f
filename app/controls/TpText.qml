// SPDX-License-Identifier: Apache-2.0
import QtQuick

Text {
    font.pixelSize: Theme.textSize
    color: Theme.text
    wrapMode: Text.Wrap
    horizontalAlignment: Text.AlignLeft // with the page, whatever is written
    Accessible.role: Accessible.StaticText
    Accessible.name: text
}
