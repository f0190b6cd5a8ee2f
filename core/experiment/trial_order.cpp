// SPDX-License-Identifier: Apache-2.0
#include "core/experiment/trial_order.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tp {
namespace {

/// SplitMix64 (Steele, Lea and Flood, OOPSLA 2014): the standard's own generators and shuffle differ between libraries.
class Chance {
public:
    explicit Chance(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next() {
        std::uint64_t z = (state_ += 0x9E3779B97F4A7C15U);
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
        return z ^ (z >> 31);
    }
    /// 0 … below, each as likely; below > 0.
    std::uint64_t below(std::uint64_t below) {
        const std::uint64_t unfair =
            (0 - below) % below; // as many of the smallest numbers would come once too often
        std::uint64_t number = next();
        while (number < unfair)
            number = next();
        return number % below;
    }
    template <typename T>
    void shuffle(std::vector<T>& all) {
        for (std::size_t i = all.size(); i > 1; --i)
            std::swap(all[i - 1], all[below(i)]);
    }

private:
    std::uint64_t state_;
};

} // namespace

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
    Chance person(Chance(seed).next() + static_cast<std::uint64_t>(participant));
    const std::size_t conditions = experiment.conditions();
    std::vector<std::size_t> shuffled(conditions);
    std::iota(shuffled.begin(), shuffled.end(), std::size_t{0});
    std::vector<PlannedTrial> trials;

    std::vector<std::size_t> before = shuffled;
    person.shuffle(before);
    for (std::size_t i = 0; i < static_cast<std::size_t>(experiment.training); ++i)
        trials.push_back({before[i % conditions], 0, true, 0});

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
