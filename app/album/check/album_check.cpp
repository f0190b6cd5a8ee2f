// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/album_check.hpp"

#include "app/album/keeper/album_keeper.hpp"
#include "app/album/keeper/importer.hpp"
#include "app/album/keeper/name_languages.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/keeper/recording_facts.hpp"
#include "app/album/metadata/conflicts.hpp"
#include "app/album/metadata/photo_name.hpp"
#include "app/album/metadata/read_record.hpp"
#include "app/album/metadata/sidecar_names.hpp"
#include "audio/recordings/repair_folder.hpp"
#include "audio/recordings/wav_part.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <map>
#include <set>
#include <sys/stat.h>
#include <system_error>

namespace tp {

namespace fs = std::filesystem;

namespace {

using Kind = Finding::Kind;

constexpr std::string_view tags_end = ".tags", contours_end = ".contours.svg", xmp_end = ".xmp";

/// Everything in the album, sorted by what it is; so that what is found does not depend on the order of
/// names.
struct Inventory {
    std::vector<fs::path> photos, temporaries, tags, others;
};

/// Whether a file lies in some album's own folder: in a trash, or in what is being imported.
bool is_kept_apart(const fs::path& below_album) {
    return std::any_of(below_album.begin(), below_album.end(), is_own_folder);
}

Inventory inventory_of(const fs::path& album) {
    Inventory found;
    std::error_code error;
    for (fs::recursive_directory_iterator place(album, fs::directory_options::skip_permission_denied, error),
         end;
         !error && place != end; place.increment(error)) {
        const fs::path file = place->path();
        const std::string name = file.filename().string();
        const bool apart = is_kept_apart(file.lexically_relative(album));
        if (place->is_directory(error)) {
            if (name.starts_with('.') && !apart)
                place.disable_recursion_pending();
            else if (name.ends_with(tags_end) && !apart)
                found.tags.push_back(file);
        } else if (is_temporary(file)) {
            found.temporaries.push_back(file);
        } else if (apart) {
            continue;
        } else if (has_photo_name(file)) {
            found.photos.push_back(file);
        } else if (name.ends_with(contours_end) || name.ends_with(xmp_end)) {
            found.others.push_back(file);
        }
    }
    for (auto* list : {&found.photos, &found.temporaries, &found.tags, &found.others})
        std::sort(list->begin(), list->end());
    return found;
}

/// Whether the process whose number stands in a temporary file's name still runs.
bool writer_lives(const fs::path& temporary) {
    const std::string name = temporary.filename().string();
    const std::size_t begin = name.find_first_of("0123456789");
    const long pid = begin == std::string::npos ? 0 : std::strtol(name.c_str() + begin, nullptr, 10);
    return pid > 0 && (::kill(static_cast<pid_t>(pid), 0) == 0 || errno == EPERM);
}

/// The photograph that a companion's name speaks of.
fs::path photo_of(const fs::path& companion) {
    std::string name = companion.filename().string();
    for (const std::string_view end : {tags_end, contours_end, xmp_end})
        if (name.ends_with(end))
            return companion.parent_path() / name.substr(0, name.size() - end.size());
    return companion;
}

bool has_photo_of_stem(const fs::path& stem) {
    std::error_code error;
    for (const auto& file : fs::directory_iterator(stem.parent_path(), error))
        if (has_photo_name(file.path()) && file.path().stem() == stem.filename())
            return true;
    return false;
}

class Check {
public:
    Check(const fs::path& album, const CheckOptions& options, std::stop_token stop)
        : album_(album), keeper_(album), options_(options), stop_(std::move(stop)) {}

    CheckReport run() {
        const Inventory there = inventory_of(album_);
        for (const fs::path& file : there.temporaries)
            half_written(file);
        for (const fs::path& folder : there.tags)
            unfinished_recordings(folder);
        for (const fs::path& photo : there.photos) {
            if (stop_.stop_requested()) {
                report_.stopped = true;
                return std::move(report_);
            }
            if (options_.report)
                options_.report(report_.photos, photo);
            check_photo(photo);
            ++report_.photos;
        }
        left_behind(there);
        people();
        imports_and_trash();
        return std::move(report_);
    }

private:
    /// Adds a finding; where it can and shall be mended, mends it by `action`, which returns why not.
    template <typename Action>
    void found(Kind kind, const fs::path& file, const std::string& sentence, const std::string& mend,
               Action action) {
        Finding finding{kind, file, sentence, mend, false, {}};
        if (options_.mend && !mend.empty()) {
            finding.problem = action();
            finding.mended = finding.problem.empty();
        }
        report_.findings.push_back(std::move(finding));
    }
    void found(Kind kind, const fs::path& file, const std::string& sentence) {
        found(kind, file, sentence, {}, [] { return std::string{}; });
    }

