// SPDX-License-Identifier: Apache-2.0
import TouchPhoto.Controls
import TouchPhoto.Lab

// A parameter that is a number, by its key.
TpSlider {
    required property LabTuning tuning
    required property string key

    objectName: key
    valueText: tuning.words(key, value)
    from: tuning.lowest(key)
    to: tuning.highest(key)
    stepSize: tuning.step(key)
    setting: tuning.values[key]
    onChosen: (value) => tuning.setNumber(key, value, label)
}
