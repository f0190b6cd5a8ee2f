// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/settings/settings_session.hpp"
#include "app/parts/controls/recording_announcer.hpp"
#include "audio/speech/recording_voice.hpp"
#include "device_socket.hpp"
#include "touch_socket.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <filesystem>

/// A settings session over choices that are kept nowhere.
struct SettingsBench {
    tp::RecordingVoice voice;
    tp::RecordingAnnouncer announcer;
    tp::Narrator narrator{voice, announcer};
    tp::Preferences preferences;
    int discarded = 0;
    QTemporaryDir folder;
    tp::testing::DeviceSocket socket; ///< for a force device
    tp::testing::TouchSocket ticking; ///< for an output under a bare finger
    double time = 100.0;              ///< s, of what is done with them
    tp::SettingsSession session{narrator,
                                preferences,
                                {"/home/x/preferences.json", "/nowhere", [this] { ++discarded; }},
                                devices(),
                                {ticking.access(), [this] { return time; }, [](int) { return 0.03; }}};

    std::filesystem::path calibrations() const { return folder.filePath("calibrations.txt").toStdString(); }
    std::filesystem::path joystick_scales() const { return folder.filePath("sticks.txt").toStdString(); }
    tp::DeviceSettings::Setup devices() {
        tp::DeviceSettings::Setup setup{socket.access(), {}, [this] { return time; }};
        setup.access.calibrations = calibrations();
        setup.access.joystick_scales = joystick_scales();
        setup.servo.limits.stall = 60.0; // a busy test machine is never too late
        setup.servo.limits.stale_after = 60.0;
        setup.servo.limits.engage_ramp = 0.02; // the page's time is not the servo's
        setup.servo.limits.late_periods = 60000.0;
        setup.servo.limits.max_speed = 1e9;
        return setup;
    }
    /// Lets the page's time pass five times as fast as the servo's, until it is so or for so many seconds.
    template <typename Condition>
    void wait_in_time(Condition met, double seconds = 60.0) {
        for (double t = 0.0; t < seconds && !met(); t += 0.1) {
            time += 0.1;
            QTest::qWait(20);
        }
    }
    bool said(const QString& part) const { return !voice.said().filter(part).isEmpty(); }

    const tp::Choices& now() const { return preferences.choices(); }
};
