// SPDX-License-Identifier: Apache-2.0
#include "app/figures/bench/identity_bench.hpp"
#include "faces/identity/face_groups.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace tp {
namespace {

constexpr double impostors_accepted = 0.001;

using Portraits = std::vector<const DescribedPortrait*>;

Portraits made_so(const std::vector<DescribedPortrait>& all, const std::string& how) {
    Portraits some;
    for (const DescribedPortrait& portrait : all)
        if (portrait.how == how)
            some.push_back(&portrait);
    return some;
}

/// The first portrait of each person, and the others.
std::pair<Portraits, Portraits> first_and_others(const Portraits& all) {
    std::map<std::string, const DescribedPortrait*> first;
    for (const DescribedPortrait* portrait : all)
        if (const auto [entry, is_new] = first.try_emplace(portrait->person, portrait);
            !is_new && portrait->photo < entry->second->photo)
            entry->second = portrait;
    std::pair<Portraits, Portraits> both;
    for (const DescribedPortrait* portrait : all)
        (first.at(portrait->person) == portrait ? both.first : both.second).push_back(portrait);
    return both;
}

struct Pairs {
    std::vector<double> genuine, impostor; ///< distances
};

Pairs pairs_of(const Portraits& some, const Portraits& others) {
    Pairs pairs;
    for (const DescribedPortrait* one : some)
        for (const DescribedPortrait* other : others)
            if (one->found && other->found)
                (one->person == other->person ? pairs.genuine : pairs.impostor)
                    .push_back(distance(one->numbers, other->numbers));
    return pairs;
}

double mean(const std::vector<double>& values) {
    return values.empty()
               ? 0.0
               : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

ErrorRates rates_of(const Pairs& pairs) {
    return pairs.genuine.empty() || pairs.impostor.empty() ? ErrorRates{}
                                                           : error_rates(pairs.genuine, pairs.impostor);
}

} // namespace

ErrorRates error_rates(std::vector<double> genuine, std::vector<double> impostor) {
    std::ranges::sort(genuine);
    std::ranges::sort(impostor);
    const auto share_within = [](const std::vector<double>& sorted, double most) {
        return static_cast<double>(std::ranges::upper_bound(sorted, most) - sorted.begin()) /
               static_cast<double>(sorted.size());
    };
    ErrorRates rates;
    std::vector<double> places = genuine;
    places.insert(places.end(), impostor.begin(), impostor.end());
    std::ranges::sort(places);
    // Where the accepted impostors begin to be more than the refused genuine pairs, both are about as many.
    const auto crossing = std::ranges::lower_bound(places, true, {}, [&](double most) {
        return share_within(impostor, most) >= 1.0 - share_within(genuine, most);
    });
    rates.equal_error_percent =
        50.0 * (share_within(impostor, *crossing) + 1.0 - share_within(genuine, *crossing));
    const auto accepted = static_cast<std::size_t>(impostors_accepted * static_cast<double>(impostor.size()));
    rates.threshold = impostor[accepted]; // excluded: below it there are as many
    const auto within = std::ranges::lower_bound(genuine, rates.threshold) - genuine.begin();
    rates.true_accepts_percent = 100.0 * static_cast<double>(within) / static_cast<double>(genuine.size());
    return rates;
}

std::vector<IdentityRow> identity_rows(const std::vector<DescribedPortrait>& portraits) {
    std::vector<std::string> ways;
    for (const DescribedPortrait& portrait : portraits)
        if (std::ranges::count(ways, portrait.how) == 0)
            ways.push_back(portrait.how);
    const Portraits known = first_and_others(made_so(portraits, as_it_is)).first;
    std::vector<IdentityRow> rows;
    for (const std::string& how : ways) {
        const Portraits all = made_so(portraits, how);
        const auto [first, others] = first_and_others(all);
        const Pairs pairs = pairs_of(known, others);
        const ErrorRates rates = rates_of(pairs);
        IdentityRow row;
        row.how = how;
        row.portraits = static_cast<int>(all.size());
        for (const DescribedPortrait* portrait : all) {
            row.found += portrait->found;
            row.unfit += portrait->found && portrait->unfit != Unfit::no;
        }
        row.genuine_pairs = static_cast<int>(pairs.genuine.size());
        row.impostor_pairs = static_cast<int>(pairs.impostor.size());
        row.genuine = mean(pairs.genuine);
        row.impostor = mean(pairs.impostor);
        row.equal_error_percent = rates.equal_error_percent;
        row.true_accepts_percent = rates.true_accepts_percent;
        row.threshold = rates.threshold;
        row.both_equal_error_percent = rates_of(pairs_of(first, others)).equal_error_percent;
        rows.push_back(row);
    }
    return rows;
}

IdentityGroups identity_groups(const std::vector<DescribedPortrait>& portraits) {
    FaceGroups groups;
    std::map<FaceId, std::string> who;
    std::map<std::string, int> people;
    for (const DescribedPortrait* portrait : made_so(portraits, as_it_is)) {
        const auto descriptor = descriptor_of(portrait->numbers);
        if (!portrait->found || portrait->unfit != Unfit::no || !descriptor)
            continue;
        ComingFace face;
        face.id = face.photo = static_cast<FaceId>(who.size() + 1);
        face.descriptor = *descriptor;
        who[face.id] = portrait->person;
        ++people[portrait->person];
        groups.add({face});
    }
    IdentityGroups result;
    result.people = static_cast<int>(people.size());
    result.faces = static_cast<int>(who.size());
    std::size_t with_most = 0;
    for (const FaceGroup& group : groups.groups()) {
        std::map<std::string, std::size_t> of;
        for (const FaceId face : group.faces)
            ++of[who.at(face)];
        with_most += std::ranges::max_element(of, {}, [](const auto& one) { return one.second; })->second;
        ++result.groups;
    }
    result.purity = who.empty() ? 0.0 : static_cast<double>(with_most) / static_cast<double>(who.size());
    return result;
}

} // namespace tp