    void half_written(const fs::path& file) {
        if (writer_lives(file))
            return;
        const std::string sentence = quoted(file) + " was being written when its program ended.";
        if (content_hash_in(file)) // a whole sidecar: may be what another program wrote at that moment
            return found(Kind::half_written, file, sentence, "It goes to the trash.", [&] {
                return keeper_.trash().put({file}, "a sidecar that was being replaced").error();
            });
        found(Kind::half_written, file, sentence, "It is deleted.", [&] {
            std::error_code error;
            fs::remove(file, error);
            return error ? reason_of(error.value()) : sync_folder(file.parent_path());
        });
    }

    void unfinished_recordings(const fs::path& folder) {
        std::error_code error;
        bool any = false;
        for (const auto& file : fs::directory_iterator(folder, error))
            any = any || file.path().filename().string().ends_with(wav_part_end);
        if (!any)
            return;
        if (!options_.mend) {
            for (const auto& file : fs::directory_iterator(folder, error))
                if (file.path().filename().string().ends_with(wav_part_end))
                    found(Kind::unfinished_recording, file.path(),
                          quoted(file.path()) + " was not finished, or is being recorded now.",
                          "It is finished.", [] { return std::string{}; });
            return;
        }
        const auto repaired = repair_folder(folder);
        if (!repaired) {
            found(Kind::unfinished_recording, folder, repaired.error());
            return;
        }
        for (const RepairedPart& part : *repaired)
            if (part.outcome != RepairedPart::Outcome::in_use)
                found(Kind::unfinished_recording, part.part, quoted(part.part) + " was not finished.",
                      "It is finished.", [&] {
                          return part.outcome == RepairedPart::Outcome::failed ? part.sentence
                                                                               : std::string{};
                      });
    }

    void check_photo(const fs::path& photo) {
        conflicts(photo);
        unreadable_sidecar(photo);
        const auto record = read_record(photo);
        if (!record) {
            every_sidecar_was_read_ = false;
            found(Kind::unreadable_sidecar, photo, record.error());
            return;
        }
        recordings(photo, *record);
        remember_people(*record);
        if (options_.hashes && !record->content_hash.empty())
            changed_photo(photo, record->content_hash);
        if (!record->content_hash.empty())
            by_hash_[record->content_hash] = photo;
    }

    void conflicts(const fs::path& photo) {
        for (const fs::path& copy : conflict_copies(photo))
            found(Kind::conflict_copy, copy,
                  quoted(copy) + " is what another machine made of the sidecar of " +
                      quoted(photo.filename()) + ".",
                  "Both are brought together, and the copy goes to the trash.", [&] {
                      if (std::error_code error;
                          !fs::exists(copy, error)) // an earlier one's turn took all of them
                          return std::string{};
                      return merge(photo);
                  });
    }

    /// Brings all conflict copies of a photograph's sidecar in and puts them into the trash.
    std::string merge(const fs::path& photo) {
        const fs::path merged = album_ / ".touchphoto" / "merged";
        if (std::string reason = make_folder(merged, Readers::owner_only); !reason.empty())
            return reason;
        const auto told = merge_conflicts(photo, merged);
        if (!told)
            return told.error();
        report_.told.insert(report_.told.end(), told->begin(), told->end());
        std::error_code error;
        for (const auto& copy : fs::directory_iterator(merged, error))
            if (const auto put = keeper_.trash().put({copy.path()}, "another machine's sidecar of " +
                                                                        readable(photo.filename().string()));
                !put)
                return put.error();
        return {};
    }

    void unreadable_sidecar(const fs::path& photo) {
        const fs::path sidecar = sidecar_of(photo);
        if (!name_taken(sidecar) || content_hash_in(sidecar))
            return;
        every_sidecar_was_read_ = false;
        found(Kind::unreadable_sidecar, sidecar, quoted(sidecar) + " cannot be read.",
              "It goes to the trash, and a new one lists the photograph's recordings.", [&] {
                  return keeper_.trash()
                      .put({sidecar}, "unreadable sidecar of " + readable(photo.filename().string()))
                      .error();
              });
    }

    /// The files of a folder of recordings that nobody is writing.
    static std::set<std::string> recordings_in(const fs::path& folder) {
        std::error_code error;
        std::set<std::string> there;
        for (const auto& file : fs::directory_iterator(folder, error))
            if (file.is_regular_file(error) && !is_temporary(file.path()) &&
                !file.path().filename().string().ends_with(wav_part_end))
                there.insert(file.path().filename().string());
        return there;
    }

