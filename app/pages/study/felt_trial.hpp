// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/experiment/finger_path.hpp"
#include "core/experiment/next_trial.hpp"
#include "core/geometry/vec.hpp"
#include "core/servo/snapshot.hpp"
#include "core/trials/study_trial.hpp"
#include "core/trials/trial_judge.hpp"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace tp {

/// A trial that a finger is in: its way, and what the judge says of it.
class FeltTrial {
public:
    /// No trial is longer, s: somebody has gone away.
    static constexpr double longest_s = 1800.0;

    /// It begins with the servo's tick `from`.
    FeltTrial(const NextTrial& next, StudyTrial trial, std::uint64_t from)
        : next_(next), trial_(std::move(trial)), judge_(trial_), from_(from) {}

    const NextTrial& next() const { return next_; }
    const StudyTrial& trial() const { return trial_; }
    TrialState state() const { return judge_.state(); }
    bool too_long() const { return !path_.empty() && path_.back().time_s >= longest_s; }

    /// What the servo says now, with the finger at `place`; the same moment again changes nothing.
    void feed(const ServoSnapshot& seen, Vec2 place);
    /// The way of the finger so far.
    const std::vector<FingerSample>& path() const { return path_; }
    /// What came of it. `repeated`: it is to be done again.
    TrialRecord record(int participant, bool repeated) const;

private:
    NextTrial next_;
    StudyTrial trial_;
    TrialJudge judge_;
    std::uint64_t from_;
    std::optional<double> began_s_; ///< servo's clock
    double newest_s_ = 0.0;
    std::vector<FingerSample> path_;
};

} // namespace tp
