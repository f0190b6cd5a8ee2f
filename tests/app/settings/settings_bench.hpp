// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/controls/recording_announcer.hpp"
#include "app/settings/settings_session.hpp"
#include "audio/speech/recording_voice.hpp"

/// A settings session over choices that are kept nowhere.
struct SettingsBench {
    tp::RecordingVoice voice;
    tp::RecordingAnnouncer announcer;
    tp::Narrator narrator{voice, announcer};
    tp::Preferences preferences;
    int discarded = 0;
    tp::SettingsSession session{narrator, preferences, {"/home/x/preferences.json", "/nowhere", [this] { ++discarded; }}};

    const tp::Choices& now() const { return preferences.choices(); }
};
