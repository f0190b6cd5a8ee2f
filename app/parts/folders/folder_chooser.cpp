// SPDX-License-Identifier: Apache-2.0
#include "app/parts/folders/folder_chooser.hpp"

#include "core/files/photo_endings.hpp"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include <algorithm>

namespace tp {

FolderChooser::FolderChooser(Narrator& narrator, QObject* parent) : QObject(parent), narrator_(narrator) {}

QString FolderChooser::pictures_folder() {
    const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    return QFileInfo(pictures).isDir() && QDir(pictures) != QDir::home() ? pictures : QString();
}

bool FolderChooser::hasAbove() const { return !QDir(folder_).isRoot(); }

QString FolderChooser::content() const {
    return photos_ == 0 ? tr("no photographs in this folder itself")
                        : tr("%n photograph(s) in this folder itself", nullptr, photos_);
}

bool FolderChooser::look(const QString& folder) {
    const QDir dir(folder);
    if (!dir.isReadable()) {
        narrator_.tell(tr("The folder %1 cannot be read.").arg(QFileInfo(folder).fileName()), Priority::message);
        return false;
    }
    folder_ = dir.absolutePath();
    below_ = dir.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::LocaleAware | QDir::IgnoreCase);
    const QStringList files = dir.entryList(QDir::Files);
    photos_ = static_cast<int>(std::count_if(files.begin(), files.end(), [](const QString& file) {
        return has_photo_ending(file.toStdString());
    }));
    emit moved();
    return true;
}

void FolderChooser::tell_place() {
    const QString name = QDir(folder_).isRoot() ? tr("the whole computer") : QDir(folder_).dirName();
    const QString below = below_.isEmpty() ? tr("no subfolders")
                                           : tr("%n subfolder(s)", nullptr, static_cast<int>(below_.size()));
    narrator_.tell(tr("Folder %1: %2, %3.").arg(name, content(), below), Priority::touch);
}

void FolderChooser::begin() {
    const QString pictures = pictures_folder();
    begin_in(pictures.isEmpty() ? QDir::homePath() : pictures);
}

void FolderChooser::begin_in(const QString& folder) {
    if (look(folder))
        tell_place();
}

void FolderChooser::goInto(int index) {
    if (index >= 0 && index < below_.size() && look(QDir(folder_).filePath(below_[index])))
        tell_place();
}

void FolderChooser::goUp() {
    QDir dir(folder_);
    if (dir.cdUp() && look(dir.absolutePath()))
        tell_place();
}

void FolderChooser::choose() { emit chosen(folder_); }

void FolderChooser::cancel() { emit cancelled(); }

} // namespace tp
