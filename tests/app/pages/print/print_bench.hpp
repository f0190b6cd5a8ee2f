// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/print/print_session.hpp"
#include "app/parts/controls/recording_announcer.hpp"
#include "audio/speech/recording_voice.hpp"
#include "fake_loudspeaker.hpp"
#include "places.hpp"

#include <QTemporaryDir>

/// Printing of sample portraits into a folder of the test's.
struct PrintBench {
    QTemporaryDir folder;
    tp::RecordingVoice voice;
    tp::RecordingAnnouncer announcer;
    tp::Narrator narrator{voice, announcer};
    tp::testing::FakeLoudspeaker loudspeaker;
    tp::EarconPlayer earcons{loudspeaker};
    tp::PrintSession session{narrator, earcons, documents()};

    tp::PrintedPhoto& photo() { return *session.photo(); }
    tp::PrintedSheet& sheet() { return *session.sheet(); }
    std::filesystem::path documents() const { return folder.filePath("Documents/TouchPhoto").toStdString(); }
    static std::filesystem::path sample(const char* name) {
        return std::filesystem::path(tp::test::in_source("resources/samples")) / name;
    }
    QString last_said() const { return voice.said().isEmpty() ? QString() : voice.said().back(); }
};
