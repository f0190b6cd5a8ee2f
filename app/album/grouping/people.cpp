// SPDX-License-Identifier: Apache-2.0
#include "app/album/grouping/people.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace tp {

namespace {

void count(Person& person) {
    std::set<std::filesystem::path> photos;
    for (const PersonFace& face : person.faces) {
        photos.insert(face.photo);
        person.to_confirm += face.said ? 0 : 1;
    }
    person.photos = photos.size();
}

auto rank(const Person& person) {
    return std::tuple(person.to_confirm == 0, -static_cast<std::int64_t>(person.photos),
                      person.groups.front());
}

} // namespace

People people_of(const std::vector<FaceGroup>& groups, const std::vector<PlacedFace>& placed,
                 const std::function<bool(FaceId)>& said) {
    std::unordered_map<FaceId, GroupId> group_of;
    std::map<std::pair<std::string, GroupId>, Person>
        by_name; // a name's groups are one person, others each one
    std::unordered_map<GroupId, Person*> person_of;
    for (const FaceGroup& group : groups) {
        Person& person = by_name[{group.name, group.name.empty() ? group.id : 0}];
        person.name = group.name;
        person.groups.push_back(group.id);
        person_of[group.id] = &person; // a map's values stay where they are
        for (const FaceId face : group.faces)
            group_of[face] = group.id;
    }
    for (const PlacedFace& face : placed)
        if (const auto group = group_of.find(face.id); group != group_of.end())
            person_of.at(group->second)->faces.push_back({face, group->second, said(face.id)});
    People people;
    for (auto& [_, person] : by_name) {
        if (person.faces.empty()) // all its photographs are missing
            continue;
        count(person);
        if (person.name.empty() && person.photos < 2)
            people.alone += person.faces.size();
        else
            people.persons.push_back(std::move(person));
    }
    std::ranges::sort(people.persons, {}, rank);
    return people;
}

} // namespace tp
