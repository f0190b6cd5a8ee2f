// SPDX-License-Identifier: Apache-2.0
// What interrupts a sitting, and what is shown of it.
#include "app/pages/study/study_run.hpp"

#include <algorithm>
#include <utility>

namespace tp {

void StudyRun::goOn() {
    switch (state_) {
    case State::Ready:
        return start();
    case State::Feeling:
        if (plan_.experiment.task == StudyTask::name)
            return felt_enough(false);
        return keep(felt_->record(plan_.participant, true), State::Coming,
                    tr("The end of the line was not reached; the trial is done again."));
    case State::Answering:
        return teller_.tell(StudyWords::question(plan_.experiment, false));
    case State::Break:
        rested_before_ = next_->number;
        return open();
    case State::Paused:
    case State::Stopping:
        return open();
    case State::Done:
        return end(tr("The study has ended for participant %1.").arg(plan_.participant));
    case State::SetUp:
    case State::Consent:
    case State::Opening:
    case State::Coming:
    case State::Keeping:
        return;
    }
}

/// What was felt so far is kept as a trial that does not count.
void StudyRun::break_off(State then, const QString& said) {
    finger_.stop();
    ear_.silence();
    if (in_trial())
        return keep(felt_->record(plan_.participant, true), then, said);
    if (state_ == State::Keeping) {
        after_ = then;
        said_after_ = said;
        return;
    }
    become(then);
    teller_.tell(said);
}

void StudyRun::pause_because(const QString& why) {
    const bool waits = state_ == State::Coming || state_ == State::Ready;
    if (!waits && !in_trial() && (state_ != State::Keeping || after_ != State::Coming))
        return;
    const QString paused = in_trial() ? tr("Paused. The trial is done again. Press Space to go on.")
                                      : tr("Paused. Press Space to go on.");
    break_off(State::Paused, why.isEmpty() ? paused : why + ' ' + paused);
}

bool StudyRun::stop() {
    switch (state_) {
    case State::SetUp:
        return false;
    case State::Consent:
        end(tr("Nothing has been kept."));
        return true;
    case State::Opening:
    case State::Stopping:
    case State::Done:
        end(trying() || !is_open_
                ? tr("Stopped.")
                : tr("Stopped. Everything is kept. %1").arg(StudyWords::so_far(progress())));
        return true;
    default:
        break_off(State::Stopping,
                  tr("Stop the study? The force is off. Press Escape again to stop, or Space to go on."));
        return true;
    }
}

/// Back to the set-up.
void StudyRun::end(const QString& said) {
    ++sitting_;
    finger_.give_back();
    ear_.silence();
    felt_.reset();
    laid_.reset();
    keeping_.close();
    become(State::SetUp);
    emit ended();
    teller_.tell(said);
}

void StudyRun::fail(const QString& problem) {
    end(problem);
    teller_.sound(Earcon::error);
}

void StudyRun::leave() {
    if (state_ == State::Opening)
        become(is_open_ ? State::Paused : State::Consent);
    pause_because({});
    finger_.give_back();
}

void StudyRun::tell_where() {
    if (state_ == State::Consent)
        teller_.tell(consent());
    else if (running())
        teller_.tell(tr("%1 %2.").arg(progress_words(), status()).trimmed());
}

void StudyRun::move_by(Vec2 way) {
    if (state_ == State::Feeling)
        finger_.move_by(way);
}

// --- what is shown ---

const FlatScene* StudyRun::shown() const {
    const bool laid = state_ == State::Coming || state_ == State::Ready || state_ == State::Feeling;
    return trying() && laid && finger_.has_servo() ? &finger_.felt() : nullptr;
}

Vec2 StudyRun::shown_finger() const {
    return state_ == State::Feeling || finger_.real() ? finger_.place() : laid_->start;
}

StudyProgress StudyRun::progress() const {
    StudyProgress progress;
    progress.participant = plan_.participant;
    progress.trials = plan_.experiment.trials();
    progress.trainings = static_cast<std::size_t>(std::max(0, plan_.experiment.training));
    std::size_t trained = 0;
    for (const TrialRecord& record : records_)
        if (!record.repeated)
            ++(record.training ? trained : progress.done);
    if (next_) {
        progress.training = next_->planned.training ? trained + 1 : 0;
        progress.again = next_->attempts > 0;
    }
    return progress;
}

QString StudyRun::trial() const { return next_ ? StudyWords::trial(progress()) : QString(); }

QString StudyRun::progress_words() const {
    return running() && is_open_ ? StudyWords::so_far(progress()) : QString();
}

double StudyRun::fraction() const {
    const StudyProgress now = progress();
    return now.trials == 0 ? 0.0 : static_cast<double>(now.done) / static_cast<double>(now.trials);
}

QString StudyRun::status() const {
    switch (state_) {
    case State::SetUp:
        return {};
    case State::Consent:
        return tr("Waiting for consent");
    case State::Opening:
        return tr("Getting ready");
    case State::Coming:
        return tr("The finger is brought to the start");
    case State::Ready:
        return tr("Press Space to start");
    case State::Feeling:
        return tr("Running");
    case State::Answering:
        return tr("Waiting for an answer");
    case State::Keeping:
        return tr("Saving");
    case State::Break:
        return tr("Break. Press Space to go on");
    case State::Paused:
        return tr("Paused. Press Space to go on");
    case State::Stopping:
        return tr("Stop? Escape stops, Space goes on");
    case State::Done:
        return tr("All trials are done. Press Space to end");
    }
    return {};
}

QString StudyRun::consent() const {
    if (state_ != State::Consent)
        return {};
    const double pull = strongest_pull_n(plan_.experiment);
    const bool raised = plan_.force_allowed && pull > finger_.persons_limit_n();
    return StudyWords::consent(plan_.experiment, plan_.participant,
                               raised ? std::optional(pull) : std::nullopt);
}

QStringList StudyRun::answers() const {
    return state_ == State::Answering ? StudyWords::answers(plan_.experiment) : QStringList();
}

} // namespace tp
