// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/experiment/experiment.hpp"
#include "core/experiment/finger_path.hpp"
#include "core/experiment/trial_table.hpp"
#include "core/study_folder/study_folder.hpp"
#include "core/study_folder/study_terms.hpp"
#include "core/study_folder/study_writer.hpp"

#include <QObject>
#include <QString>
#include <QThreadPool>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace tp {

/// A study's folder, read and written on a thread of its own, one thing after the other, so that the page never waits for the
/// disk. Belongs to the page's thread, on which it answers.
class StudyKeeping final : public QObject {
    Q_OBJECT
public:
    /// What a folder says of one participant.
    struct Known {
        std::optional<std::uint64_t> seed; ///< nothing: the study begins
        std::vector<TrialRecord> records;  ///< the participant's, as they were done
        int next_participant = 1;          ///< the first number that nobody has, above all that are there
        QString notice;                    ///< what is not as it should be, in sentences; empty: nothing
        QString problem;                   ///< why the folder cannot be used, in a sentence; empty: it can
    };
    /// What one sitting of a participant is.
    struct Sitting {
        std::filesystem::path folder;
        Experiment experiment;
        int participant = 1;
        std::uint64_t seed = 1; ///< of a study that begins
        StudyMachine machine;
    };
    using Then = std::function<void(const Known& known)>;

    StudyKeeping() { pool_.setMaxThreadCount(1); }
    /// Waits until everything that was asked for is on the disk.
    ~StudyKeeping() override { pool_.waitForDone(); }

    /// What is there; writes nothing.
    void look(const std::filesystem::path& folder, const Experiment& experiment, int participant, Then then);
    /// Begins or continues the study: from now on nobody else may write into it.
    void open(Sitting sitting, Then then);
    /// The participant begins the next trial.
    void begins(int participant);
    /// The path, then the trial's line; both are on the disk when `then` is called with no words. Else they say why not, and the
    /// trial is not in the folder.
    void keep(TrialRecord record, std::vector<FingerSample> path,
              std::function<void(const QString& problem)> then);
    /// The folder is let go.
    void close();

private:
    /// Runs on the pool's thread; what it returns is called on the page's.
    void work(std::function<std::function<void()>()> step);
    static Known known_of(const Result<StudyFolder>& study, const std::filesystem::path& folder,
                          const Experiment& experiment, int participant);

    std::unique_ptr<StudyWriter> writer_; ///< of the pool's thread alone
    QThreadPool pool_;                    ///< last: it ends before what its work is for
};

} // namespace tp
