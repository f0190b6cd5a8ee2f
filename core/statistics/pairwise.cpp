// SPDX-License-Identifier: Apache-2.0
#include "core/statistics/pairwise.hpp"

#include "core/statistics/repeated_anova.hpp"
#include "core/statistics/studentized_range.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace tp {
namespace {

using Group = std::set<std::size_t>;

/// Each participant's mean at each level of one factor, as an experiment with that factor alone.
WithinMeans over_others(const WithinMeans& means, std::size_t factor) {
    const std::size_t count = means.factors[factor].levels.size();
    std::size_t stride = 1;
    for (std::size_t i = factor + 1; i < means.factors.size(); ++i)
        stride *= means.factors[i].levels.size();
    WithinMeans alone;
    alone.factors = {means.factors[factor]};
    alone.participants = means.participants;
    alone.values.resize(means.participants.size() * count);
    const std::size_t cells_a_level = means.cells() / count;
    const auto others = static_cast<double>(cells_a_level);
    for (std::size_t i = 0; i < means.participants.size(); ++i)
        for (std::size_t cell = 0; cell < means.cells(); ++cell)
            alone.values[i * count + cell / stride % count] += means.of(i)[cell] / others;
    return alone;
}

LevelMean level_mean(const WithinMeans& alone, std::size_t level) {
    const auto participants = static_cast<double>(alone.participants.size());
    LevelMean result{alone.factors[0].levels[level], 0.0, std::nullopt};
    for (std::size_t i = 0; i < alone.participants.size(); ++i)
        result.mean += alone.of(i)[level] / participants;
    if (alone.participants.size() < 2)
        return result;
    double squares = 0.0;
    for (std::size_t i = 0; i < alone.participants.size(); ++i)
        squares += std::pow(alone.of(i)[level] - result.mean, 2.0);
    result.standard_error = std::sqrt(squares / (participants - 1.0) / participants);
    return result;
}

} // namespace

std::vector<std::string> letter_groups(std::size_t count, const std::vector<LevelPair>& differing) {
    Group all;
    for (std::size_t i = 0; i < count; ++i)
        all.insert(i);
    std::set<Group> groups{all};
    for (const LevelPair& pair : differing) {
        std::set<Group> split;
        for (const Group& group : groups)
            for (const std::size_t without : {pair.one, pair.other}) {
                Group part = group;
                part.erase(without);
                split.insert(std::move(part));
            }
        std::erase_if(split, [&](const Group& group) { // within another one it says nothing new
            return std::ranges::any_of(split, [&](const Group& other) {
                return other != group && std::ranges::includes(other, group);
            });
        });
        groups = std::move(split);
    }
    std::vector<std::string> letters(count);
    char letter = 'a';
    for (const Group& group : groups) { // in the order of their first levels
        for (const std::size_t level : group)
            letters[level] += letter;
        ++letter;
    }
    return letters;
}

Pairwise tukey_hsd(const WithinMeans& means, std::size_t factor, double least_p) {
    const WithinMeans alone = over_others(means, factor);
    const std::size_t count = alone.factors[0].levels.size();
    Pairwise result;
    for (std::size_t level = 0; level < count; ++level)
        result.levels.push_back(level_mean(alone, level));

    const WithinEffect effect = repeated_anova(alone).effects.front();
    if (!effect.f)
        return result;
    const double standard_error =
        std::sqrt(effect.error_sum / effect.error_df / static_cast<double>(alone.participants.size()));
    for (std::size_t one = 0; one < count; ++one)
        for (std::size_t other = one + 1; other < count; ++other) {
            const double difference = result.levels[other].mean - result.levels[one].mean;
            result.pairs.push_back({one, other, difference,
                                    studentized_range_above(std::abs(difference) / standard_error,
                                                            static_cast<int>(count), effect.error_df)});
        }

    std::vector<std::size_t> by_mean(count), place(count);
    std::iota(by_mean.begin(), by_mean.end(), std::size_t{0});
    std::ranges::stable_sort(by_mean, {}, [&](std::size_t level) { return result.levels[level].mean; });
    for (std::size_t i = 0; i < count; ++i)
        place[by_mean[i]] = i;
    std::vector<LevelPair> differing;
    for (LevelPair pair : result.pairs)
        if (pair.p < least_p) {
            pair.one = place[pair.one];
            pair.other = place[pair.other];
            differing.push_back(pair);
        }
    const std::vector<std::string> letters = letter_groups(count, differing);
    for (std::size_t level = 0; level < count; ++level)
        result.levels[level].letters = letters[place[level]];
    return result;
}

} // namespace tp
