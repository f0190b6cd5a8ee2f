// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/importer.hpp"

#include "app/album/keeper/import_list.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/photo_name.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"

#include <algorithm>
#include <chrono>
#include <system_error>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr int most_names = 10'000;

std::uintmax_t size_of(const fs::path& file) {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(file, error);
    return error ? 0 : size;
}

/// The photographs that the sources name or hold, each once, in the order of the sources and of names in
/// folders.
std::vector<fs::path> photos_of(const std::vector<fs::path>& sources) {
    std::vector<fs::path> photos;
    for (const fs::path& source : sources) {
        std::error_code error;
        if (!fs::is_directory(source, error)) {
            photos.push_back(source);
            continue;
        }
        std::vector<fs::path> inside;
        for (fs::recursive_directory_iterator
                 place(source, fs::directory_options::skip_permission_denied, error),
             end;
             !error && place != end; place.increment(error)) {
            if (place->path().filename().string().starts_with('.') && place->is_directory(error))
                place.disable_recursion_pending();
            else if (has_photo_name(place->path()) && place->is_regular_file(error))
                inside.push_back(place->path());
        }
        std::sort(inside.begin(), inside.end());
        photos.insert(photos.end(), inside.begin(), inside.end());
    }
    return photos;
}

/// The same bytes, or one of the files cannot be read.
bool same_bytes(const fs::path& a, const fs::path& b) {
    if (size_of(a) != size_of(b))
        return false;
    const auto first = content_hash(a), second = content_hash(b);
    return first && second && *first == *second;
}

/// "IMG_1 (2).jpg" for the second photograph of that name.
fs::path numbered(const fs::path& place, int number) {
    if (number == 1)
        return place;
    fs::path name = place.stem();
    name += " (" + std::to_string(number) + ")";
    name += place.extension();
    return place.parent_path() / name;
}

/// Whether something else than these bytes has the place of a file, or of a file in a folder.
bool is_taken(const fs::path& from, const fs::path& to) {
    std::error_code error;
    if (!name_taken(to))
        return false;
    if (!fs::is_directory(from, error))
        return !same_bytes(from, to);
    for (const auto& file : fs::directory_iterator(from, error))
        if (is_taken(file.path(), to / file.path().filename()))
            return true;
    return false;
}

/// Copies a file, or the files of a folder, that are not there yet. A folder holds recordings: nobody else
/// may hear them.
std::string bring(const fs::path& from, const fs::path& to, Readers readers = Readers::as_usual) {
    std::error_code error;
    if (!fs::is_directory(from, error))
        return name_taken(to) ? std::string{} : copy_whole(from, to, readers);
    std::string problem = make_folder(to, Readers::owner_only);
    for (const auto& file : fs::directory_iterator(from, error))
        if (problem.empty() && file.is_regular_file(error) && !is_temporary(file.path()))
            problem = bring(file.path(), to / file.path().filename(), Readers::owner_only);
    return problem;
}

struct Destination {
    fs::path place;
    bool is_there = false; ///< an earlier import brought the same bytes
};

/// A name in the album that is free for the photograph and each of its companions, or where an earlier try
/// brought the same bytes.
Result<Destination> destination(const fs::path& source, const fs::path& wanted,
                                const std::vector<Companion>& companions) {
    for (int number = 1; number < most_names; ++number) {
        const fs::path place = numbered(wanted, number);
        if (name_taken(place) && same_bytes(source, place))
            return Destination{place, true};
        const auto taken = [&](const Companion& one) { return is_taken(one.file, beside(place, one)); };
        if (!name_taken(place) && std::none_of(companions.begin(), companions.end(), taken))
            return Destination{place, false};
    }
    return Error{"there are too many photographs of that name in the album."};
}

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

} // namespace

std::size_t ImportReport::count(ImportedPhoto::Fate fate) const {
    return static_cast<std::size_t>(std::count_if(
        photos.begin(), photos.end(), [&](const ImportedPhoto& photo) { return photo.fate == fate; }));
}