    void recordings(const fs::path& photo, const PhotoRecord& record) {
        const fs::path folder = tags_folder(photo);
        const std::set<std::string> there = recordings_in(folder);
        for (const std::string& file : there) {
            ++report_.recordings;
            const auto facts = recording_facts(folder / file);
            if (!facts) {
                found(Kind::unreadable_recording, folder / file, facts.error());
                continue;
            }
            if (std::none_of(record.tags.begin(), record.tags.end(),
                             [&](const Tag& tag) { return tag.file == file; }))
                found(Kind::unlisted_recording, folder / file,
                      quoted(folder / file) + " is not in the list of its photograph.",
                      "It is listed by its own comments.",
                      [&] { return keeper_.list_recording(photo, file).error(); });
        }
        for (const Tag& tag : record.tags)
            if (!there.contains(tag.file))
                missing_recording(photo, tag);
        open_to_others(folder, there);
    }

    void missing_recording(const fs::path& photo, const Tag& tag) {
        const fs::path file = tags_folder(photo) / tag.file;
        const std::string sentence = quoted(file) + " is listed but not there.";
        if (AlbumKeeper keeper(album_around(photo)); keeper.is_in_trash(photo, tag.file))
            found(Kind::missing_recording, file, sentence, "It is in the trash, so it is taken off the list.",
                  [&] { return keeper.forget_recording(photo, tag.file); });
        else
            found(Kind::missing_recording, file, sentence + " Bring it back from a copy of the album.");
    }

    void open_to_others(const fs::path& folder, const std::set<std::string>& files) {
        std::vector<fs::path> open;
        struct stat about {};
        for (const std::string& file : files)
            if (::stat((folder / file).c_str(), &about) == 0 && (about.st_mode & 077u) != 0)
                open.push_back(folder / file);
        if (::stat(folder.c_str(), &about) != 0 || ((about.st_mode & 077u) == 0 && open.empty()))
            return;
        found(Kind::open_to_others, folder,
              "Other people on this machine may listen to recordings in " + quoted(folder) + ".",
              "Only their owner may from then on.", [&] {
                  for (const fs::path& file : open)
                      if (::chmod(file.c_str(), 0600) != 0)
                          return reason_of(errno);
                  return ::chmod(folder.c_str(), 0700) == 0 ? std::string{} : reason_of(errno);
              });
    }

    void changed_photo(const fs::path& photo, const std::string& known) {
        const auto hash = content_hash(photo);
        if (hash && *hash == known)
            return;
        if (!hash) {
            found(Kind::changed_photo, photo, hash.error());
            return;
        }
        found(Kind::changed_photo, photo,
              quoted(photo) + " was changed by another program since its sidecar was written.",
              "The sidecar is told so.", [&] {
                  SidecarChanges changes;
                  changes.content_hash = *hash;
                  return write_sidecar(photo, changes);
              });
    }

    void left_behind(const Inventory& there) {
        std::vector<fs::path> companions = there.tags;
        companions.insert(companions.end(), there.others.begin(), there.others.end());
        std::map<fs::path, std::vector<fs::path>> by_photo; // that is not there
        std::error_code error;
        for (const fs::path& companion : companions) {
            const fs::path photo = photo_of(companion);
            const bool of_a_stem = companion.extension() == xmp_end && has_photo_of_stem(photo);
            if (!fs::is_regular_file(photo, error) && !of_a_stem &&
                !conflict_original(companion.filename().string()) && fs::exists(companion, error))
                by_photo[photo].push_back(companion);
        }
        for (const auto& [photo, files] : by_photo)
            if (has_photo_name(photo)) // other programs' sidecars are not ours to judge
                left_behind(photo, files);
    }

    void left_behind(const fs::path& photo, const std::vector<fs::path>& files) {
        const auto hash = content_hash_in(sidecar_of(photo));
        const auto now = hash && !hash->empty() ? by_content(*hash) : std::nullopt;
        const std::string sentence =
            "The photograph of " + quoted(files.front()) + " is not beside it any more.";
        if (!now) {
            found(Kind::left_behind, files.front(), sentence);
            return;
        }
        found(Kind::left_behind, files.front(), sentence,
              "It goes to where the photograph is now, " + quoted(*now) + ".",
              [&] { return keeper_.move_companions(photo, *now); });
    }

    /// The photograph of this album with these bytes; every photograph is read once for it.
    std::optional<fs::path> by_content(const std::string& hash) {
        if (!all_hashed_) {
            all_hashed_ = true;
            for (const fs::path& photo : inventory_of(album_).photos)
                if (const auto own = content_hash(photo))
                    by_hash_.emplace(*own, photo);
        }
        const auto place = by_hash_.find(hash);
        return place == by_hash_.end() ? std::nullopt : std::optional(place->second);
    }

