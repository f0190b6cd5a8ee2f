// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/index/known_faces.hpp"
#include "faces/identity/face_groups.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace tp {

/// A face among those that seem to be one person's.
struct PersonFace : PlacedFace {
    GroupId group = 0;
    bool said = false; ///< somebody has said who it is
};

/// Faces that seem to be one person's: one group, or all groups of one name.
struct Person {
    std::string name; ///< empty: nobody has said it
    std::vector<GroupId> groups;
    std::vector<PersonFace> faces; ///< the newest first
    std::string perhaps; ///< of one without a name who may be a named one; empty: nobody is like this one
    std::size_t photos = 0;
    std::size_t to_confirm = 0; ///< faces of which nobody has said who they are
};

/// The people of an album.
struct People {
    /// Those about whom there is something to say first, each the largest first. One that is seen on one photograph
    /// only and has no name is not among them.
    std::vector<Person> persons;
    std::size_t to_look = 0;     ///< photographs that nobody has looked at yet
    std::size_t alone = 0;       ///< faces like no other, without a name
    std::size_t not_guessed = 0; ///< too small, blurred, turned …: faces/identity/unfit.hpp
};

/// Who a face of a photograph may be.
struct FaceOffer {
    Rect part;              ///< 0 … 1 of the picture in which it was found
    int turned_degrees = 0; ///< of that picture
    std::string name;
};

/// The people that groups make, where their faces are seen. `said` tells of a face whether somebody has said who it is.
People people_of(const std::vector<FaceGroup>& groups, const std::vector<PlacedFace>& placed,
                 const std::function<bool(FaceId)>& said);

} // namespace tp
