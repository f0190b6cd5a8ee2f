// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/mend/mend_photo.hpp"
#include "app/pages/mend/mend_session.hpp"
#include "app/parts/controls/recording_announcer.hpp"
#include "app/photo/scene/corrections.hpp"
#include "audio/speech/recording_voice.hpp"
#include "core/files/whole_file.hpp"

#include <QTemporaryDir>

#include <string>

/// What the program finds on the drawn photograph of 400 × 300 px: face `i` of `faces` side by side, with smooth
/// closed eyes and lips that have two corners each, and an open outline; no mouth opening, but a nose as an extra.
tp::Extraction drawn_extraction(int faces = 1);

/// The drawn photograph in a folder, as it is read for mending. Its corrections are those in the folder.
tp::MendPhoto drawn_mend_photo(const QString& folder, int faces = 1);

/// A session with the drawn photograph in hand.
struct MendBench {
    QTemporaryDir folder;
    tp::RecordingVoice voice;
    tp::RecordingAnnouncer announcer;
    tp::Narrator narrator{voice, announcer};
    tp::MendSession session{narrator};

    explicit MendBench(int faces = 1) {
        session.setWindow(800, 600);
        session.show(drawn_mend_photo(folder.path(), faces));
        voice.clear();
    }
    std::filesystem::path file() const { return tp::correction_file(folder.filePath("drawn.png").toStdString()); }
    std::string bytes() const {
        const auto read = tp::read_whole(file(), 1 << 20);
        return read ? *read : std::string();
    }
    std::string text() const { return tp::sheet_to_svg(tp::sheet_of(session.work())); }
    QString said() const { return voice.said().isEmpty() ? QString() : voice.said().back(); }
    const tp::MendNode& node(int index) const { return session.line()->nodes.at(static_cast<std::size_t>(index)); }
    QPointF window(int index) const { return session.view().to_window(node(index).at); }
};
