// SPDX-License-Identifier: Apache-2.0
#include "core/experiment/trial_order.hpp"

#include "core/experiment/split_mix.hpp"

#include <algorithm>
#include <numeric>

namespace tp {

std::vector<std::size_t> latin_row(std::size_t conditions, std::size_t row) {
    std::vector<std::size_t> order(conditions);
    for (std::size_t i = 0; i < conditions; ++i) { // 0, 1, n-1, 2, n-2 …, each row one on
        const std::size_t step = i % 2 == 1 ? (i + 1) / 2 : (conditions - i / 2) % conditions;
        order[i] = (step + row) % conditions;
    }
    if (conditions % 2 == 1 && row / conditions % 2 == 1)
        std::ranges::reverse(order);
    return order;
}

std::vector<PlannedTrial> trials_of(const Experiment& experiment, int participant, std::uint64_t seed) {
    SplitMix person(SplitMix(seed).next() + static_cast<std::uint64_t>(participant));
    const std::size_t conditions = experiment.conditions();
    std::vector<std::size_t> shuffled(conditions);
    std::iota(shuffled.begin(), shuffled.end(), std::size_t{0});
    std::vector<PlannedTrial> trials;

    std::vector<std::size_t> before(experiment.in_training().conditions());
    std::iota(before.begin(), before.end(), std::size_t{0});
    person.shuffle(before);
    for (std::size_t i = 0; i < static_cast<std::size_t>(experiment.training); ++i)
        trials.push_back({before[i % before.size()], 0, true, 0});

    std::vector<PlannedTrial> counted;
    for (int repetition = 0; repetition < experiment.repetitions; ++repetition) {
        const auto row = static_cast<std::size_t>(participant - 1) + static_cast<std::size_t>(repetition);
        for (const std::size_t condition :
             experiment.order == StudyOrder::latin_square ? latin_row(conditions, row) : shuffled)
            counted.push_back({condition, repetition, false, 0});
    }
    if (experiment.order == StudyOrder::random)
        person.shuffle(counted);
    trials.insert(trials.end(), counted.begin(), counted.end());
    for (PlannedTrial& trial : trials)
        trial.seed = person.next();
    return trials;
}

} // namespace tp
