// SPDX-License-Identifier: Apache-2.0
import QtQuick

// Words that change while a page is used. A screen reader finds them here; it is told of a change by an Announcer.
TpText {
    property string label: ""
    Accessible.name: label === "" ? text : label + ": " + text
}
