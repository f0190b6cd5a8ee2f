// SPDX-License-Identifier: Apache-2.0
import TouchPhoto.Controls
import TouchPhoto.Lab

// A parameter that is on or off, by its key.
TpToggle {
    required property LabTuning tuning
    required property string key

    objectName: key
    on: tuning.values[key]
    onSwitched: (on) => tuning.setSwitch(key, on, text)
}
