// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/lab/lab_activity.hpp"
#include "app/pages/lab/lab_devices.hpp"
#include "app/pages/lab/lab_hand.hpp"
#include "app/pages/lab/lab_measurements.hpp"
#include "app/pages/lab/lab_scene.hpp"
#include "app/pages/lab/lab_teller.hpp"
#include "app/pages/lab/lab_tuning.hpp"
#include "app/parts/controls/recording_announcer.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "audio/speech/recording_voice.hpp"

#include <QString>

#include <vector>

inline constexpr int patience_ms = 60000; ///< on a busy machine

/// The parts of the lab on which servo and files stand, with nobody who stops what goes on.
struct LabParts {
    tp::RecordingVoice voice;
    tp::RecordingAnnouncer announcer;
    tp::Narrator narrator{voice, announcer};
    tp::Preferences preferences;
    tp::LabTeller teller{narrator};
    tp::LabActivity activity{teller};
    tp::LabTuning tuning{activity, teller};
    tp::LabScene scene{{220.0, 160.0, 8.0, {}}, tuning, activity, preferences, teller};
    std::vector<tp::ListedDevice> there{{"simulated", "the mouse", "", ""}, {"pad:7", "force pad", "7", "hid"}};
    tp::LabDevices devices{[this] { return there; }, activity, teller};
    tp::LabHand hand{scene, activity, teller};
    tp::LabMeasurements measurements{teller};

    LabParts() { scene.setFieldScale(0.5); } // a small picture is painted soon
    QString last() const { return voice.said().isEmpty() ? QString() : voice.said().back(); }
    /// The hand goes there; millimetres from the middle of the surface, y up.
    void touch(double x, double y) { hand.touchDown(x + 110.0, 80.0 - y); }
};
