// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/photo_copy.hpp"

#include "app/album/keeper/photo_files.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <string>
#include <vector>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr int most_names = 10'000;

/// The same bytes, or one of the files cannot be read.
bool same_bytes(const fs::path& a, const fs::path& b) {
    if (link_there(a) || link_there(b) || size_or_zero(a) != size_or_zero(b))
        return false;
    const auto first = content_hash(a), second = content_hash(b);
    return first && second && *first == *second;
}

/// Whether something else than these bytes has the place of a file, or of a file in a folder.
bool is_taken(const fs::path& from, const fs::path& to) {
    if (is_gone(to))
        return false;
    if (!folder_there(from))
        return !same_bytes(from, to);
    if (!folder_there(to))
        return true;
    const std::vector<FolderEntry> files = entries_of(from);
    return std::any_of(files.begin(), files.end(), [&](const FolderEntry& file) {
        return !file.link && is_taken(from / file.name, to / file.name);
    });
}

/// Copies what is a photograph's, a file or the files of a folder, that are not there yet: nobody else may read or hear it.
std::string bring(const fs::path& from, const fs::path& to) {
    if (!folder_there(from))
        return name_taken(to) ? std::string{} : copy_whole(from, to, Readers::owner_only);
    int error = 0;
    const std::vector<FolderEntry> files = entries_of(from, &error);
    if (error != 0)
        return reason_of(error);
    std::string problem = make_folder(to, Readers::owner_only);
    for (const FolderEntry& file : files)
        if (problem.empty() && !file.link && file.facts.kind == FileFacts::Kind::file &&
            !is_temporary(file.name))
            problem = bring(from / file.name, to / file.name);
    return problem;
}

/// A name in the album that is free for the photograph and each of its companions, or where an earlier try
/// brought the same bytes.
Result<CopiedPhoto> destination(const fs::path& source, const fs::path& wanted,
                                const std::vector<Companion>& companions) {
    for (int number = 1; number < most_names; ++number) {
        const fs::path place = numbered(wanted, number);
        const bool there = name_taken(place);
        if (!there && is_disks_fault(errno))
            return Error{reason_of(errno)};
        if (there && same_bytes(source, place))
            return CopiedPhoto{place, true};
        const auto taken = [&](const Companion& one) { return is_taken(one.file, beside(place, one)); };
        if (!there && std::none_of(companions.begin(), companions.end(), taken))
            return CopiedPhoto{place, false};
    }
    return Error{"there are too many photographs of that name in the album."};
}

} // namespace

Result<CopiedPhoto> copy_photo(const fs::path& photo, const std::vector<Companion>& companions,
                               const fs::path& folder) {
    const auto to = destination(photo, folder / photo.filename(), companions);
    if (!to || to->was_there)
        return to;
    std::string problem = make_folder(folder);
    for (std::size_t i = 0; i < companions.size() && problem.empty(); ++i)
        problem = bring(companions[i].file, beside(to->place, companions[i]));
    if (problem.empty())
        problem = copy_whole(photo, to->place);
    return problem.empty() ? to : Result<CopiedPhoto>(Error{problem});
}

} // namespace tp
