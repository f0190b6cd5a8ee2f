// SPDX-License-Identifier: Apache-2.0
#include "app/album/check/companion_check.hpp"

#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/conflicts.hpp"
#include "app/album/metadata/photo_name.hpp"
#include "app/album/metadata/read_record.hpp"
#include "app/album/metadata/sidecar_names.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"

#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace tp {

namespace fs = std::filesystem;

namespace {

/// The photograph that a companion's name speaks of.
fs::path photo_of(const fs::path& companion) {
    std::string name = companion.filename().string();
    for (const std::string_view end : {tags_end, contours_end, xmp_end})
        if (name.ends_with(end))
            return companion.parent_path() / name.substr(0, name.size() - end.size());
    return companion;
}

/// Folder and stem of every photograph, be it a link to nothing.
std::set<fs::path> stems_of_photos(const Inventory& there) {
    std::set<fs::path> stems;
    for (const fs::path& photo : there.photos)
        stems.insert(photo.parent_path() / photo.stem());
    for (const fs::path& link : there.links)
        if (has_photo_name(link))
            stems.insert(link.parent_path() / link.stem());
    return stems;
}

class Photographs {
public:
    Photographs(const fs::path& album, PhotosByContent known) : album_(album), by_hash_(std::move(known)) {}

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

private:
    const fs::path& album_;
    PhotosByContent by_hash_;
    bool all_hashed_ = false;
};

void left_behind(const fs::path& photo, const std::vector<fs::path>& files, Photographs& photographs,
                 Findings& findings) {
    const auto hash = content_hash_in(sidecar_of(photo));
    const auto now = hash && !hash->empty() ? photographs.by_content(*hash) : std::nullopt;
    const std::string sentence = "The photograph of " + quoted(files.front()) + " is not beside it any more.";
    if (!now) {
        findings.add(Finding::Kind::left_behind, files.front(), sentence);
        return;
    }
    findings.add(Finding::Kind::left_behind, files.front(), sentence,
                 "It goes to where the photograph is now, " + quoted(*now) + ".",
                 [&] { return findings.keeper().move_companions(photo, *now); });
}

} // namespace

void check_companions(const Inventory& there, PhotosByContent known, Findings& findings) {
    Photographs photographs(findings.album(), std::move(known));
    std::vector<fs::path> companions = there.tags;
    companions.insert(companions.end(), there.others.begin(), there.others.end());
    const std::set<fs::path> stems = stems_of_photos(there);
    std::map<fs::path, std::vector<fs::path>> by_photo; // that is not there
    for (const fs::path& companion : companions) {
        const fs::path photo = photo_of(companion);
        const bool of_a_stem = companion.extension() == xmp_end && stems.contains(photo);
        if (is_gone(photo) && !of_a_stem && !conflict_original(companion.filename().string()) &&
            name_taken(companion))
            by_photo[photo].push_back(companion);
    }
    for (const auto& [photo, files] : by_photo)
        if (has_photo_name(photo)) // other programs' sidecars are not ours to judge
            left_behind(photo, files, photographs, findings);
}

} // namespace tp
