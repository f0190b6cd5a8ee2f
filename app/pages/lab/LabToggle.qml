// SPDX-License-Identifier: Apache-2.0
import TouchPhoto.Controls
import TouchPhoto.Lab

// A parameter that is on or off, by its key.
TpToggle {
    required property LabSession session
    required property string key

    objectName: key
    on: session.values[key]
    onSwitched: (on) => session.setSwitch(key, on, text)
}