Importer::Importer(fs::path album, fs::path into, Known known)
    : album_(std::move(album)), into_(std::move(into)), known_(std::move(known)) {}

Result<ImportReport> Importer::import(const std::vector<fs::path>& sources, const Report& report,
                                      std::stop_token stop) {
    std::error_code error;
    std::vector<fs::path> whole;
    for (const fs::path& source : sources) {
        if (!name_taken(source))
            return Error{"There is no file or folder " + quoted(source) + "."};
        whole.push_back(fs::absolute(source, error));
    }
    const ImportList list{into_, whole};
    const auto id = list.save(album_);
    return id ? run(*id, whole, report, stop) : Error{"The import cannot begin: " + id.error()};
}

std::vector<std::string> Importer::unfinished(const fs::path& album) { return ImportList::all(album); }

Result<ImportReport> Importer::go_on(const fs::path& album, const std::string& id, Known known,
                                     const Report& report, std::stop_token stop) {
    const auto list = ImportList::read(album, id);
    if (!list)
        return Error{list.error()};
    return Importer(album, list->into, std::move(known)).run(id, list->sources, report, stop);
}

std::string Importer::give_up(const fs::path& album, const std::string& id) {
    return ImportList::remove(album, id);
}

Result<ImportReport> Importer::run(const std::string& id, const std::vector<fs::path>& sources,
                                   const Report& report, std::stop_token stop) {
    const std::vector<fs::path> photos = photos_of(sources);
    ImportReport result{id, {}, false};
    ImportProgress progress;
    progress.total = photos.size();
    for (const fs::path& photo : photos)
        progress.bytes_total += size_of(photo);
    if (const std::string reason = make_folder(album_ / into_); !reason.empty())
        return Error{"The folder " + quoted(album_ / into_) + " cannot be made: " + reason};
    const Clock clock;
    for (const fs::path& photo : photos) {
        progress.current = photo;
        progress.seconds_left = clock.seconds_left(progress.bytes_done, progress.bytes_total);
        if (report)
            report(progress);
        if (stop.stop_requested()) {
            result.stopped = true;
            return result;
        }
        result.photos.push_back(import_one(photo));
        ++progress.done;
        progress.bytes_done += size_of(photo);
    }
    progress.current.clear();
    progress.seconds_left = 0.0;
    if (report)
        report(progress);
    if (result.count(ImportedPhoto::Fate::failed) == 0)
        ImportList::remove(album_, id);
    return result;
}

ImportedPhoto Importer::import_one(const fs::path& source) {
    ImportedPhoto photo{source, {}, ImportedPhoto::Fate::failed, {}};
    const auto hash = content_hash(source);
    if (!hash) {
        photo.problem = hash.error();
        return photo;
    }
    const auto earlier = std::find_if(this_time_.begin(), this_time_.end(),
                                      [&](const auto& one) { return one.first == *hash; });
    std::optional<fs::path> known = known_ ? known_(*hash) : std::nullopt;
    if (earlier != this_time_.end())
        known = earlier->second;
    const std::vector<Companion> companions = companions_of(source);
    const auto to = known && name_taken(*known)
                        ? Result<Destination>(Destination{*known, true})
                        : destination(source, album_ / into_ / source.filename(), companions);
    if (to && to->is_there) {
        photo.fate = ImportedPhoto::Fate::duplicate;
        photo.place = to->place;
        this_time_.emplace_back(*hash, to->place);
        return photo;
    }
    std::string problem = to ? std::string{} : to.error();
    for (std::size_t i = 0; i < companions.size() && problem.empty(); ++i)
        problem = bring(companions[i].file, beside(to->place, companions[i]));
    if (problem.empty())
        problem = copy_whole(source, to->place);
    if (!problem.empty()) {
        photo.problem = quoted(source) + " was not imported: " + problem;
        return photo;
    }
    photo.place = to->place;
    photo.fate = ImportedPhoto::Fate::imported;
    this_time_.emplace_back(*hash, to->place);
    return photo;
}

} // namespace tp
