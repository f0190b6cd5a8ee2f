// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/mend/mend_history.hpp"
#include "app/pages/mend/mend_photo.hpp"
#include "app/pages/mend/mend_selection.hpp"
#include "app/pages/mend/mend_session.hpp"
#include "app/pages/mend/mend_view.hpp"
#include "app/pages/mend/mended_photo.hpp"
#include "app/parts/controls/recording_announcer.hpp"
#include "app/photo/scene/corrections.hpp"
#include "audio/speech/recording_voice.hpp"
#include "core/files/whole_file.hpp"
#include "core/svg/contour_sheet.hpp"

#include <QTemporaryDir>

#include <filesystem>
#include <string>

/// The drawn photograph's features, in their order.
inline constexpr int left_eye = 0, right_eye = 1, lips = 2, mouth_opening = 3, outline = 4, nose = 5;

/// What the program finds on the drawn photograph of 400 × 300 px: face `i` of `faces` side by side, with smooth
/// closed eyes and lips that have two corners each, and an open outline; no mouth opening, but a nose as an extra.
tp::Extraction drawn_extraction(int faces = 1);

/// The drawn photograph in a folder, as it is read for mending. Its corrections are those in the folder.
tp::MendPhoto drawn_mend_photo(const QString& folder, int faces = 1);

/// A folder for the drawn photograph, and what was said.
struct MendGround {
    QTemporaryDir folder;
    tp::RecordingVoice voice;
    tp::RecordingAnnouncer announcer;
    tp::Narrator narrator{voice, announcer};

    std::filesystem::path file() const { return tp::correction_file(folder.filePath("drawn.png").toStdString()); }
    std::string bytes() const {
        const auto read = tp::read_whole(file(), 1 << 20);
        return read ? *read : std::string();
    }
    QString said() const { return voice.said().isEmpty() ? QString() : voice.said().back(); }
};

/// The parts on which every other part of the page stands, with no photograph yet.
struct MendParts : MendGround {
    tp::MendedPhoto photo;
    tp::MendView view{photo};
    tp::MendSelection selection{photo, view, narrator};
    tp::MendHistory history{photo, selection, narrator};

    /// Takes the drawn photograph in hand, its first feature in view.
    void show(int faces = 1) {
        view.setWindow(800, 600);
        photo.show(drawn_mend_photo(folder.path(), faces));
        selection.fitIntoView();
    }
    std::string text() const { return tp::sheet_to_svg(tp::sheet_of(photo.work())); }
    const tp::MendFeature& feature(std::size_t index) const { return photo.work().faces.at(0).features.at(index); }
    const tp::MendNode& node(int index) const { return selection.line()->nodes.at(static_cast<std::size_t>(index)); }
    QPointF window(int index) const { return view.to_window(node(index).at); }
    /// Moves the first point of the feature in hand to the right.
    void move(double by = 1.0) {
        history.step("a point was moved", [this, by](tp::MendWork& work) {
            selection.own_in(work).line->nodes[0].at.x += by;
            selection.own_in(work).mended = true;
        });
    }
};

/// A session with the drawn photograph in hand.
struct MendBench : MendGround {
    tp::MendSession session{narrator};

    explicit MendBench(int faces = 1) {
        session.view()->setWindow(800, 600);
        session.show(drawn_mend_photo(folder.path(), faces));
        voice.clear();
    }
    tp::MendSelection& selection() { return *session.selection(); }
    tp::MendEditing& editing() { return *session.editing(); }
    std::string text() { return tp::sheet_to_svg(tp::sheet_of(session.photo()->work())); }
    const tp::MendNode& node(int index) { return selection().line()->nodes.at(static_cast<std::size_t>(index)); }
    QPointF window(int index) { return session.view()->to_window(node(index).at); }
};
