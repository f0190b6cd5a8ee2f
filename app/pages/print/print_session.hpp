// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/print/printed_photo.hpp"
#include "app/pages/print/printed_sheet.hpp"
#include "app/parts/narration/narrator.hpp"
#include "audio/sound/earcon_player.hpp"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

#include <filesystem>

namespace tp {

/// A photograph's faces on the way to paper: the photograph, the sheet, and storing it.
class PrintSession final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(tp::PrintedPhoto* photo READ photo CONSTANT)
    Q_PROPERTY(tp::PrintedSheet* sheet READ sheet CONSTANT)
public:
    /// `folder` is where sheets are stored; `read` is called on another thread. All must outlive the session.
    PrintSession(Narrator& narrator, EarconPlayer& earcons, std::filesystem::path folder,
                 PrintedPhoto::Read read = PrintedPhoto::read_subject);
    /// TouchPhoto in the user's documents.
    static std::filesystem::path usual_folder();

    PrintedPhoto* photo() { return &photo_; }
    PrintedSheet* sheet() { return &sheet_; }

    void open_photo(const std::filesystem::path& photo);
    Q_INVOKABLE void enter();
    Q_INVOKABLE void leave();
    /// Writes the sheet; `ending` is "pdf" or "svg". A file that is there already stays.
    Q_INVOKABLE void store(const QString& ending);

private:
    Narrator& narrator_;
    EarconPlayer& earcons_;
    std::filesystem::path folder_;
    PrintedPhoto photo_;
    PrintedSheet sheet_;
};

} // namespace tp
