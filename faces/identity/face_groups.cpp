// SPDX-License-Identifier: Apache-2.0
#include "faces/identity/face_groups.hpp"

#include "faces/identity/same_person.hpp"

#include <algorithm>
#include <tuple>

namespace tp {
namespace {

bool names_agree(const std::string& a, const std::string& b) { return a.empty() || b.empty() || a == b; }

} // namespace

std::optional<FaceGroups> FaceGroups::from(const GroupsState& state) {
    FaceGroups groups;
    for (const KnownFace& face : state.faces) {
        if (!groups.faces_.try_emplace(face.id, Face{face, 0, {}}).second)
            return std::nullopt;
        groups.of_photo_[face.photo].push_back(face.id);
    }
    std::size_t placed = 0;
    for (const FaceGroup& group : state.groups) {
        if (group.faces.empty() || groups.groups_.contains(group.id))
            return std::nullopt;
        groups.groups_[group.id].name = group.name;
        for (const FaceId id : group.faces) {
            const auto face = groups.faces_.find(id);
            if (face == groups.faces_.end() || face->second.group != 0)
                return std::nullopt;
            groups.put(face->second, group.id);
            ++placed;
        }
        groups.last_group_ = std::max(groups.last_group_, group.id);
    }
    if (placed != state.faces.size() || groups.groups_.contains(0))
        return std::nullopt;
    groups.last_group_ = std::max(groups.last_group_, state.last_group);
    for (const auto& [id, group] : state.not_there) {
        const auto face = groups.faces_.find(id);
        if (face == groups.faces_.end() || face->second.group == group)
            return std::nullopt;
        face->second.not_there.insert(group);
        groups.last_group_ = std::max(groups.last_group_, group);
    }
    return groups;
}

GroupsState FaceGroups::state() const {
    GroupsState state;
    for (const auto& [id, face] : faces_) {
        state.faces.push_back(face.known);
        for (const GroupId group : face.not_there)
            state.not_there.emplace(id, group);
    }
    for (const auto& [id, group] : groups_)
        state.groups.push_back({id, group.name, {group.faces.begin(), group.faces.end()}});
    state.last_group = last_group_;
    return state;
}

bool FaceGroups::add(const std::vector<ComingFace>& of_one_photo) {
    std::map<FaceId, std::string> said; // by id, whatever the order in which they were given
    for (const ComingFace& face : of_one_photo)
        if (face.photo != of_one_photo.front().photo || faces_.contains(face.id) ||
            !said.emplace(face.id, face.said).second)
            return false;
    struct Way {
        double squared; ///< mean squared distance, steps²
        GroupId group;
        FaceId face;
        auto order() const { return std::tie(squared, group, face); }
    };
    std::vector<Way> ways;
    std::map<FaceId, std::vector<GroupId>> near;
    for (const ComingFace& known : of_one_photo) {
        faces_[known.id] = {static_cast<const KnownFace&>(known), 0, {}};
        of_photo_[known.photo].push_back(known.id);
        near[known.id] = near_.within(known.descriptor, squared_steps(same_person));
        for (const GroupId group : near[known.id])
            if (const double squared = groups_.at(group).sum.mean_squared(known.descriptor);
                squared <= squared_steps(same_person))
                ways.push_back({squared, group, known.id});
    }
    std::ranges::sort(ways, {}, &Way::order);
    const auto join = [&](FaceId id, GroupId group) {
        put(faces_.at(id), group);
        if (std::string& name = groups_.at(group).name; name.empty())
            name = said.at(id);
    };
    for (const Way& way : ways)
        if (const Face& face = faces_.at(way.face);
            face.group == 0 && may_join(face, said.at(way.face), way.group))
            join(way.face, way.group);
    for (const auto& [id, _] : said)
        if (faces_.at(id).group == 0)
            join(id, ++last_group_);
    for (const auto& [id, _] : said)
        merge_what_it_shows(id, near[id]);
    return true;
}

void FaceGroups::remove(FaceId id) {
    const auto face = faces_.find(id);
    if (face == faces_.end())
        return;
    lift(face->second);
    const auto photo = of_photo_.find(face->second.known.photo);
    std::erase(photo->second, id);
    if (photo->second.empty())
        of_photo_.erase(photo);
    faces_.erase(face);
}

std::optional<GroupsChange> FaceGroups::name(GroupId id, const std::string& name) {
    const auto group = groups_.find(id);
    if (group == groups_.end())
        return std::nullopt;
    GroupsChange change;
    change.namings.push_back({id, group->second.name, name});
    group->second.name = name;
    return change;
}

std::optional<GroupsChange> FaceGroups::take_out(FaceId id) {
    const auto found = faces_.find(id);
    if (found == faces_.end())
        return std::nullopt;
    Face& face = found->second;
    const GroupId before = face.group;
    GroupsChange change;
    if (groups_.at(before).faces.size() == 1)
        change.namings.push_back({before, groups_.at(before).name, std::nullopt});
    move(face, ++last_group_, change);
    change.namings.push_back({face.group, std::nullopt, std::string()});
    face.not_there.insert(before);
    change.said_apart.emplace(id, before);
    return change;
}

std::optional<GroupsChange> FaceGroups::merge(GroupId id, GroupId other_id) {
    if (id == other_id || !groups_.contains(id) || !groups_.contains(other_id))
        return std::nullopt;
    GroupsChange change;
    merge_into(id, other_id, &change);
    return change;
}

/// With `said`, a person says so, and what stands against it no more does.
void FaceGroups::merge_into(GroupId id, GroupId from, GroupsChange* said) {
    GroupsChange untold;
    GroupsChange& change = said ? *said : untold;
    Group& group = groups_.at(id);
    const std::set<FaceId> staying = group.faces, moving = groups_.at(from).faces;
    const std::string other_name = groups_.at(from).name;
    change.namings.push_back({from, other_name, std::nullopt});
    if (group.name.empty() && !other_name.empty()) {
        change.namings.push_back({id, std::string(), other_name});
        group.name = other_name;
    }
    for (const FaceId face_id : moving)
        move(faces_.at(face_id), id, change);
    for (auto& [face_id, face] : faces_) {
        if (moving.contains(face_id) && face.not_there.erase(id) > 0)
            change.no_more_apart.emplace(face_id, id);
        else if (staying.contains(face_id) && face.not_there.erase(from) > 0)
            change.no_more_apart.emplace(face_id, from);
        else if (face.not_there.contains(from) && face.not_there.insert(id).second)
            change.said_apart.emplace(face_id, id); // what is not of the one that is gone is not of this one
    }
}

bool FaceGroups::can_undo(const GroupsChange& change) const {
    std::set<GroupId> gone; // by the change
    for (const GroupsChange::Naming& naming : change.namings) {
        const auto group = groups_.find(naming.group);
        if (naming.after ? group == groups_.end() || group->second.name != *naming.after
                         : group != groups_.end())
            return false;
        if (!naming.after)
            gone.insert(naming.group);
    }
    std::map<FaceId, GroupId> back;
    for (const GroupsChange::Move& move : change.moves)
        if (const auto face = faces_.find(move.face); face != faces_.end()) {
            if (face->second.group != move.after ||
                !(gone.contains(move.before) || groups_.contains(move.before)))
                return false;
            back[move.face] = move.before;
        }
    for (const auto& [id, before] : back) // a face of the same photograph that came to where this one was
        for (const FaceId other : of_photo_.at(faces_.at(id).known.photo))
            if (other != id && !back.contains(other) && faces_.at(other).group == before &&
                !change.were_together.contains({id, other}))
                return false;
    return true;
}

bool FaceGroups::undo(const GroupsChange& change) {
    if (!can_undo(change))
        return false;
    for (const auto& [face, group] : change.said_apart)
        if (const auto found = faces_.find(face); found != faces_.end())
            found->second.not_there.erase(group);
    for (const auto& [face, group] : change.no_more_apart)
        if (const auto found = faces_.find(face); found != faces_.end())
            found->second.not_there.insert(group);
    for (const GroupsChange::Move& move : change.moves)
        if (const auto face = faces_.find(move.face); face != faces_.end()) {
            lift(face->second);
            put(face->second, move.before);
        }
    for (const GroupsChange::Naming& naming : change.namings)
        if (const auto group = groups_.find(naming.group); naming.before && group != groups_.end())
            group->second.name = *naming.before;
    return true;
}

std::vector<FaceGroup> FaceGroups::groups() const {
    std::vector<FaceGroup> all = state().groups;
    std::ranges::stable_sort(
        all, [](const FaceGroup& a, const FaceGroup& b) { return a.faces.size() > b.faces.size(); });
    return all;
}

std::optional<FaceGroup> FaceGroups::group(GroupId id) const {
    const auto group = groups_.find(id);
    if (group == groups_.end())
        return std::nullopt;
    return FaceGroup{id, group->second.name, {group->second.faces.begin(), group->second.faces.end()}};
}

std::optional<GroupId> FaceGroups::group_of(FaceId id) const {
    const auto face = faces_.find(id);
    return face == faces_.end() ? std::nullopt : std::optional(face->second.group);
}

void FaceGroups::move(Face& face, GroupId to, GroupsChange& change) {
    const GroupId before = face.group;
    change.moves.push_back({face.known.id, before, to});
    for (const FaceId other : of_photo_.at(face.known.photo))
        if (other != face.known.id && faces_.at(other).group == before)
            change.were_together.emplace(face.known.id, other);
    lift(face);
    put(face, to);
}

void FaceGroups::put(Face& face, GroupId id) {
    Group& group = groups_[id];
    group.faces.insert(face.known.id);
    group.sum.add(face.known.descriptor);
    face.group = id;
    near_.set(id, group.sum);
}

void FaceGroups::lift(Face& face) {
    const auto group = groups_.find(face.group);
    group->second.faces.erase(face.known.id);
    group->second.sum.take(face.known.descriptor);
    if (group->second.faces.empty()) {
        near_.erase(face.group);
        groups_.erase(group);
    } else {
        near_.set(face.group, group->second.sum);
    }
    face.group = 0;
}

bool FaceGroups::shares_photo(const Face& face, GroupId group) const {
    return std::ranges::any_of(of_photo_.at(face.known.photo), [&](FaceId other) {
        return other != face.known.id && faces_.at(other).group == group;
    });
}

bool FaceGroups::is_ruled_out(const Face& face, GroupId id, const Group& group) const {
    return std::ranges::any_of(face.not_there, [&](GroupId other) {
        if (other == id)
            return true;
        const auto known = groups_.find(other);
        return known != groups_.end() && !group.name.empty() && known->second.name == group.name;
    });
}

bool FaceGroups::may_join(const Face& face, const std::string& said, GroupId id) const {
    const Group& group = groups_.at(id);
    return names_agree(said, group.name) && !shares_photo(face, id) && !is_ruled_out(face, id, group);
}

bool FaceGroups::may_merge(const Group& into, GroupId id, const Group& other, GroupId other_id) const {
    return names_agree(into.name, other.name) &&
           std::ranges::all_of(other.faces,
                               [&](FaceId face) {
                                   return !shares_photo(faces_.at(face), id) &&
                                          !is_ruled_out(faces_.at(face), id, into);
                               }) &&
           std::ranges::none_of(into.faces,
                                [&](FaceId face) { return is_ruled_out(faces_.at(face), other_id, other); });
}

/// Joins the face's group and each of those near it that are as near to one another as one person's.
void FaceGroups::merge_what_it_shows(FaceId face, const std::vector<GroupId>& near) {
    std::vector<std::pair<double, GroupId>> others;
    for (const GroupId id : near)
        if (id != faces_.at(face).group && groups_.contains(id))
            others.emplace_back(groups_.at(id).sum.mean_squared(groups_.at(faces_.at(face).group).sum), id);
    std::ranges::sort(others);
    for (const auto& [_, id] : others) {
        const GroupId own = faces_.at(face).group;
        const Group &mine = groups_.at(own), &other = groups_.at(id);
        if (mine.sum.mean_squared(other.sum) > squared_steps(same_person) || !may_merge(mine, own, other, id))
            continue;
        const auto rank = [](GroupId number, const Group& group) { // the first one stays
            return std::tuple(group.name.empty(), -static_cast<std::int64_t>(group.faces.size()), number);
        };
        if (rank(own, mine) < rank(id, other))
            merge_into(own, id, nullptr);
        else
            merge_into(id, own, nullptr);
    }
}

} // namespace tp
