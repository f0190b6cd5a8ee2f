// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aiming/advice.hpp"

#include <optional>

namespace tp {

inline constexpr double aim_breath_s =
    0.15;                              ///< between the end of one sentence and the beginning of the next
inline constexpr double again_s = 2.0; ///< the same is said again after such a pause, where it did not help
inline constexpr double again_when_well_s = 6.0;  ///< and where there is nothing to do but wait
inline constexpr double wrong_way_s = 0.6;        ///< and where it became worse since the sentence
inline constexpr double longest_sentence_s = 6.0; ///< a sentence whose end nobody told has ended by then

/// When an instruction is said: when it changes, or again after a pause; never into a sentence that is not over. What becomes
/// better needs no words meanwhile.
class AdvicePace {
public:
    /// `badness` ≥ 0: how bad it is with what the instruction is about. True where it is to be said now; it then counts as
    /// being said until `sentence_ended`. `now_s` of the frames' clock; where that is set back, pauses begin anew.
    bool say(const AimInstruction& now, double badness, double now_s);
    void sentence_ended(double now_s);
    /// A sentence is under way.
    bool speaking() const { return speaking_since_.has_value(); }
    /// Nothing was said yet; a sentence under way goes on.
    void forget();

private:
    bool due(const AimInstruction& now, double now_s) const;

    std::optional<double> speaking_since_; ///< s
    std::optional<double> ended_;          ///< s
    std::optional<Advice> said_;
    std::optional<Advice> newest_; ///< said or not
    double since_ = 0.0;           ///< s: it has been that since
    double best_ = 0.0;            ///< the least badness since it was said
    double better_at_ = 0.0;       ///< s
    double badness_ = 0.0;
    double last_s_ = 0.0;
};

} // namespace tp
