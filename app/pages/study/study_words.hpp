// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/experiment/experiment.hpp"
#include "core/study_folder/study_summary.hpp"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <cstddef>
#include <optional>

namespace tp {

/// How far one person is, as it is said and shown; nothing of it tells what a trial puts before the finger.
struct StudyProgress {
    int participant = 1;
    std::size_t done = 0;     ///< trials that count
    std::size_t trials = 0;   ///< of the whole experiment
    std::size_t training = 0; ///< the number of the training trial that comes, from 1; 0: training is over
    std::size_t trainings = 0;
    bool again = false; ///< the trial that comes was begun before
};

/// The sentences of a study.
class StudyWords {
    Q_DECLARE_TR_FUNCTIONS(StudyWords)
public:
    /// An experiment of the program's own in the person's language; another one's as its file says.
    static QString title(const Experiment& experiment);
    /// What the person does in every trial, said once.
    static QString task(const Experiment& experiment);
    /// "Participant 3 has done 40 of 150 trials."
    static QString so_far(const StudyProgress& progress);
    /// "Trial 3 of 150", "Training 1 of 3"
    static QString trial(const StudyProgress& progress);
    /// "Trial 3 of 150. Follow the line. Press Space to start." `asks`: an answer is asked for at the trial's end.
    static QString ready(const Experiment& experiment, const StudyProgress& progress, bool asks);
    /// "5.0", as the person's language writes it.
    static QString newtons(double force_n);
    /// That the pull is weaker than the experiment's.
    static QString cut(double limit_n, double pull_n);
    /// The answers that can be given, in the order of the experiment's levels.
    static QStringList answers(const Experiment& experiment);
    /// "Which was it? 1: circle. 2: triangle. …"
    static QString question(const Experiment& experiment, bool out_of_time);
    /// The study's numbers so far: people, trials, mean error, share named rightly, mean time; of what there is.
    static QString summary(const StudySummary& summary);
    /// What a person agrees to before anything is written. `raised_n`: the pull may be so strong, which is more than usual.
    static QString consent(const Experiment& experiment, int participant, std::optional<double> raised_n);
};

} // namespace tp
