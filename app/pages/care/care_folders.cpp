// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/care_folders.hpp"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace tp {

CareFolders::CareFolders(OpenAlbum& album, ImportCare& importing, Narrator& narrator, CareTeller& teller)
    : album_(album), importing_(importing), teller_(teller), chooser_(narrator) {
    connect(&album_, &OpenAlbum::folders_changed, this, &CareFolders::foldersChanged);
    connect(&importing_, &ImportCare::folderWanted, this, [this] { choose_for(Purpose::album); });
    connect(&chooser_, &FolderChooser::chosen, this, &CareFolders::take);
    connect(&chooser_, &FolderChooser::cancelled, this, &CareFolders::give_up);
}

void CareFolders::choose_for(Purpose purpose) {
    purpose_ = purpose;
    emit choosingChanged();
    if (choosing())
        chooser_.begin();
}

void CareFolders::take(const QString& folder) {
    const Purpose purpose = purpose_;
    choose_for(Purpose::nothing);
    if (purpose == Purpose::source)
        importing_.import({QUrl::fromLocalFile(folder)});
    else if (purpose == Purpose::album)
        importing_.chooseFolder(QUrl::fromLocalFile(folder));
}

void CareFolders::give_up() {
    if (!choosing())
        return;
    importing_.dropWish();
    choose_for(Purpose::nothing);
    teller_.answer(tr("No folder was chosen."));
}

QUrl CareFolders::picturesFolder() const {
    const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    return QUrl::fromLocalFile(QFileInfo(pictures).isDir() ? pictures : QDir::homePath());
}

} // namespace tp