    void remember_people(const PhotoRecord& record) {
        known_people_.insert(record.persons.begin(), record.persons.end());
        for (const FaceRegion& face : record.faces)
            known_people_.insert(face.name);
        for (const Tag& tag : record.tags) {
            known_people_.insert(tag.label.person);
            known_people_.insert(tag.label.speaker);
        }
    }

    /// How somebody says people's names, and in what language they are read.
    void people() {
        const fs::path folder = keeper_.place_of_name("a").parent_path();
        unfinished_recordings(folder);
        for (const std::string& file : recordings_in(folder))
            if (file.ends_with(NameLanguages::file_end))
                check_name_language(folder / file);
            else
                check_name(folder / file);
        open_to_others(folder, recordings_in(folder));
    }

    void check_name_language(const fs::path& file) {
        const auto to_trash = [&] {
            return keeper_.trash().put({file}, "the language of somebody's name").error();
        };
        const auto name = NameLanguages::read(file);
        if (!name)
            return found(Kind::damaged_name_language, file, name.error(),
                         "It goes to the trash, and the language can be chosen again.", to_trash);
        if (const fs::path place = NameLanguages(keeper_).place_of(name->person); place != file) {
            const std::string sentence = quoted(file) + " says how the name of " + readable(name->person) +
                                         " is read, and does not have its place.";
            if (name_taken(place))
                return found(Kind::damaged_name_language, file, sentence,
                             "Another one has it, so this one goes to the trash.", to_trash);
            return found(Kind::damaged_name_language, file, sentence, "It goes there, " + quoted(place) + ".",
                         [&] { return move_file(file, place); });
        }
        if (!known_people_.contains(name->person) && every_sidecar_was_read_)
            found(Kind::left_behind, file,
                  quoted(file) + " says how the name of " + readable(name->person) +
                      ", who is on no photograph, is read.");
    }

    void check_name(const fs::path& file) {
        const auto facts = recording_facts(file);
        if (!facts) {
            found(Kind::unreadable_recording, file, facts.error(),
                  "It goes to the trash, and the name can be recorded again.",
                  [&] { return keeper_.trash().put({file}, "a name that cannot be heard").error(); });
            return;
        }
        const std::string& person = facts->label.person;
        if (person.empty()) {
            found(Kind::unlisted_recording, file, quoted(file) + " does not say whose name it is.");
            return;
        }
        if (const fs::path place = keeper_.place_of_name(person); place != file)
            misplaced_name(file, person, place);
        else if (!known_people_.contains(person) && every_sidecar_was_read_)
            found(Kind::left_behind, file,
                  quoted(file) + " says the name of " + readable(person) + ", who is on no photograph.");
    }

    /// A name was being recorded when its program ended.
    void misplaced_name(const fs::path& file, const std::string& person, const fs::path& place) {
        const std::string sentence =
            quoted(file) + " says the name of " + readable(person) + " and does not have its place.";
        if (name_taken(place))
            found(Kind::unlisted_recording, file, sentence,
                  "Another one has it, so this one goes to the trash.", [&] {
                      return keeper_.trash().put({file}, "how somebody says " + readable(person)).error();
                  });
        else
            found(Kind::unlisted_recording, file, sentence, "It goes there, " + quoted(place) + ".",
                  [&] { return move_file(file, place); });
    }

    void imports_and_trash() {
        for (const std::string& id : unfinished_imports(album_))
            found(Kind::unfinished_import, album_ / ".touchphoto" / "import" / (id + ".json"),
                  "An import was not finished; go on with it, or give it up.");
        std::vector<std::string> problems;
        keeper_.trash().entries(&problems);
        for (const std::string& problem : problems)
            found(Kind::damaged_trash, keeper_.trash().folder(), problem);
    }

    const fs::path& album_;
    AlbumKeeper keeper_;
    const CheckOptions& options_;
    std::stop_token stop_;
    CheckReport report_;
    std::map<std::string, fs::path> by_hash_;
    bool all_hashed_ = false;
    std::set<std::string> known_people_; ///< those that a photograph speaks of
    bool every_sidecar_was_read_ = true;
};

} // namespace

std::string_view name_of(Finding::Kind kind) {
    constexpr std::array<std::string_view, 13> names{
        "half_written",         "unfinished_recording", "unlisted_recording", "missing_recording",
        "unreadable_recording", "unreadable_sidecar",   "left_behind",        "conflict_copy",
        "changed_photo",        "open_to_others",       "unfinished_import",  "damaged_trash",
        "damaged_name_language"};
    return names[static_cast<std::size_t>(kind)];
}

Result<CheckReport> check_album(const fs::path& album, const CheckOptions& options, std::stop_token stop) {
    std::error_code error;
    if (!fs::is_directory(album, error))
        return Error{"There is no folder " + quoted(album) + "."};
    return Check(album, options, std::move(stop)).run();
}

} // namespace tp
