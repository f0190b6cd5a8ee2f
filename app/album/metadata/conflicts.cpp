// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/conflicts.hpp"

#include "app/album/metadata/change_sidecar.hpp"
#include "app/album/metadata/merge.hpp"
#include "app/album/metadata/sidecar_names.hpp"
#include "app/album/metadata/xmp_record.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_system.hpp"
#include "core/files/file_words.hpp"
#include "core/files/whole_file.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
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

Result<XmpPacket> packet_in(const fs::path& copy) {
    const auto bytes = read_whole(copy, XmpPacket::most_bytes);
    if (!bytes)
        return Error{bytes.error()};
    auto packet = XmpPacket::from(*bytes);
    if (!packet)
        return Error{"The conflict copy " + quoted(copy) + " cannot be read: " + packet.error()};
    return packet;
}

/// Moves a file into a folder under its own name, or with a number where that is taken.
std::string move_to(const fs::path& trash, const fs::path& file) {
    if (std::string reason = make_folder(trash, Readers::owner_only); !reason.empty())
        return reason;
    constexpr int most_tries = 1000;
    fs::path place = trash / file.filename();
    for (int i = 2; i < most_tries; ++i) {
        if (!name_taken(place))
            return move_file(file, place);
        place = trash / file.stem();
        place += std::string(" ").append(std::to_string(i)).append(file.extension().string());
    }
    return "the trash is full of files of that name.";
}

} // namespace

std::vector<fs::path> conflict_copies(const fs::path& photo) {
    const std::string own = photo.filename().string();
    const std::string shared = photo.stem().string();
    std::vector<fs::path> copies;
    const fs::path folder = photo.has_parent_path() ? photo.parent_path() : fs::path(".");
    for (const FolderEntry& entry : entries_of(folder)) {
        const std::string& name = entry.name;
        if (!is_sidecar_name(name) || entry.link)
            continue;
        const auto original = conflict_original(name);
        if (!original || !is_sidecar_name(*original))
            continue;
        const std::string whose = original->substr(0, original->size() - 4);
        if (whose == own || (whose == shared && photo.has_extension()))
            copies.push_back(folder / name);
    }
    std::sort(copies.begin(), copies.end(), [](const fs::path& a, const fs::path& b) {
        return std::pair(time_of(a), a) < std::pair(time_of(b), b);
    });
    return copies;
}

Result<std::vector<std::string>> merge_conflicts(const fs::path& photo, const fs::path& trash) {
    std::vector<std::string> sentences;
    const std::vector<fs::path> copies = conflict_copies(photo);
    if (copies.empty())
        return sentences;
    for (const fs::path& copy : copies) {
        const auto other = packet_in(copy);
        if (!other) {
            sentences.push_back(other.error() + " It stays where it is.");
            continue;
        }
        const bool newer = time_of(copy) > time_of(sidecar_of(photo));
        std::vector<std::string> told;
        const auto add_other = [&](XmpPacket& sidecar, const Behind& behind) {
            Merge merge =
                merged(parts_from_xmp(sidecar, behind.shape), parts_from_xmp(*other, behind.shape), newer);
            told = std::move(merge.told);
            const auto foreign = add_foreign(sidecar, *other);
            told.insert(told.end(), foreign.begin(), foreign.end());
            edit(sidecar, merge.changes, behind);
            return std::string{};
        };
        if (std::string failed = change_sidecar(photo, add_other); !failed.empty())
            return Error{std::move(failed)};
        if (const std::string failed = move_to(trash, copy); !failed.empty())
            return Error{"The conflict copy " + quoted(copy) + " could not be moved to the trash: " + failed};
        sentences.push_back("The sidecar of " + quoted(photo.filename()) +
                            " was changed in two places at once; it holds both now, and the copy " +
                            quoted(copy.filename()) + " is in the trash.");
        sentences.insert(sentences.end(), told.begin(), told.end());
    }
    return sentences;
}

} // namespace tp
