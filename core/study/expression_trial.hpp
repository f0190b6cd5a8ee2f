// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/study/expression_observer.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// How a face is shown to an observer.
struct ExpressionTrial {
    ExpressionChoices choices = paper_choices;
    std::optional<FingerTouch> touch; ///< nothing: the cues are known exactly
    int touches = 1000;               ///< how often a face is felt anew; ≥ 1
    std::uint64_t seed = 1;           ///< of the finger's errors: another one for every face
};

/// The shares of its answers when one face is felt again and again; of exact cues there is one answer.
ExpressionShares answers_to(const ExpressionCues& cues, const ExpressionObserver& observer,
                            const ExpressionTrial& trial);

/// For each person an observer that learned from all the others. An error where these leave fewer than two
/// of the choices to learn, or nobody.
Result<std::map<std::string, ExpressionObserver>>
observers_by_others(const std::vector<ExpressionExample>& faces, const ExpressionChoices& choices);

} // namespace tp
