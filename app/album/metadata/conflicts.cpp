// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/conflicts.hpp"

#include "app/album/metadata/change_sidecar.hpp"
#include "app/album/metadata/merge.hpp"
#include "app/album/metadata/sidecar_names.hpp"
#include "app/album/metadata/xmp_record.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_system.hpp"
#include "core/files/file_words.hpp"
#include "core/files/free_name.hpp"
#include "core/files/whole_file.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <iterator>
#include <set>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

namespace {

bool is_sidecar_name(const std::string& name) {
    std::string end = name.size() < 4 ? std::string{} : name.substr(name.size() - 4);
    std::transform(end.begin(), end.end(), end.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return end == ".xmp";
}

/// When it was written, since 1970; 0 where that cannot be known.
std::int64_t time_of(const fs::path& file) {
    const auto facts = facts_of(file);
    return facts ? facts->written_ns : 0;
}

/// An error is the end of a sentence.
Result<XmpPacket> packet_in(const fs::path& sidecar) {
    const auto bytes = read_whole(sidecar, XmpPacket::most_bytes);
    return bytes ? XmpPacket::from(*bytes) : Result<XmpPacket>(Error{bytes.error()});
}

/// Moves a file into a folder under its own name, or with a number where that is taken.
std::string move_to(const fs::path& trash, const fs::path& file) {
    if (std::string reason = make_folder(trash, Readers::owner_only); !reason.empty())
        return reason;
    const auto place = free_name([&](int number) {
        const std::string end = number == 1 ? "" : " " + std::to_string(number);
        return std::vector{trash / (file.stem().string() + end + file.extension().string())};
    });
    return place ? move_file(file, *place) : place.error();
}

} // namespace

std::vector<fs::path> ConflictCopies::of(const fs::path& photo) {
    const fs::path folder = photo.has_parent_path() ? photo.parent_path() : fs::path(".");
    auto read = folders_.find(folder);
    if (read == folders_.end())
        read = folders_.emplace(folder, copies_in(folder)).first;
    std::set<std::string> owners{photo.filename().string()};
    if (photo.has_extension())
        owners.insert(photo.stem().string());
    std::vector<fs::path> copies;
    for (const std::string& owner : owners)
        if (const auto own = read->second.find(owner); own != read->second.end())
            std::copy_if(own->second.begin(), own->second.end(), std::back_inserter(copies), name_taken);
    std::sort(copies.begin(), copies.end(), [](const fs::path& a, const fs::path& b) {
        return std::pair(time_of(a), a) < std::pair(time_of(b), b);
    });
    return copies;
}

ConflictCopies::ByOwner ConflictCopies::copies_in(const fs::path& folder) {
    ByOwner found;
    for (const FolderEntry& entry : entries_of(folder)) {
        if (!is_sidecar_name(entry.name) || entry.link)
            continue;
        const auto original = conflict_original(entry.name);
        if (original && is_sidecar_name(*original))
            found[original->substr(0, original->size() - 4)].push_back(folder / entry.name);
    }
    return found;
}

namespace {

/// `choose` leaves of what the other says what is wanted.
Result<MergedSidecar> brought_in(const fs::path& photo, const fs::path& other, bool other_is_newer,
                                 const std::function<void(RecordParts&)>& choose) {
    const auto packet = packet_in(other);
    if (!packet)
        return Error{"The sidecar " + quoted(other) + " cannot be read: " + packet.error()};
    MergedSidecar result;
    const std::string unchanged = "unchanged";
    const auto add_other = [&](XmpPacket& sidecar, const Behind& behind) {
        const std::string before = sidecar.bytes();
        RecordParts parts = parts_from_xmp(*packet, behind.shape);
        choose(parts);
        result.told = bring_in(sidecar, *packet, parts, other_is_newer, behind);
        result.changed = sidecar.bytes() != before;
        return result.changed ? std::string{} : unchanged;
    };
    if (std::string failed = change_sidecar(photo, add_other); !failed.empty() && failed != unchanged)
        return Error{std::move(failed)};
    return result;
}

} // namespace

Result<MergedSidecar> merge_sidecar(const fs::path& photo, const fs::path& other, bool other_is_newer,
                                    const std::function<bool(const Tag&)>& wanted) {
    return brought_in(photo, other, other_is_newer, [&](RecordParts& parts) {
        if (parts.tags && wanted)
            std::erase_if(*parts.tags, [&](const Tag& tag) { return !wanted(tag); });
    });
}

Result<MergedSidecar> merge_foreign(const fs::path& photo, const fs::path& displaced) {
    return brought_in(photo, displaced, false,
                      [](RecordParts& parts) { parts = added_meanwhile(std::move(parts)); });
}

Result<std::vector<std::string>> merge_conflicts(const fs::path& photo, const fs::path& trash) {
    std::vector<std::string> sentences;
    for (const fs::path& copy : ConflictCopies().of(photo)) {
        if (const auto packet = packet_in(copy); !packet) {
            sentences.push_back("The conflict copy " + quoted(copy) + " cannot be read: " + packet.error() +
                                " It stays where it is.");
            continue;
        }
        const auto merge = merge_sidecar(photo, copy, time_of(copy) > time_of(sidecar_of(photo)));
        if (!merge)
            return Error{merge.error()};
        if (const std::string failed = move_to(trash, copy); !failed.empty())
            return Error{"The conflict copy " + quoted(copy) + " could not be moved to the trash: " + failed};
        sentences.push_back("The sidecar of " + quoted(photo.filename()) +
                            " was changed in two places at once; it holds both now, and the copy " +
                            quoted(copy.filename()) + " is in the trash.");
        sentences.insert(sentences.end(), merge->told.begin(), merge->told.end());
    }
    return sentences;
}

} // namespace tp
