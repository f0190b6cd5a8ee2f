// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/identity/named_faces.hpp"
#include "faces/identity/near_groups.hpp"

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace tp {

using FaceId = std::int64_t;
using PhotoId = std::int64_t;

/// A face of a photograph that may be guessed from (unfit.hpp).
struct KnownFace {
    FaceId id = 0;
    PhotoId photo = 0;
    FaceDescriptor descriptor{};
    std::optional<std::int64_t> moment_ms; ///< when it was photographed, since 1970; nothing: not known

    bool operator==(const KnownFace&) const = default;
};

/// One that comes, and who it is as far as people have said: it joins no group of another name, and names the group
/// that it joins or begins.
struct ComingFace : KnownFace {
    std::string said; ///< empty: nothing
};

/// Faces that seem to be one person's.
struct FaceGroup {
    GroupId id = 0;
    std::string name;          ///< empty: nobody has said it
    std::vector<FaceId> faces; ///< ascending

    bool operator==(const FaceGroup&) const = default;
};

/// Everything that is known of groups, to be kept and to begin with again.
struct GroupsState {
    std::vector<KnownFace> faces;                   ///< by id
    std::vector<FaceGroup> groups;                  ///< by id
    std::set<std::pair<FaceId, GroupId>> not_there; ///< a person has said that this face is not that group's
    GroupId last_group = 0;                         ///< the highest number given; none is given twice

    bool operator==(const GroupsState&) const = default;
};

/// What a person's word has changed, to be undone.
struct GroupsChange {
    struct Move {
        FaceId face;
        GroupId before, after;
    };
    struct Naming {
        GroupId group;
        std::optional<std::string> before, after; ///< nothing: there is no such group
    };
    std::vector<Move> moves;
    std::vector<Naming> namings;
    std::set<std::pair<FaceId, GroupId>> said_apart, no_more_apart;
    std::set<std::pair<FaceId, FaceId>>
        were_together; ///< of one photograph, the first one moved, the other not
};

/// Who a face may be.
struct NameOffer {
    std::string name;
    double distance = 0.0; ///< root mean square to the faces of that name that are nearest in time
    bool sure = false;     ///< near enough, and nobody else is nearly as near
};

/// Faces of an album grouped by person as they come, and what people say about the groups. A face joins the group
/// whose faces are the nearest in the root mean square, if they are near enough, or begins a group. Then groups
/// that it shows to be one are joined. Two faces of a photograph are never in one group, unless a person said so; a
/// face never comes back by itself into a group of which a person said that it is not its; groups of two names are never
/// joined but by a person. Names are compared as bytes, and groups of one name are one person's, at several ages say.
/// Deterministic; numbers of faces, photographs and groups decide nothing but ties. One thread at a time.
class FaceGroups {
public:
    FaceGroups() = default;
    /// As kept. Nothing where the state contradicts itself: a face in no group, in two or given twice.
    static std::optional<FaceGroups> from(const GroupsState& state);
    GroupsState state() const;

    /// All faces of one photograph at once: the order in which they are given does not count. False, and nothing is
    /// added, where they are of several photographs or one is known already.
    bool add(const std::vector<ComingFace>& of_one_photo);
    /// The face is gone. A group of none is gone too.
    void remove(FaceId face);

    // What a person says. Nothing where there is no such face or group.
    /// Who the group is; an empty name takes its name away.
    std::optional<GroupsChange> name(GroupId group, const std::string& name);
    /// "Not this person": the face begins a group of its own and never joins this one again by itself.
    std::optional<GroupsChange> take_out(FaceId face);
    /// Both groups are one person: `other` is gone, its name too unless `group` has none.
    std::optional<GroupsChange> merge(GroupId group, GroupId other);
    /// As it was before; faces that came since stay where they are, those that are gone stay gone. False, and nothing is
    /// changed, where something else has changed the same since, or a face that came since stands against it.
    bool undo(const GroupsChange& change);

    std::size_t face_count() const { return faces_.size(); }
    std::vector<FaceGroup> groups() const; ///< the largest first, then the oldest
    std::optional<FaceGroup> group(GroupId group) const;
    std::optional<GroupId> group_of(FaceId face) const;

    /// Names for a face that has none, the likeliest first, at most `most`: not those that a person has ruled out,
    /// nor that of another face in the photograph. Where moments are known the faces nearest in time count alone,
    /// for children grow.
    std::vector<NameOffer> offers(FaceId face, std::size_t most = 3) const;
    /// Those who have a name, by group: the faces by which a picture of today would be offered it.
    std::vector<NamedFaces> named() const;

private:
    struct Face {
        KnownFace known;
        GroupId group = 0;
        std::set<GroupId> not_there;
    };
    struct Group {
        std::string name;
        std::set<FaceId> faces;
        GroupSum sum;
    };

    void move(Face& face, GroupId to, GroupsChange& change);
    void put(Face& face, GroupId group);
    void lift(Face& face);
    bool shares_photo(const Face& face, GroupId group) const;
    bool is_ruled_out(const Face& face, GroupId id, const Group& group) const;
    bool may_join(const Face& face, const std::string& said, GroupId id) const;
    bool may_merge(const Group& into, GroupId id, const Group& other, GroupId other_id) const;
    void merge_what_it_shows(FaceId face, const std::vector<GroupId>& near);
    void merge_into(GroupId into, GroupId from, GroupsChange* change);
    bool can_undo(const GroupsChange& change) const;
    std::optional<double> squared_in_time(const Face& face, const Group& group) const;

    std::map<FaceId, Face> faces_;
    std::map<GroupId, Group> groups_;
    std::unordered_map<PhotoId, std::vector<FaceId>> of_photo_;
    NearGroups near_;
    GroupId last_group_ = 0;
};

} // namespace tp
