// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/experiment/experiment.hpp"
#include "core/experiment/finger_path.hpp"
#include "core/experiment/next_trial.hpp"
#include "core/experiment/trial_table.hpp"
#include "core/files/folder_lock.hpp"
#include "core/study_folder/study_folder.hpp"
#include "core/study_folder/study_terms.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tp {

/// A study that is under way: keeps each trial on the disk as it ends. A program that is killed, or a power cut, at any moment loses
/// at most the trial that was not kept yet; that one is then the next again. As long as it lives no other of our programs changes the
/// folder. Several threads may use it, each for other participants.
class StudyWriter {
public:
    /// Begins a study in a folder that is empty or not there yet; goes on with the one that is there. An error is one sentence:
    /// another program has it, it is of another experiment, has other terms, holds other files, cannot be written to, or its trials
    /// are not those that were planned.
    static Result<std::unique_ptr<StudyWriter>> open(const std::filesystem::path& folder,
                                                     const Experiment& experiment, const StudyTerms& terms,
                                                     const StudyMachine& machine);
    /// Goes on with the study that is there, whichever it is.
    static Result<std::unique_ptr<StudyWriter>> go_on(const std::filesystem::path& folder,
                                                      const StudyMachine& machine);

    const Experiment& experiment() const { return experiment_; }
    const StudyTerms& terms() const { return terms_; }
    const std::filesystem::path& folder() const { return folder_; }
    /// Sentences: what a program that was killed had left half-written, and was cut away.
    const std::vector<std::string>& remarks() const { return remarks_; }

    /// Those with a table, in order.
    std::vector<int> participants() const;
    std::vector<TrialRecord> records_of(int participant) const;
    /// What this person, who may be a new one, does next; nothing: all is done.
    std::optional<NextTrial> next(int participant) const;

    /// The person begins the trial that is `next`. Where a program is killed in it, whoever goes on is told (remarks). A note that
    /// cannot be written is none: what keeps the trial will say why.
    void begins(int participant) const;
    /// From the next trial on things are done with this machine.
    void use(const StudyMachine& machine);

    /// Keeps what came of the trial that was `next`, and the finger's path in it (is_path). When this returns empty both are on the
    /// disk; else it is a sentence that says why not, nothing of the trial counts, and the same may be tried again. Takes as long as
    /// the disk does.
    std::string keep(const TrialRecord& record, std::span<const FingerSample> path);

private:
    struct Table {
        std::filesystem::path file;
        std::vector<TrialRecord> records;
        std::uintmax_t size = 0; ///< of what is kept; 0: it has no columns yet
        bool unsure = false;     ///< something half-written may stand behind that
    };

    StudyWriter(std::filesystem::path folder, Experiment experiment, StudyTerms terms, StudyMachine machine)
        : folder_(std::move(folder)), experiment_(std::move(experiment)), terms_(terms),
          machine_(std::move(machine)) {}
    static Result<std::unique_ptr<StudyWriter>> begin(const std::filesystem::path& folder,
                                                      const Experiment& experiment, const StudyTerms& terms,
                                                      const StudyMachine& machine);
    std::string take_table(const ParticipantTable& table);
    std::string put_sitting(int participant, int trial);
    std::string put_line(Table& table, const TrialRecord& record) const;

    std::filesystem::path folder_;
    Experiment experiment_;
    StudyTerms terms_;
    std::vector<std::string> remarks_;
    std::unique_ptr<FolderLock> lock_;
    mutable std::mutex mutex_; ///< of all below
    StudyMachine machine_;
    std::vector<StudySitting> sittings_; ///< by participant and trial
    std::map<int, Table> tables_;
};

} // namespace tp
