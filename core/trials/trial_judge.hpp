// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/contour_index.hpp"
#include "core/trials/study_trial.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace tp {

/// How far a trial has come.
enum class TrialState {
    going,
    done,   ///< at the end, and every knot was passed
    missed, ///< at the end, or once round, but past a knot: to be repeated
    out_of_time ///< the longest time is over: to be repeated where something was to be followed, else an answer is asked for
};

/// Says of a finger's places, one after the other, what came of a trial. Knots may be passed in any order. The end of an open path is
/// its last point; a closed one ends where it begins, once all knots were passed or the finger has gone round. After the end, places
/// change nothing. Where something is to be named only the time is judged.
class TrialJudge {
public:
    explicit TrialJudge(const StudyTrial& trial);

    /// The finger at `time_s`, any clock that does not go back; the first one begins the trial. A place that is not finite is not
    /// counted.
    void feed(double time_s, Vec2 finger_mm);

    TrialState state() const { return state_; }
    /// Mean distance to the path over the samples so far, mm; nothing without a path or a sample.
    std::optional<double> error_mm() const;
    /// Since the first sample, until the newest one or the end.
    double time_s() const { return time_s_; }
    std::size_t knots_passed() const;
    std::size_t knots() const { return knots_.size(); }

private:
    struct Knot {
        Vec2 place;
        bool passed = false;
    };
    void follow(const Nearest& nearest, Vec2 finger);

    StudyTask task_;
    std::optional<double> longest_s_;
    double reach_mm_;
    bool closed_;
    Vec2 end_; ///< of the path
    std::vector<Knot> knots_;
    std::optional<ContourIndex> index_; ///< of the path
    std::vector<Vec2> starts_;          ///< of the path's segments, mm
    std::vector<double> arcs_;          ///< there, mm; and the whole length
    std::optional<double> begun_s_;
    double time_s_ = 0.0;
    double sum_mm_ = 0.0;
    std::size_t samples_ = 0;
    double arc_ = 0.0;   ///< of the newest sample, mm
    double round_ = 0.0; ///< mm gone along the path, backwards negative
    TrialState state_ = TrialState::going;
};

} // namespace tp
