// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/settings/setting_steps.hpp"
#include "app/parts/controls/recording_announcer.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "audio/speech/recording_voice.hpp"

#include <QString>
#include <QTest>

#include <cstddef>
#include <functional>
#include <vector>

/// Choices that are kept nowhere, and their steps.
struct SettingGround {
    tp::RecordingVoice voice;
    tp::RecordingAnnouncer announcer;
    tp::Narrator narrator{voice, announcer};
    tp::Preferences preferences;
    tp::SettingSteps steps{narrator, preferences};

    const tp::Choices& now() const { return preferences.choices(); }
    QString last() const { return voice.said().isEmpty() ? QString() : voice.said().back(); }

    /// Each of these changes one choice, which is kept, said and taken back.
    void try_each(const std::vector<std::function<void()>>& changes) {
        for (std::size_t i = 0; i < changes.size(); ++i) {
            const tp::Choices before = now();
            voice.clear();
            changes[i]();
            QVERIFY2(now() != before, qPrintable(QString::number(i)));
            QVERIFY2(!voice.said().isEmpty(), qPrintable(QString::number(i)));
            changes[i](); // the same again is no change
            steps.undo();
            QVERIFY2(now() == before, qPrintable(QString::number(i)));
            QVERIFY(last().startsWith("Undone: "));
        }
        QVERIFY(steps.undoable().isEmpty());
    }
};
