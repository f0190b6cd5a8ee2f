// SPDX-License-Identifier: Apache-2.0
#include "app/album/check/sidecar_check.hpp"

#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/read_record.hpp"
#include "app/album/metadata/sidecar_names.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_system.hpp"
#include "core/files/file_words.hpp"

namespace tp {

namespace fs = std::filesystem;

namespace {

/// Brings all conflict copies of a photograph's sidecar in and puts them into the trash.
std::string merge(const fs::path& photo, Findings& findings, std::vector<std::string>& told) {
    const fs::path merged = findings.album() / ".touchphoto" / "merged";
    if (std::string reason = make_folder(merged, Readers::owner_only); !reason.empty())
        return reason;
    const auto news = merge_conflicts(photo, merged);
    if (!news)
        return news.error();
    told.insert(told.end(), news->begin(), news->end());
    for (const FolderEntry& copy : entries_of(merged))
        if (const auto put = findings.keeper().trash().put(
                {merged / copy.name}, "another machine's sidecar of " + readable(photo.filename().string()));
            !put)
            return put.error();
    return {};
}

} // namespace

void check_conflict_copies(const fs::path& photo, ConflictCopies& copies, Findings& findings,
                           std::vector<std::string>& told) {
    for (const fs::path& copy : copies.of(photo))
        findings.add(Finding::Kind::conflict_copy, copy,
                     quoted(copy) + " is what another machine made of the sidecar of " +
                         quoted(photo.filename()) + ".",
                     "Both are brought together, and the copy goes to the trash.", [&] {
                         if (!name_taken(copy)) // an earlier one's turn took all of them
                             return std::string{};
                         return merge(photo, findings, told);
                     });
}

bool check_sidecar(const fs::path& photo, Findings& findings) {
    const fs::path sidecar = sidecar_of(photo);
    if (is_gone(sidecar) || looked_twice([&] { return content_hash_in(sidecar); }))
        return true;
    if (link_there(sidecar)) // which is told of already
        return false;
    findings.add_damaged(Finding::Kind::unreadable_sidecar, sidecar, quoted(sidecar) + " cannot be read.",
                         "It goes to the trash, and a new one lists the photograph's recordings.", [&] {
                             return findings.keeper()
                                 .trash()
                                 .put({sidecar},
                                      "unreadable sidecar of " + readable(photo.filename().string()))
                                 .error();
                         });
    return false;
}

void check_readers_of_words(const fs::path& photo, Findings& findings) {
    for (const fs::path& file : {sidecar_of(photo), contours_file(photo)})
        if (more_open_than(file, photo) && !names_its_readers(file.parent_path()))
            findings.add(Finding::Kind::open_to_others, file,
                         "Other people on this machine may read " + quoted(file) +
                             ", but not see its photograph.",
                         "Only who may see the photograph may read it from then on.", [&] {
                             const int error = no_more_open_than(file, photo);
                             return error != 0 ? reason_of(error) : std::string{};
                         });
}

void check_content(const fs::path& photo, const std::string& known_hash, Findings& findings) {
    const auto hash = looked_twice([&] { return content_hash(photo); });
    if (hash && *hash == known_hash)
        return;
    if (!hash) {
        findings.add(Finding::Kind::changed_photo, photo, hash.error());
        return;
    }
    findings.add(Finding::Kind::changed_photo, photo,
                 quoted(photo) + " was changed by another program since its sidecar was written.",
                 "The sidecar is told so.", [&] {
                     SidecarChanges changes;
                     changes.content_hash = *hash;
                     return write_sidecar(photo, changes);
                 });
}

} // namespace tp
