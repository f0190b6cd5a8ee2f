// SPDX-License-Identifier: Apache-2.0
#include "core/experiment/next_trial.hpp"

#include "core/experiment/split_mix.hpp"

#include <cstdint>

namespace tp {
namespace {

/// How far a person has come in a plan.
class Progress {
public:
    Progress(const Experiment& experiment, std::span<const PlannedTrial> plan)
        : plan_(plan), between_(static_cast<std::size_t>(experiment.trials_between_breaks)) {}

    void take(const TrialRecord& record) {
        ++records_;
        if (record.repeated) {
            take_again();
            return;
        }
        attempts_ = 0;
        ++done_;
        counted_ += record.training ? 0 : 1;
    }
    std::optional<NextTrial> next() const {
        if (done_ >= plan_.size())
            return std::nullopt;
        NextTrial next;
        next.planned = plan_[done_];
        if (attempts_ > 0)
            next.planned.seed = seed_again_;
        next.number = records_ + 1;
        next.attempts = attempts_;
        next.left = plan_.size() - done_;
        next.break_due = between_ > 0 && counted_ > 0 && counted_ % between_ == 0 && attempts_ == 0;
        return next;
    }

private:
    /// Another seed for each attempt: what is random in a trial, such as where a shape lies, is not known from the one before.
    void take_again() {
        if (attempts_ == 0 && done_ < plan_.size())
            seeds_ = SplitMix(plan_[done_].seed);
        ++attempts_;
        seed_again_ = seeds_.next();
    }

    std::span<const PlannedTrial> plan_;
    std::size_t between_;
    std::size_t done_ = 0, counted_ = 0;
    int records_ = 0, attempts_ = 0;
    SplitMix seeds_{0}; ///< of the attempts at the trial that is done again
    std::uint64_t seed_again_ = 0;
};

} // namespace

std::optional<NextTrial> next_trial(const Experiment& experiment, std::span<const PlannedTrial> plan,
                                    std::span<const TrialRecord> records) {
    Progress progress(experiment, plan);
    for (const TrialRecord& record : records)
        progress.take(record);
    return progress.next();
}

TrialRecord begun_record(const NextTrial& next, int participant) {
    TrialRecord record;
    record.participant = participant;
    record.trial = next.number;
    record.repetition = next.planned.repetition + 1;
    record.training = next.planned.training;
    record.condition = next.planned.condition;
    record.seed = next.planned.seed;
    return record;
}

bool is_of(const NextTrial& next, const TrialRecord& record) {
    const TrialRecord begun = begun_record(next, record.participant);
    return record.trial == begun.trial && record.repetition == begun.repetition &&
           record.training == begun.training && record.condition == begun.condition &&
           record.seed == begun.seed;
}

std::optional<int> first_unplanned(const Experiment& experiment, std::span<const PlannedTrial> plan,
                                   std::span<const TrialRecord> records) {
    Progress progress(experiment, plan);
    for (const TrialRecord& record : records) {
        const auto next = progress.next();
        if (!next || !is_of(*next, record))
            return record.trial;
        progress.take(record);
    }
    return std::nullopt;
}

} // namespace tp
