// SPDX-License-Identifier: Apache-2.0
#include "app/album/check/album_check.hpp"

#include "app/album/check/companion_check.hpp"
#include "app/album/check/findings.hpp"
#include "app/album/check/inventory.hpp"
#include "app/album/check/name_check.hpp"
#include "app/album/check/recording_check.hpp"
#include "app/album/check/sidecar_check.hpp"
#include "app/album/keeper/importer.hpp"
#include "app/album/metadata/read_record.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_system.hpp"
#include "core/files/file_words.hpp"
#include "core/files/foreign_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

namespace tp {

namespace fs = std::filesystem;

namespace {

/// Whether the process whose number stands in a temporary file's name still runs.
bool writer_lives(const fs::path& temporary) {
    const std::string name = temporary.filename().string();
    const std::size_t begin = name.find_first_of("0123456789");
    const long pid = begin == std::string::npos ? 0 : std::strtol(name.c_str() + begin, nullptr, 10);
    return pid > 0 && process_lives(pid);
}

std::string words_for_half_written(const fs::path& file) {
    return quoted(file) + " was being written when its program ended.";
}

/// With where it takes photographs from.
std::string words_for_import(const fs::path& album, const std::string& id) {
    std::string sources;
    if (const auto import = unfinished_import(album, id))
        for (const fs::path& source : import->sources)
            sources += (sources.empty() ? "" : ", ") + quoted(source);
    if (sources.empty())
        return "An import was not finished; go on with it, or give it up.";
    return "An import of " + sources + " was not finished; go on with it, or give it up.";
}

void imports_and_trash(Findings& findings) {
    for (const std::string& id : unfinished_imports(findings.album()))
        findings.add(Finding::Kind::unfinished_import, findings.album(),
                     words_for_import(findings.album(), id));
    for (const fs::path& list : import_lists_in_album(findings.album()))
        if (!link_there(list))
            findings.add(Finding::Kind::import_list, list, words_for_list_in_album(list));
    std::vector<std::string> problems;
    findings.keeper().trash().entries(&problems);
    std::set<std::string> told; // its links are told already
    for (const Finding& finding : findings.all())
        told.insert(finding.sentence);
    for (const std::string& problem : problems)
        if (!told.contains(problem))
            findings.add(Finding::Kind::damaged_trash, findings.keeper().trash().folder(), problem);
}

class Check {
public:
    Check(const fs::path& album, const CheckOptions& options)
        : findings_(album, options.mend), options_(options) {}

    CheckReport run(const std::stop_token& stop) {
        const Inventory there = inventory_of(findings_.album());
        for (const auto& [folder, error] : there.unread)
            findings_.add_folder(folder, error);
        for (const fs::path& link : there.links)
            findings_.add(Finding::Kind::link, link, left_alone(link));
        for (const fs::path& file : there.no_files)
            findings_.add(Finding::Kind::no_file, file, quoted(file) + " is not a file; it is left alone.");
        std::vector<fs::path> sidecars; // whole ones
        for (const fs::path& file : there.temporaries) {
            if (writer_lives(file))
                continue;
            if (looked_twice([&] { return content_hash_in(file); }))
                sidecars.push_back(file);
            else
                findings_.add_damaged(Finding::Kind::half_written, file, words_for_half_written(file),
                                      "It is deleted.", [&] { return remove_file(file); });
        }
        for (const fs::path& folder : there.tags)
            check_unfinished(folder, findings_);
        for (const fs::path& photo : there.photos) {
            if (stop.stop_requested()) {
                report_.stopped = true;
                return finished();
            }
            if (options_.report)
                options_.report(report_.photos, photo);
            check_photo(photo);
            ++report_.photos;
        }
        for (const fs::path& sidecar : sidecars)
            check_displaced(sidecar);
        check_companions(there, std::move(by_hash_), findings_);
        check_names(every_sidecar_was_read_ ? &known_people_ : nullptr, findings_);
        imports_and_trash(findings_);
        return finished();
    }

private:
    void check_photo(const fs::path& photo) {
        check_conflict_copies(photo, conflict_copies_, findings_, report_.told);
        check_readers_of_words(photo, findings_);
        if (!check_sidecar(photo, findings_))
            every_sidecar_was_read_ = false;
        const auto record = read_record(photo);
        if (!record) {
            every_sidecar_was_read_ = false;
            findings_.add(Finding::Kind::unreadable_sidecar, photo, record.error());
            return;
        }
        report_.recordings += check_recordings(photo, *record, deleted_, findings_);
        remember_people(*record);
        if (options_.hashes && !record->content_hash.empty())
            check_content(photo, record->content_hash, findings_);
        if (!record->content_hash.empty())
            by_hash_[record->content_hash] = photo;
    }

    /// A sidecar that ours displaced may be what another program wrote at that moment.
    void check_displaced(const fs::path& sidecar) {
        findings_.add(
            Finding::Kind::half_written, sidecar, words_for_half_written(sidecar),
            "What other programs wrote there is brought in, and it goes to the trash.", [&] {
                const auto hash = content_hash_in(sidecar);
                const auto photo = hash ? by_hash_.find(*hash) : by_hash_.end();
                if (photo != by_hash_.end() && photo->second.parent_path() == sidecar.parent_path()) {
                    const auto merge = merge_foreign(photo->second, sidecar);
                    if (!merge)
                        return merge.error();
                    report_.told.insert(report_.told.end(), merge->told.begin(), merge->told.end());
                }
                return findings_.keeper().trash().put({sidecar}, "a sidecar that was being replaced").error();
            });
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

    CheckReport finished() {
        report_.findings = findings_.all();
        return std::move(report_);
    }

    Findings findings_;
    const CheckOptions& options_;
    CheckReport report_;
    ConflictCopies conflict_copies_;
    Deleted deleted_;
    PhotosByContent by_hash_;
    std::set<std::string> known_people_; ///< those that a photograph speaks of
    bool every_sidecar_was_read_ = true;
};

} // namespace

Result<CheckReport> check_album(const fs::path& album, const CheckOptions& options,
                                const std::stop_token& stop) {
    std::error_code error;
    if (!fs::is_directory(album, error))
        return Error{"There is no folder " + quoted(album) + "."};
    return Check(album, options).run(stop);
}

} // namespace tp
