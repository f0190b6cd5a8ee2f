// SPDX-License-Identifier: Apache-2.0
import QtQuick

// A Text, because a role set on a Label is ignored by Qt 6.4.
PlainText {
    font.pixelSize: Theme.headingSize
    font.bold: true
    color: Theme.text
    wrapMode: Text.Wrap
    Accessible.role: Accessible.Heading
    Accessible.name: text
}
