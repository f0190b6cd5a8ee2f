// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/album_keeper.hpp"
#include "app/album/keeper/path_text.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/write_sidecar.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"
#include "core/files/folder_lock.hpp"
#include "core/files/new_file.hpp"

#include <memory>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr int most_names = 10'000;

/// Neither a photograph nor anything that would be its own has that name.
bool is_free(const fs::path& place) {
    std::vector<fs::path> left;
    return !name_taken(place) && companions_of(place, &left).empty() && left.empty();
}

/// Writes the bytes under the first free name; where they lie now, or the end of a sentence.
Result<fs::path> placed(const fs::path& wanted, std::string_view bytes) {
    for (int number = 1; number < most_names; ++number) {
        const fs::path place = numbered(wanted, number);
        if (!is_free(place))
            continue;
        auto file = NewFile::beside(place);
        if (!file)
            return Error{file.error()};
        std::string problem = file->write(bytes);
        if (problem.empty())
            problem = file->take_place(Existing::kept);
        if (problem.empty())
            return place;
        if (!name_taken(place)) // nobody came first
            return Error{problem};
    }
    return Error{"there are too many photographs of that name in the album."};
}

} // namespace

std::string AlbumKeeper::words_for_added(const fs::path& photo) {
    const std::string what = readable(photo.filename().string());
    return what + " was added";
}

Result<AlbumKeeper::AddedPhoto> AlbumKeeper::add_photo(const fs::path& wanted, std::string_view bytes,
                                                       const std::vector<FaceRegion>& faces) {
    if (!stays_below(wanted.lexically_relative(album_)))
        return Error{quoted(wanted) + " is not in the album " + quoted(album_) + "."};
    const fs::path folder = wanted.parent_path();
    if (const std::string reason = make_folder(folder); !reason.empty())
        return Error{quoted(wanted) + " cannot be added: " + reason};
    AddedPhoto added;
    {
        const FolderLock lock(folder);
        if (!lock.held())
            return Error{"Another program is using " + quoted(wanted) + "; try again."};
        auto place = placed(wanted, bytes);
        if (!place)
            return Error{quoted(wanted) + " cannot be added: " + place.error()};
        added.photo = std::move(place).value();
    }
    const auto hash = content_hash(added.photo); // by it the sidecar finds its photograph again
    SidecarChanges changes;
    if (!faces.empty())
        changes.faces = faces;
    if (hash)
        changes.content_hash = *hash;
    added.warning = hash ? write_sidecar(added.photo, changes) : hash.error();
    auto id = std::make_shared<std::string>();
    history_.done({words_for_added(added.photo),
                   [this, photo = added.photo, id] {
                       const auto put = put_photo(photo);
                       if (put)
                           *id = *put;
                       return put.error();
                   },
                   [this, id] { return restore(*id); }});
    return added;
}

std::string AlbumKeeper::delete_photo(const fs::path& photo) {
    const auto id = put_photo(photo);
    if (!id)
        return id.error();
    auto current = std::make_shared<std::string>(*id);
    history_.done({readable(photo.filename().string()) + " was deleted",
                   [this, current] { return restore(*current); },
                   [this, current, photo] {
                       const auto again = put_photo(photo);
                       if (again)
                           *current = *again;
                       return again.error();
                   }});
    return {};
}

Result<std::string> AlbumKeeper::put_photo(const fs::path& photo) {
    if (std::string problem = outside(photo); !problem.empty())
        return Error{problem};
    const FolderLock lock(photo.parent_path());
    if (!lock.held())
        return Error{"Another program is using " + quoted(photo) + "; try again."};
    std::vector<fs::path> files;
    for (const Companion& companion : companions_of(photo))
        files.push_back(companion.file);
    files.push_back(photo);
    return trash_.put(files, readable(photo.filename().string()));
}

} // namespace tp
