// SPDX-License-Identifier: Apache-2.0
#include "faces/identity/face_groups.hpp"
#include "faces/identity/named_faces.hpp"
#include "faces/identity/same_person.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tp {
namespace {

constexpr std::size_t faces_in_time = 8; ///< of a person, the nearest in time, that are asked

/// From each name's squared distance, steps², to offers, the likeliest first.
std::vector<NameOffer> offers_of(const std::map<std::string, double>& nearest) {
    std::vector<NameOffer> offers;
    offers.reserve(nearest.size());
    for (const auto& [name, squared] : nearest)
        offers.push_back({name, descriptor_step * std::sqrt(squared), false});
    std::ranges::stable_sort(offers, {}, &NameOffer::distance);
    if (!offers.empty())
        offers[0].sure = offers[0].distance <= same_person &&
                         (offers.size() == 1 || offers[1].distance - offers[0].distance >= clear_lead);
    return offers;
}

void keep_nearer(std::map<std::string, double>& nearest, const std::string& name, double squared) {
    const auto [entry, is_first] = nearest.try_emplace(name, squared);
    entry->second = std::min(entry->second, squared);
}

} // namespace

std::string sure_name(const std::vector<NamedFaces>& people, const FaceDescriptor& face) {
    std::map<std::string, double> nearest;
    for (const NamedFaces& person : people) {
        double sum = 0.0;
        for (const FaceDescriptor& known : person.newest)
            sum += squared_distance(face, known);
        if (!person.newest.empty())
            keep_nearer(nearest, person.name, sum / static_cast<double>(person.newest.size()));
    }
    const std::vector<NameOffer> offers = offers_of(nearest);
    return !offers.empty() && offers[0].sure ? offers[0].name : std::string();
}

std::vector<NamedFaces> FaceGroups::named() const {
    std::vector<NamedFaces> people;
    for (const auto& [_, group] : groups_) {
        if (group.name.empty())
            continue;
        std::vector<std::pair<std::int64_t, FaceId>> by_time;
        for (const FaceId id : group.faces)
            if (const auto moment = faces_.at(id).known.moment_ms)
                by_time.emplace_back(*moment, id);
        std::ranges::sort(by_time, std::greater{});
        by_time.resize(std::min(faces_in_time, by_time.size()));
        NamedFaces person{group.name, {}};
        for (const auto& moment_and_face : by_time)
            person.newest.push_back(faces_.at(moment_and_face.second).known.descriptor);
        if (by_time.empty())
            for (const FaceId id : group.faces)
                person.newest.push_back(faces_.at(id).known.descriptor);
        people.push_back(std::move(person));
    }
    return people;
}

/// Mean squared distance, steps², from the face to those of the group that are nearest in time; to all of them where
/// moments are not known. Nothing where it is alone there.
std::optional<double> FaceGroups::squared_in_time(const Face& face, const Group& group) const {
    std::vector<std::pair<double, FaceId>> by_time;
    double all = 0.0;
    std::size_t count = 0;
    for (const FaceId id : group.faces) {
        if (id == face.known.id)
            continue;
        const KnownFace& other = faces_.at(id).known;
        all += squared_distance(face.known.descriptor, other.descriptor);
        ++count;
        if (face.known.moment_ms && other.moment_ms)
            by_time.emplace_back(
                std::abs(static_cast<double>(*face.known.moment_ms) - static_cast<double>(*other.moment_ms)),
                id);
    }
    if (count == 0)
        return std::nullopt;
    if (by_time.empty())
        return all / static_cast<double>(count);
    const std::size_t nearest = std::min(faces_in_time, by_time.size());
    std::partial_sort(by_time.begin(), by_time.begin() + static_cast<std::ptrdiff_t>(nearest), by_time.end());
    by_time.resize(nearest);
    double sum = 0.0;
    for (const auto& [_, id] : by_time)
        sum += squared_distance(face.known.descriptor, faces_.at(id).known.descriptor);
    return sum / static_cast<double>(nearest);
}

std::vector<NameOffer> FaceGroups::offers(FaceId id, std::size_t most) const {
    const auto found = faces_.find(id);
    if (found == faces_.end())
        return {};
    const Face& face = found->second;
    std::map<std::string, double> nearest; // of each name, steps²
    for (const auto& [group_id, group] : groups_) {
        if (group.name.empty() || is_ruled_out(face, group_id, group))
            continue;
        if (const auto squared = squared_in_time(face, group))
            keep_nearer(nearest, group.name, *squared);
    }
    for (const FaceId other : of_photo_.at(face.known.photo))
        if (const Face& beside = faces_.at(other); other != id && beside.group != face.group)
            nearest.erase(groups_.at(beside.group).name);
    std::vector<NameOffer> offers = offers_of(nearest);
    std::erase_if(offers, [](const NameOffer& offer) { return offer.distance > worth_asking; });
    offers.resize(std::min(offers.size(), most));
    return offers;
}

} // namespace tp
