// SPDX-License-Identifier: Apache-2.0
import QtQuick

// Words as they are. A Text of Qt guesses whether they are rich text, and would then fetch the pictures that a stranger's
// name asks for: nothing else here is a Text (app.controls.raw_controls).
Text {
    textFormat: Text.PlainText
    horizontalAlignment: Text.AlignLeft // with the page, whatever is written
}
