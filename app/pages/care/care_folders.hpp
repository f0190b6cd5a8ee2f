// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/open/open_album.hpp"
#include "app/pages/care/care_teller.hpp"
#include "app/pages/care/import_care.hpp"
#include "app/parts/folders/folder_chooser.hpp"
#include "app/parts/narration/narrator.hpp"

#include <QObject>
#include <QString>
#include <QUrl>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// A folder being chosen on the page: to import from, or for the album. What it is chosen for:
///
/// |         | importFolder | album has none | chosen                     | cancelled |
/// |---------|--------------|----------------|----------------------------|-----------|
/// | nothing | source       | album          |                            |           |
/// | source  | source       | album          | nothing; it is imported    | nothing   |
/// | album   | source       | album          | nothing; it is the album's | nothing   |
class CareFolders final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(bool choosing READ choosing NOTIFY choosingChanged)
    Q_PROPERTY(tp::FolderChooser* chooser READ chooser CONSTANT)
    /// The album has one at least.
    Q_PROPERTY(bool hasFolders READ hasFolders NOTIFY foldersChanged)
public:
    /// All must outlive it.
    CareFolders(OpenAlbum& album, ImportCare& importing, Narrator& narrator, CareTeller& teller);

    bool choosing() const { return purpose_ != Purpose::nothing; }
    FolderChooser* chooser() { return &chooser_; }
    bool hasFolders() const { return album_.has_folders(); }

    /// Lets a person choose a folder, whose photographs are then imported.
    Q_INVOKABLE void importFolder() { choose_for(Purpose::source); }
    /// Where a dialog for photographs begins.
    Q_INVOKABLE QUrl picturesFolder() const;

signals:
    void choosingChanged();
    void foldersChanged();

private:
    enum class Purpose { nothing, source, album };
    void choose_for(Purpose purpose);
    void take(const QString& folder);
    void give_up();

    OpenAlbum& album_;
    ImportCare& importing_;
    CareTeller& teller_;
    FolderChooser chooser_;
    Purpose purpose_ = Purpose::nothing;
};

} // namespace tp
