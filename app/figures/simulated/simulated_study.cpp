// SPDX-License-Identifier: Apache-2.0
#include "app/figures/simulated/simulated_study.hpp"

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace tp {
namespace {

constexpr std::uint64_t of_the_hand =
    0xA5A5'5A5A'1234'8765U; ///< apart from what a trial itself draws from its seed

/// What several threads know together.
class Shared {
public:
    Shared(std::size_t planned, const SimulationProgress& progress)
        : planned_(planned), progress_(progress) {}

    void did(const TrialRecord& record, double led_s) {
        const std::lock_guard lock(mutex_);
        ++(record.repeated ? study_.repeated : study_.trials);
        study_.simulated_s += record.time_s;
        study_.led_s += led_s;
        if (!record.repeated && progress_)
            progress_(++done_, planned_);
    }
    void remark(int participant, std::string sentence) {
        const std::lock_guard lock(mutex_);
        remarks_.emplace(participant, std::move(sentence));
    }
    void fail(std::string sentence) {
        const std::lock_guard lock(mutex_);
        if (problem_.empty())
            problem_ = std::move(sentence);
        failed_ = true;
    }
    bool failed() const { return failed_; }
    Result<SimulatedStudy> result() {
        if (failed_)
            return Error{problem_};
        for (auto& [participant, sentence] : remarks_)
            study_.remarks.push_back(std::move(sentence));
        return std::move(study_);
    }

private:
    std::mutex mutex_;
    std::size_t planned_, done_ = 0;
    const SimulationProgress& progress_;
    SimulatedStudy study_;
    std::map<int, std::string> remarks_; ///< by participant
    std::string problem_;
    std::atomic<bool> failed_{false};
};

/// Everything that is left for one person.
void simulate_person(StudyWriter& writer, int participant, const SimulatedBench& bench,
                     const StudyFaces* faces, Shared& shared, const std::function<bool()>& stopped) {
    const Person person = person_of(participant, writer.terms().seed);
    while (!shared.failed() && !stopped()) {
        const auto next = writer.next(participant);
        if (!next)
            return;
        if (next->attempts >= most_simulated_attempts) {
            shared.remark(participant, "Participant " + std::to_string(participant) + " has missed trial " +
                                           std::to_string(next->number) +
                                           " so often that they do not go on.");
            return;
        }
        const auto trial = trial_of(writer.experiment(), next->planned, faces);
        if (!trial)
            return shared.fail(trial.error());
        const auto done = simulate_trial(*trial, person, bench, next->planned.seed ^ of_the_hand);
        if (!done)
            return shared.fail(done.error());
        TrialRecord record = begun_record(*next, participant);
        record.error_mm = done->error_mm;
        record.time_s = done->time_s;
        record.answer = done->answer;
        record.repeated = trial->task == StudyTask::follow && done->state != TrialState::done;
        if (const std::string problem = writer.keep(record, done->path); !problem.empty())
            return shared.fail(problem);
        shared.did(record, done->led_s);
    }
}

} // namespace

Result<SimulatedStudy> simulate_study(StudyWriter& writer, int first, int participants,
                                      const SimulatedBench& bench, const StudyFaces* faces, int jobs,
                                      const SimulationProgress& progress,
                                      const std::function<bool()>& stopped) {
    std::size_t left = 0;
    for (int i = 0; i < participants; ++i)
        if (const auto next = writer.next(first + i))
            left += next->left;
    Shared shared(left, progress);
    std::atomic<int> next{0};
    const auto work = [&] {
        while (!shared.failed() && !stopped()) {
            const int mine = next++;
            if (mine >= participants)
                return;
            simulate_person(writer, first + mine, bench, faces, shared, stopped);
        }
    };
    std::vector<std::jthread> threads;
    for (int i = 1; i < std::min(jobs, participants); ++i)
        threads.emplace_back(work);
    work();
    threads.clear();
    return shared.result();
}

} // namespace tp
