// SPDX-License-Identifier: Apache-2.0
#include "app/album/grouping/group_worker.hpp"

#include "app/album/open/polite_thread.hpp"
#include "app/photo/people/region_place.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <span>
#include <utility>

namespace tp {

namespace {

constexpr std::size_t most_offered = 50; ///< people, the largest, to whom a name is looked for

KnownFace known_face(const StoredFace& stored) {
    KnownFace face{stored.id, stored.photo, {}, stored.moment_ms};
    std::ranges::transform(stored.numbers, face.descriptor.begin(),
                           [](char c) { return static_cast<std::int8_t>(c); });
    return face;
}

bool makes_sense(const StoredFace& stored) { return stored.numbers.size() == descriptor_length; }

/// Who a face is by the sidecars: of regions that may be it, the one that shares most with it.
std::string said_of(const FacesToGroup::Face& face, const FacesToGroup& photo) {
    std::string said;
    double most = 0.0;
    for (const FacesToGroup::Copy& copy : photo.copies)
        for (const FaceRegion& region : copy.regions) {
            const Rect part = shown_part(region, {copy.orientation, photo.turned_degrees});
            const double shared = same_face(part, face.part) ? overlap(part, face.part) : 0.0;
            if (!region.name.empty() && shared > most) {
                most = shared;
                said = region.name;
            }
        }
    return said;
}

GroupsState state_of(const StoredGroups& stored) {
    GroupsState state;
    std::map<GroupId, FaceGroup> groups;
    for (const StoredFace& face : stored.faces) {
        state.faces.push_back(known_face(face));
        FaceGroup& group = groups[face.group];
        group.id = face.group;
        group.faces.push_back(face.id);
    }
    for (auto& [id, group] : groups) {
        if (const auto name = stored.names.find(id); name != stored.names.end())
            group.name = name->second;
        state.groups.push_back(std::move(group));
    }
    state.not_there.insert(stored.apart.begin(), stored.apart.end());
    state.last_group = stored.last;
    return state;
}

/// Adds to `kept` what leads from one state to the other.
void add_difference(const GroupsState& before, const GroupsState& after, GroupsKept& kept) {
    std::unordered_map<FaceId, GroupId> was_in;
    std::map<GroupId, std::string> names;
    for (const FaceGroup& group : before.groups) {
        names[group.id] = group.name;
        for (const FaceId face : group.faces)
            was_in[face] = group.id;
    }
    for (const FaceGroup& group : after.groups) {
        const auto name = names.find(group.id);
        if (name == names.end() || name->second != group.name)
            kept.names[group.id] = group.name;
        if (name != names.end())
            names.erase(name);
        for (const FaceId face : group.faces)
            if (const auto was = was_in.find(face); was == was_in.end() || was->second != group.id)
                kept.groups_of.emplace_back(face, group.id);
    }
    for (const auto& [gone, _] : names)
        kept.names[gone] = std::nullopt;
    std::ranges::set_difference(after.not_there, before.not_there, std::back_inserter(kept.apart));
    std::ranges::set_difference(before.not_there, after.not_there, std::back_inserter(kept.no_more_apart));
    kept.last = after.last_group;
}

} // namespace

bool GroupWorker::ready() {
    if (index_)
        return true;
    make_thread_polite();
    Result<AlbumIndex> index = shared_.another();
    if (!index)
        return false; // whoever scans tells
    index_ = std::make_unique<AlbumIndex>(std::move(*index));
    load();
    return true;
}

/// What the index has; where that contradicts itself all faces are grouped anew.
void GroupWorker::load() {
    const Result<StoredGroups> stored = KnownFaces(*index_).all();
    if (stored && std::ranges::all_of(stored->faces, makes_sense)) {
        stored_ = state_of(*stored);
        if (std::optional<FaceGroups> groups = FaceGroups::from(stored_)) {
            groups_ = std::move(*groups);
            for (const StoredFace& face : stored->faces)
                said_[face.id] = face.said;
            return;
        }
    }
    stored_ = {};
    KnownFaces(*index_).begin_anew();
}

GroupWorker::Report GroupWorker::group(std::size_t photos) {
    if (!ready())
        return {};
    KnownFaces known(*index_);
    GroupsKept kept;
    if (const auto gone = known.gone())
        kept.taken_away = *gone;
    for (const FaceId face : kept.taken_away) {
        groups_.remove(face);
        said_.erase(face);
    }
    Report report;
    std::string last; // hash
    for (std::size_t i = 0; i < photos; ++i) {
        const auto next = known.next(last);
        report.more = next && *next;
        if (!report.more)
            break;
        follow(**next, kept);
        last = (*next)->hash;
    }
    report.changed = !kept.done.empty() || !kept.taken_away.empty();
    if (report.changed && !keep(std::move(kept)).empty())
        report.more = false; // a full disk, say: whoever scans tells
    return report;
}

/// A photograph whose faces came, or of which somebody has said something.
void GroupWorker::follow(const FacesToGroup& next, GroupsKept& kept) {
    std::vector<ComingFace> coming;
    for (const FacesToGroup::Face& face : next.faces) {
        if (!makes_sense(face.stored))
            continue;
        const std::string said = said_of(face, next);
        if (said != face.stored.said)
            kept.said.emplace_back(face.stored.id, said);
        if (groups_.group_of(face.stored.id)) {
            if (said != said_[face.stored.id])
                follow_word(face.stored, said);
        } else {
            coming.push_back({known_face(face.stored), said});
            said_[face.stored.id] = said;
        }
    }
    groups_.add(coming);
    kept.done.push_back(next);
}

bool GroupWorker::says(GroupId group, const std::string& name) const {
    const auto faces = groups_.group(group);
    return faces && std::ranges::any_of(faces->faces, [&](FaceId face) {
               const auto said = said_.find(face);
               return said != said_.end() && said->second == name;
           });
}

/// Somebody has said something else of a face than before: its group is called so where nobody says otherwise of it,
/// else it goes to where it belongs.
void GroupWorker::follow_word(const StoredFace& face, const std::string& said) {
    const GroupId group = *groups_.group_of(face.id);
    const std::string name = groups_.group(group)->name;
    said_[face.id] = said;
    if (said == name || (said.empty() && says(group, name)))
        return;
    if (name.empty() || !says(group, name)) {
        groups_.name(group, said);
        return;
    }
    groups_.remove(face.id);
    groups_.add({{known_face(face), said}});
}

std::string GroupWorker::keep(GroupsKept kept) {
    GroupsState now = groups_.state();
    add_difference(stored_, now, kept);
    std::string problem = KnownFaces(*index_).keep(kept);
    if (problem.empty())
        stored_ = std::move(now);
    return problem;
}

People GroupWorker::people() {
    if (!ready())
        return {};
    KnownFaces known(*index_);
    const auto placed = known.placed();
    const auto not_guessed = known.not_guessed();
    const auto to_look = known.to_look();
    People people = people_of(groups_.groups(), placed ? *placed : std::vector<PlacedFace>(),
                              [this](FaceId face) { return !said_[face].empty(); });
    people.not_guessed = not_guessed ? *not_guessed : 0;
    people.to_look = to_look ? *to_look : 0;
    for (Person& person : std::span(people.persons).first(std::min(most_offered, people.persons.size())))
        if (const auto offers = groups_.offers(person.faces.front().id, 1);
            person.name.empty() && !offers.empty())
            person.perhaps = offers.front().name;
    return people;
}

std::vector<FaceOffer> GroupWorker::offers(const std::filesystem::path& photo) {
    std::vector<FaceOffer> offers;
    if (!ready())
        return offers;
    const auto placed = KnownFaces(*index_).placed_on(photo);
    if (!placed)
        return offers;
    for (const PlacedFace& face : *placed) {
        const auto group = groups_.group_of(face.id);
        if (!group || !said_[face.id].empty())
            continue;
        std::string name = groups_.group(*group)->name;
        if (name.empty())
            if (const auto others = groups_.offers(face.id, 1); !others.empty())
                name = others.front().name;
        if (!name.empty())
            offers.push_back({face.part, face.turned_degrees, name});
    }
    return offers;
}

std::vector<NamedFaces> GroupWorker::named() { return ready() ? groups_.named() : std::vector<NamedFaces>(); }

Result<GroupsChange> GroupWorker::say(const Word& word) {
    constexpr const char* gone = "These faces are not grouped so any more.";
    if (!ready())
        return Error{gone};
    const std::optional<GroupsChange> change = word(groups_);
    if (!change)
        return Error{gone};
    if (std::string problem = keep({}); !problem.empty()) {
        groups_.undo(*change);
        return Error{problem};
    }
    return *change;
}

std::string GroupWorker::undo(const GroupsChange& change) {
    if (!ready() || !groups_.undo(change))
        return "Since then the groups of faces have changed, so this cannot be undone.";
    return keep({});
}

bool GroupWorker::forget() {
    if (!ready())
        return false;
    const auto had = KnownFaces(*index_).forget();
    groups_ = {};
    stored_ = {};
    said_.clear();
    return had && *had;
}

} // namespace tp
