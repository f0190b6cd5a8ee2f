// SPDX-License-Identifier: Apache-2.0
#include "core/study/expression_trial.hpp"

#include "core/base/words.hpp"

#include <algorithm>

namespace tp {

ExpressionShares answers_to(const ExpressionCues& cues, const ExpressionObserver& observer,
                            const ExpressionTrial& trial) {
    ExpressionShares answers{};
    const auto answer = [&](const ExpressionCues& known) {
        return static_cast<std::size_t>(answer_of(observer.judge(known, trial.choices, trial.touch)));
    };
    if (!trial.touch) {
        answers[answer(cues)] = 1.0;
        return answers;
    }
    std::mt19937_64 random(trial.seed);
    for (int i = 0; i < trial.touches; ++i)
        answers[answer(felt(cues, *trial.touch, random))] += 1.0 / trial.touches;
    return answers;
}

Result<std::map<std::string, ExpressionObserver>>
observers_by_others(const std::vector<ExpressionExample>& faces, const ExpressionChoices& choices) {
    std::map<std::string, ExpressionObserver> observers;
    for (const ExpressionExample& face : faces) {
        if (observers.contains(face.person))
            continue;
        std::vector<ExpressionExample> others;
        for (const ExpressionExample& other : faces)
            if (other.person != face.person)
                others.push_back(other);
        const std::string without = "Without " + quoted(face.person) + " too little is left to learn from. ";
        auto observer = ExpressionObserver::learned_from(others);
        if (!observer)
            return Error{without + observer.error()};
        const ExpressionChoices open = observer->known_among(choices);
        if (std::count(open.begin(), open.end(), true) < 2)
            return Error{without + "Faces of at least two of the expressions that may be answered are "
                                   "needed."};
        observers.emplace(face.person, std::move(observer).value());
    }
    return observers;
}

} // namespace tp
