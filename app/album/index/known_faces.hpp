// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/index/album_index.hpp"
#include "app/album/metadata/photo_record.hpp"
#include "core/geometry/vec.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tp {

/// A face that is known again, and the group that it is kept in.
struct StoredFace {
    std::int64_t id = 0;
    PhotoId photo = 0; ///< the first photograph with these bytes
    std::string numbers;
    std::optional<std::int64_t> moment_ms; ///< when it was photographed, since 1970; nothing: not known
    std::string said;                      ///< who it is, as the groups knew it last
    std::int64_t group = 0;                ///< 0: none yet
};

/// All that is kept of groups.
struct StoredGroups {
    std::vector<StoredFace> faces; ///< of those in a group, by id
    std::map<std::int64_t, std::string> names;
    std::vector<std::pair<std::int64_t, std::int64_t>> apart; ///< face, group
    std::int64_t last = 0;
};

/// A photograph's bytes whose faces came, or of whose faces somebody has said something.
struct FacesToGroup {
    std::string hash;
    struct Face {
        StoredFace stored;
        Rect part; ///< 0 … 1 of the picture in which it was found
    };
    std::vector<Face> faces;
    int turned_degrees = 0; ///< as Extraction::turned_degrees
    struct Copy {
        int orientation = 1;
        std::vector<FaceRegion> regions;
        bool operator==(const Copy&) const = default;
    };
    std::vector<Copy> copies; ///< the photographs with these bytes
};

/// What has become of groups, to be kept.
struct GroupsKept {
    std::vector<std::pair<std::int64_t, std::int64_t>> groups_of; ///< face, group
    std::vector<std::pair<std::int64_t, std::string>> said;       ///< face, who it is
    std::map<std::int64_t, std::optional<std::string>> names;     ///< nothing: the group is gone
    std::vector<std::pair<std::int64_t, std::int64_t>> apart, no_more_apart;
    std::vector<FacesToGroup> done; ///< as they were read; what has changed since is to be grouped again
    std::vector<std::int64_t> taken_away; ///< faces that are gone
    std::int64_t last = 0;
};

/// Where a face is seen.
struct PlacedFace {
    std::int64_t id = 0;
    std::filesystem::path photo;
    std::int64_t moment_ms = 0; ///< of the photograph, else of its file
    int orientation = 1;
    int turned_degrees = 0;
    Rect part;
};

/// Faces that are known again and their groups, in the index alone. Errors are sentences about the database.
class KnownFaces {
public:
    explicit KnownFaces(AlbumIndex& index) : index_(index) {}

    Result<StoredGroups> all();
    /// What is to be grouped, by its hash, the next after this one; nothing where there is none.
    Result<std::optional<FacesToGroup>> next(const std::string& after = {});
    /// Faces that the groups may still know, and that are gone.
    Result<std::vector<std::int64_t>> gone();
    std::string keep(const GroupsKept& kept);
    /// No face is in a group any more, and all are to be grouped.
    std::string begin_anew();
    /// Everything that is kept of faces goes; what can be said of a photograph stays. False where nothing was kept.
    Result<bool> forget();

    /// All of photographs that are there, the newest first; one that lies in two files is told twice.
    Result<std::vector<PlacedFace>> placed();
    /// The same of one photograph.
    Result<std::vector<PlacedFace>> placed_on(const std::filesystem::path& photo);
    /// How many photographs nobody has looked at yet for faces that are known again.
    Result<std::size_t> to_look();
    /// How many faces of photographs that are there nobody guesses from.
    Result<std::size_t> not_guessed();

private:
    AlbumIndex& index_;
};

} // namespace tp
