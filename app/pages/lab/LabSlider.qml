// SPDX-License-Identifier: Apache-2.0
import TouchPhoto.Controls
import TouchPhoto.Lab

// A parameter that is a number, by its key.
TpSlider {
    required property LabSession session
    required property string key

    objectName: key
    valueText: session.words(key, value)
    from: session.lowest(key)
    to: session.highest(key)
    stepSize: session.step(key)
    setting: session.values[key]
    onChosen: (value) => session.setNumber(key, value, label)
}
