// SPDX-License-Identifier: Apache-2.0
#include "app/pages/settings/storage_settings.hpp"

#include "core/files/file_name.hpp"

#include <QLocale>

#include <cstdint>
#include <system_error>
#include <utility>

namespace tp {

namespace {

QString native(const std::filesystem::path& path) { return QString::fromStdString(name_in_utf8(path)); }

/// Bytes of all files in a folder, those below it too.
std::uintmax_t bytes_in(const std::filesystem::path& folder) {
    std::uintmax_t bytes = 0;
    std::error_code error;
    for (std::filesystem::recursive_directory_iterator at(folder, error), end; !error && at != end;
         at.increment(error)) {
        std::error_code of_file;
        if (at->is_regular_file(of_file))
            bytes += at->file_size(of_file);
    }
    return bytes;
}

} // namespace

StorageSettings::StorageSettings(SettingSteps& steps, Narrator& narrator, Stored stored,
                                 std::filesystem::path calibrations)
    : steps_(steps), narrator_(narrator), stored_(std::move(stored)), calibrations_(std::move(calibrations)),
      chooser_(narrator) {
    connect(&steps, &SettingSteps::changed, this, &StorageSettings::changed);
    connect(&chooser_, &FolderChooser::cancelled, this, [this] {
        set_choosing(false);
        steps_.tell(tr("No folder was chosen."));
    });
    connect(&chooser_, &FolderChooser::chosen, this, [this](const QString& folder) {
        set_choosing(false);
        if (folders().contains(folder))
            return steps_.tell(tr("This folder is already in the album."));
        steps_.make(tr("the added folder"), tr("%1 now belongs to the album.").arg(folder),
                    [&folder](Choices& choices) { choices.folders << folder; });
    });
}

void StorageSettings::set_choosing(bool choosing) {
    if (choosing_ == choosing)
        return;
    choosing_ = choosing;
    emit choosingChanged();
}

void StorageSettings::addFolder() {
    set_choosing(true);
    chooser_.begin();
}

bool StorageSettings::cancel() {
    const bool was = choosing_;
    if (was)
        chooser_.cancel();
    return was;
}

void StorageSettings::removeFolder(int index) {
    if (index < 0 || index >= folders().size())
        return;
    const QString folder = folders()[index];
    steps_.make(tr("the removed folder"),
                tr("%1 no longer belongs to the album. Its photographs and recordings stay where they are.")
                    .arg(folder),
                [index](Choices& choices) { choices.folders.removeAt(index); });
}

QStringList StorageSettings::stored() const {
    QStringList list{tr("Nothing leaves this computer: TouchPhoto connects to no other.")};
    list << tr("These settings, in %1.").arg(native(stored_.preferences));
    list << tr("An index of the album, in %1 (%2). It can be deleted at any time.")
                .arg(native(stored_.cache),
                     QLocale().formattedDataSize(static_cast<qint64>(bytes_in(stored_.cache))));
    if (knowFaces())
        list << tr("In that index, for each face of the album, numbers by which it is known again.");
    if (std::error_code error; std::filesystem::exists(calibrations_, error))
        list << tr("Where your force device lies on the screen, in %1.").arg(native(calibrations_));
    for (const QString& folder : folders())
        list << tr("Names, descriptions and recordings, beside the photographs in %1.").arg(folder);
    if (!steps_.now().last_photo.isEmpty())
        list << tr("The photograph you opened last: %1.").arg(steps_.now().last_photo);
    return list;
}

void StorageSettings::setKnowFaces(bool on) {
    if (on == knowFaces())
        return;
    steps_.make(tr("comparing faces"),
                on ? tr("Faces are compared, so that names can be offered.")
                   : tr("Faces are not compared. What was kept about them is deleted; names stay."),
                [on](Choices& choices) { choices.know_faces = on; });
}

void StorageSettings::discardIndex() {
    stored_.discard_index();
    narrator_.tell(
        tr("The index is deleted when TouchPhoto ends, and rebuilt from the photographs at the next start."),
        Priority::message);
}

} // namespace tp
