// SPDX-License-Identifier: Apache-2.0
#include "core/study_folder/study_summary.hpp"

#include <set>

namespace tp {

namespace {

class Mean {
public:
    void add(double value) {
        sum_ += value;
        ++count_;
    }
    std::optional<double> value() const {
        return count_ == 0 ? std::nullopt : std::optional(sum_ / static_cast<double>(count_));
    }

private:
    double sum_ = 0.0;
    std::size_t count_ = 0;
};

} // namespace

StudySummary summary_of(const StudyFolder& study) {
    StudySummary summary;
    std::set<int> participants;
    Mean error, time, right;
    for (const TrialRecord& record : study.records) {
        participants.insert(record.participant);
        summary.repeated += record.repeated ? 1 : 0;
        if (record.training || record.repeated)
            continue;
        ++summary.trials;
        time.add(record.time_s);
        if (record.error_mm)
            error.add(*record.error_mm);
        if (study.experiment.answer)
            right.add(is_right(study.experiment, record) ? 1.0 : 0.0);
    }
    summary.participants = participants.size();
    summary.error_mm = error.value();
    summary.time_s = time.value();
    summary.right = right.value();
    return summary;
}

} // namespace tp
