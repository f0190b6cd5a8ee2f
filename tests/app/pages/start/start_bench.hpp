// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/start/start_session.hpp"
#include "app/parts/controls/recording_announcer.hpp"
#include "audio/speech/recording_voice.hpp"

#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QtGlobal>

/// The start of somebody who has a folder of pictures and no preferences yet.
struct StartBench {
    explicit StartBench(std::vector<tp::FoundDevice> devices = {}) : devices(std::move(devices)) {}

    /// In a home of its own.
    static void make_pictures_folder() {
        static const QTemporaryDir home;
        qputenv("HOME", QFile::encodeName(home.path()));
        QStandardPaths::setTestModeEnabled(true);
        QDir().mkpath(QStandardPaths::writableLocation(QStandardPaths::PicturesLocation));
    }

    std::vector<tp::FoundDevice> devices;
    int looked = 0;
    tp::RecordingVoice voice;
    tp::RecordingAnnouncer announcer;
    tp::Narrator narrator{voice, announcer};
    tp::Preferences preferences;
    tp::StartSession session{narrator, preferences, [this] {
                                 ++looked;
                                 return devices;
                             }};

    tp::FirstQuestions& questions() { return *session.questions(); }
    const tp::Choices& now() const { return preferences.choices(); }
    QString last_said() const { return voice.said().isEmpty() ? QString() : voice.said().back(); }
    void answer_until(tp::Question question) {
        while (questions().number() <= static_cast<int>(question) + 1)
            questions().answer(0);
    }
};
