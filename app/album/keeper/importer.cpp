// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/importer.hpp"

#include "app/album/keeper/album_keeper.hpp"
#include "app/album/keeper/import_list.hpp"
#include "app/album/keeper/photo_copy.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/motion_photo.hpp"
#include "audio/recordings/byte_source.hpp"
#include "audio/recordings/camera_sound.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"
#include "core/files/foreign_folder.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <map>
#include <system_error>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

namespace {

using Fate = ImportedPhoto::Fate;

/// How long the rest takes at the speed so far.
class Clock {
public:
    std::optional<double> seconds_left(std::uintmax_t done, std::uintmax_t total) const {
        const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        if (spent < 1.0 || done == 0)
            return std::nullopt;
        return spent * static_cast<double>(total - done) / static_cast<double>(done);
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

class Import {
public:
    Import(const fs::path& album, const std::string& id, const ImportList& list, const ImportTools& tools,
           bool goes_on)
        : album_(album), list_(list), tools_(tools), keeper_(album), goes_on_(goes_on) {
        report_.id = id;
    }

    ImportReport run() {
        const ImportSources sources(list_.sources, ImportList::unpacked_in(album_, report_.id), tools_.stop,
                                    tools_.unpacking);
        for (const ImportSources::Problem& problem : sources.problems()) {
            add({problem.source, {}, Fate::failed, problem.sentence});
            another_try_ |= problem.may_pass;
        }
        progress_.total = sources.photos().size();
        for (const PhotoToImport& photo : sources.photos())
            progress_.bytes_total += photo.bytes;
        const Clock clock;
        for (const PhotoToImport& photo : sources.photos()) {
            progress_.seconds_left = clock.seconds_left(progress_.bytes_done, progress_.bytes_total);
            tell(photo.file);
            if (tools_.stop.stop_requested())
                break;
            add(import_one(photo));
            another_try_ |= report_.photos.back().fate == Fate::failed;
            ++progress_.done;
            progress_.bytes_done += photo.bytes;
        }
        report_.stopped = tools_.stop.stop_requested();
        if (!report_.stopped) {
            progress_.seconds_left = 0.0;
            tell({});
            if (!another_try_)
                ImportList::remove(album_, report_.id);
        }
        return std::move(report_);
    }

private:
    void tell(const fs::path& current) {
        progress_.current = current;
        if (tools_.progress)
            tools_.progress(progress_);
    }

    void add(ImportedPhoto photo) {
        report_.photos.push_back(std::move(photo));
        if (tools_.done)
            tools_.done(report_.photos.back());
    }

    std::optional<fs::path> known(const std::string& hash) const {
        if (const auto earlier = this_time_.find(hash); earlier != this_time_.end())
            return earlier->second;
        const auto place = tools_.known ? tools_.known(hash) : std::nullopt;
        return place && name_taken(*place) ? place : std::nullopt;
    }

    ImportedPhoto import_one(const PhotoToImport& source) {
        const auto hash = content_hash(source.file);
        if (!hash)
            return {source.file, {}, Fate::failed, hash.error()};
        std::vector<fs::path> left;
        const std::vector<Companion> companions = beside_.of(source.file, &left);
        if (const auto place =
                known(*hash)) { // when an import goes on, a kill may have come before the sound
            ImportedPhoto photo{source.file, *place, Fate::duplicate, {}};
            return with_reply(goes_on_ ? with_sound(std::move(photo)) : std::move(photo), companions);
        }
        const auto copied = copy_photo(source.file, companions, album_ / list_.into / source.folder);
        if (!copied)
            return {
                source.file, {}, Fate::failed, quoted(source.file) + " was not imported: " + copied.error()};
        this_time_[*hash] = copied->place;
        ImportedPhoto photo = with_sound(
            {source.file, copied->place, copied->was_there ? Fate::duplicate : Fate::imported, {}});
        if (copied->was_there)
            photo = with_reply(std::move(photo), companions);
        for (const fs::path& one : left) {
            const std::string told =
                link_there(one) ? left_alone(one) : quoted(one) + " is not a file; it is left alone.";
            photo.problem = photo.problem.empty() ? told : photo.problem + " " + told;
        }
        return photo;
    }

    /// With what this copy has beside it and the album's has not. Nothing of the album's own goes to another place in it.
    ImportedPhoto with_reply(ImportedPhoto photo, const std::vector<Companion>& companions) {
        std::error_code error;
        const fs::path below =
            fs::weakly_canonical(photo.source, error).lexically_relative(fs::weakly_canonical(album_, error));
        if (!below.empty() && *below.begin() != ".." &&
            !is_own_folder(*below.begin())) // where a bundle is unpacked
            return photo;
        photo.reply = take_reply(keeper_, photo.place, photo.source, companions);
        for (const std::string& sentence : photo.reply.told)
            photo.problem += (photo.problem.empty() ? "" : " ") + sentence;
        return photo;
    }

    /// With the sound that a camera recorded with the photograph, or why it did not come along.
    ImportedPhoto with_sound(ImportedPhoto photo) {
        if (has_recordings(photo.place)) // its own came along, or this one did before
            return photo;
        const RecordingLabel label{RecordingKind::ambient, {}, {}, {}, {}, {}};
        const auto take = [&](SoundOrigin source, const Result<AlbumKeeper::Added>& added) {
            photo.problem = !added                   ? added.error()
                            : added->warning.empty() ? std::string{}
                                                     : "The sound of " + quoted(photo.source.filename()) +
                                                           " is not whole. " + added->warning;
            if (added)
                photo.sound = TakenSound{added->tag.file, source};
        };
        if (const auto sound = sound_beside(photo.source))
            take(SoundOrigin::sound_file, keeper_.add_recording(photo.place, *sound, label));
        else if (const auto inside = video_in(photo.source))
            take(SoundOrigin::motion_photo,
                 keeper_.add_video_sound(photo.place, photo.source, *inside, label));
        else if (const auto video = video_beside(photo.source))
            take(SoundOrigin::live_photo,
                 keeper_.add_video_sound(photo.place, *video, {0, size_or_zero(*video)}, label));
        return photo;
    }

    /// Whole ones: what a kill left half-written is none.
    static bool has_recordings(const fs::path& photo) {
        const std::vector<FolderEntry> files = entries_of(tags_folder(photo));
        return std::any_of(files.begin(), files.end(),
                           [](const FolderEntry& file) { return !is_temporary(file.name); });
    }

    static std::optional<VideoPlace> video_in(const fs::path& photo) {
        const auto bytes = FileBytes::open(photo);
        return bytes ? video_inside(**bytes) : std::nullopt;
    }

    const fs::path& album_;
    const ImportList& list_;
    const ImportTools& tools_;
    AlbumKeeper keeper_;
    bool goes_on_;
    bool another_try_ = false; ///< of what failed may succeed
    FolderCompanions beside_;  ///< of the sources
    ImportReport report_;
    ImportProgress progress_;
    std::map<std::string, fs::path> this_time_; ///< by SHA-256
};

} // namespace

std::string_view name_of(SoundOrigin source) {
    using namespace std::string_view_literals;
    constexpr std::array names{"sound_file"sv, "motion_photo"sv, "live_photo"sv};
    return names[static_cast<std::size_t>(source)];
}

std::size_t ImportReport::count_replies() const {
    return static_cast<std::size_t>(std::count_if(
        photos.begin(), photos.end(), [](const ImportedPhoto& photo) { return !photo.reply.empty(); }));
}

std::size_t ImportReport::count(Fate fate) const {
    return static_cast<std::size_t>(std::count_if(
        photos.begin(), photos.end(), [&](const ImportedPhoto& photo) { return photo.fate == fate; }));
}

Result<ImportReport> import_photos(const fs::path& album, const fs::path& into,
                                   const std::vector<fs::path>& sources, const ImportTools& tools) {
    const ForeignFolder held(album);
    std::error_code error;
    ImportList list{into.lexically_normal(), {}};
    for (const fs::path& source : sources) {
        if (!name_taken(source))
            return Error{is_disks_fault(errno) ? quoted(source) + " cannot be read: " + reason_of(errno)
                                               : "There is no file or folder " + quoted(source) + "."};
        list.sources.push_back(fs::absolute(source, error));
    }
    if (!list.makes_sense())
        return Error{quoted(into) + " is not a folder in the album."};
    if (const std::string reason = make_folder(album / list.into); !reason.empty())
        return Error{"The folder " + quoted(album / list.into) + " cannot be created: " + reason};
    // By it a photograph in a folder of the album finds the album, and so its trash. A link in its place is left alone.
    static_cast<void>(make_folder(album / ".touchphoto", Readers::owner_only));
    const auto id = list.save(album);
    if (!id)
        return Error{"The import cannot begin: " + id.error()};
    return Import(album, *id, list, tools, false).run();
}

Result<ImportReport> go_on_importing(const fs::path& album, const std::string& id, const ImportTools& tools) {
    const auto list = ImportList::read(album, id);
    return list ? Result<ImportReport>(Import(album, id, *list, tools, true).run()) : Error{list.error()};
}

Result<UnfinishedImport> unfinished_import(const fs::path& album, const std::string& id) {
    const auto list = ImportList::read(album, id);
    return list ? Result<UnfinishedImport>(UnfinishedImport{list->sources, album / list->into})
                : Error{list.error()};
}

std::vector<fs::path> import_lists_in_album(const fs::path& album) { return ImportList::in_album(album); }

std::string words_for_list_in_album(const fs::path& list) {
    return quoted(list) +
           " says what to import, but this computer did not note it; it is left alone. Import the "
           "photographs themselves again; nothing comes twice.";
}

std::vector<std::string> unfinished_imports(const fs::path& album) { return ImportList::all(album); }

std::string give_up_import(const fs::path& album, const std::string& id) {
    return ImportList::remove(album, id);
}

} // namespace tp
