// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/photo_record.hpp"
#include "core/base/result.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// The name of the file that this one is a conflict copy of, as Syncthing, Nextcloud, ownCloud, Dropbox and
/// Seafile name them; none where it is not one. Copies of copies: the first file's.
std::optional<std::string> conflict_original(std::string_view file_name);

/// The conflict copies of photographs' sidecars that lie beside them. A folder is read once, when the first of its photographs is
/// asked for, so that many photographs in one folder cost as much each as few.
class ConflictCopies {
public:
    /// Oldest first; of those that were there when the folder was read, those that still are.
    std::vector<std::filesystem::path> of(const std::filesystem::path& photo);

private:
    using ByOwner =
        std::map<std::string, std::vector<std::filesystem::path>>; ///< of a sidecar's name without `.xmp`
    static ByOwner copies_in(const std::filesystem::path& folder);

    std::map<std::filesystem::path, ByOwner> folders_;
};

/// What came of one sidecar brought into another.
struct MergedSidecar {
    bool changed = false;
    std::vector<std::string> told; ///< where two differed: sentences
};

/// Brings what another sidecar of the same photograph says into `IMG_1.jpg.xmp`: tags, faces, persons and keywords are
/// united, tags by their file, of the other's only those `wanted`; a text in a language that only one has is added. Where
/// two differ, the label field of a tag of the newer one wins and the text that is there stays; the other is told. An
/// error: nothing was changed.
Result<MergedSidecar> merge_sidecar(const std::filesystem::path& photo, const std::filesystem::path& other,
                                    bool other_is_newer, const std::function<bool(const Tag&)>& wanted = {});

/// Brings in only what other programs wrote into a sidecar that ours displaced at that very moment: their own properties and
/// keywords. Faces, persons, tags and texts are left, because what displaced it may have taken them away.
Result<MergedSidecar> merge_foreign(const std::filesystem::path& photo,
                                    const std::filesystem::path& displaced);

/// Brings every conflict copy of a photograph's sidecars into `IMG_1.jpg.xmp` and then moves the copy to
/// `trash`, as `merge_sidecar` does. Returns sentences for the person who looks after the album, empty where there was no
/// copy. A copy that cannot be read stays where it is, and a sentence says so. An error: nothing was changed,
/// or the sidecar is written and a copy could not be moved (then the next call finds nothing left to add).
Result<std::vector<std::string>> merge_conflicts(const std::filesystem::path& photo,
                                                 const std::filesystem::path& trash);

} // namespace tp
