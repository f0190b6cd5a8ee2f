// SPDX-License-Identifier: Apache-2.0
#include "app/capture/shutter/photograph_store.hpp"

#include "app/album/keeper/photo_files.hpp"
#include "audio/recordings/recording.hpp"
#include "core/files/file_words.hpp"

#include <QDateTime>
#include <QString>

#include <utility>

namespace tp {

Result<AlbumKeeper::AddedPhoto> PhotographStore::keep(const cv::Mat& picture, const PhotographFacts& facts,
                                                      const std::vector<FaceRegion>& faces) {
    return keep(coded_picture(picture), facts, faces);
}

Result<AlbumKeeper::AddedPhoto> PhotographStore::keep(const Result<CodedPicture>& picture,
                                                      const PhotographFacts& facts,
                                                      const std::vector<FaceRegion>& faces) {
    const QDateTime taken = facts.taken.isValid() ? facts.taken : QDateTime::currentDateTime();
    const QString time = taken.toString(QStringLiteral("yyyy-MM-dd")) + QLatin1Char(' ') +
                         taken.toString(QStringLiteral("HH.mm.ss"));
    const std::filesystem::path name = time.toStdString() + ".jpg";
    const auto bytes = picture ? photograph_jpeg(*picture, facts) : Error{picture.error()};
    if (!bytes)
        return Error{quoted(name) + " cannot be added: " + bytes.error()};
    return keeper_.add_photo(folder_ / name, *bytes, faces);
}

Result<AlbumKeeper::Added> PhotographStore::add_moment(const std::filesystem::path& photo,
                                                       const std::filesystem::path& sound,
                                                       const QDateTime& begun) {
    const std::string before = keeper_.history().next_undo();
    auto added =
        sound.parent_path() == tags_folder(photo) ? listed(photo, sound) : taken_in(photo, sound, begun);
    if (added && before == AlbumKeeper::words_for_added(photo))
        keeper_.history().join(before);
    return added;
}

Result<AlbumKeeper::Added> PhotographStore::listed(const std::filesystem::path& photo,
                                                   const std::filesystem::path& sound) {
    auto tag = keeper_.list_recording(photo, sound.filename().string());
    return tag ? Result<AlbumKeeper::Added>(AlbumKeeper::Added{std::move(tag).value(), {}})
               : Error{tag.error()};
}

Result<AlbumKeeper::Added> PhotographStore::taken_in(const std::filesystem::path& photo,
                                                     const std::filesystem::path& sound,
                                                     const QDateTime& begun) {
    RecordingLabel label{RecordingKind::ambient, {}, {}, {}, {}, {}};
    if (begun.isValid())
        label.recorded = begun.toOffsetFromUtc(begun.offsetFromUtc()).toString(Qt::ISODate).toStdString();
    return keeper_.add_recording(photo, sound, label);
}

} // namespace tp
