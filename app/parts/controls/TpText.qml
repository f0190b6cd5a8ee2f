// SPDX-License-Identifier: Apache-2.0
import QtQuick

PlainText {
    font.pixelSize: Theme.textSize
    color: Theme.text
    wrapMode: Text.Wrap
    Accessible.role: Accessible.StaticText
    Accessible.name: text
}
