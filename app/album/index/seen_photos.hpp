// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/index/album_queries.hpp"
#include "app/photo/seen/face_mark.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace tp {

/// A photograph of the album that is to be looked at, or put in words for the search.
struct PhotoToWord {
    PhotoSummary summary;
    bool to_look = true; ///< nobody has looked yet, or something older has
};

/// What was seen on the album's photographs, in its index alone: never in a sidecar, a bundle or an export. It is kept by
/// a photograph's bytes, so that a moved or copied one need not be looked at again. Errors are sentences about the
/// database.
class SeenPhotos {
public:
    /// `look`: the version of what looks now; what an older one saw is looked at again. `marks`: faces are to be known
    /// again; what was looked at without that is looked at again.
    SeenPhotos(AlbumIndex& index, int look, bool marks = false) : index_(index), look_(look), marks_(marks) {}

    /// The newest photograph before that place that is not worded as `worded` says, such as "en 1"; none: all are.
    Result<std::optional<PhotoToWord>> next(std::string_view worded,
                                            const std::optional<PlaceInList>& before);
    /// The same of one photograph; nothing where it is worded so, or not in the album.
    Result<std::optional<PhotoToWord>> of(PhotoId photo, std::string_view worded);
    /// Notes, before a look, that it was begun: should it end the program twice, the photograph is not looked at again. The first
    /// time somebody may have ended it.
    std::string begin(std::string_view sha256);
    std::string put(std::string_view sha256, const Looked& looked);
    /// The look that was begun was given up.
    std::string forget(std::string_view sha256);
    /// What `seen` is in words is found by the search from now on; what was there before is not.
    std::string put_words(PhotoId photo, std::string_view worded, std::string_view words);

private:
    Result<std::optional<PhotoToWord>> summarised(std::optional<PhotoId> photo);

    AlbumIndex& index_;
    int look_;
    bool marks_;
};

/// What is kept of a photograph. Throws SqlFault.
std::optional<SeenPhoto> stored_sight(SqlConnection& connection, PhotoId photo);

} // namespace tp
