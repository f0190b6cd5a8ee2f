// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/lab/lab_session.hpp"
#include "app/parts/controls/recording_announcer.hpp"
#include "audio/speech/recording_voice.hpp"

#include <QTemporaryDir>
#include <QTest>

/// A lab in virtual time, with one device beside the simulated one that cannot be opened, and a folder of its own.
struct LabBench {
    QTemporaryDir folder;
    tp::RecordingVoice voice;
    tp::RecordingAnnouncer announcer;
    tp::Narrator narrator{voice, announcer};
    tp::Preferences preferences;
    tp::VirtualClock time;
    tp::LabSession session{narrator, preferences, settings()};

    LabBench() { session.scene()->setFieldScale(0.5); } // a small picture is painted soon

    tp::LabSettings settings() {
        tp::LabSettings settings;
        settings.folder = folder.filePath("lab").toStdString();
        settings.time = &time;
        settings.find_devices = [] {
            return std::vector<tp::ListedDevice>{{"simulated", "the mouse", "", ""}, {"pad:7", "force pad", "7", "hid"}};
        };
        return settings;
    }
    QString last() const { return voice.said().isEmpty() ? QString() : voice.said().back(); }
    /// The hand goes there; millimetres from the middle of the surface, y up.
    void hand(double x, double y) {
        session.hand()->touchDown(x + 0.5 * session.scene()->surfaceWidth(), 0.5 * session.scene()->surfaceHeight() - y);
    }
};
