// SPDX-License-Identifier: Apache-2.0
#include "app/pages/study/study_run.hpp"

#include "audio/sentences/sentences.hpp"

#include <QDate>

#include <algorithm>
#include <utility>

namespace tp {

namespace {
constexpr double near_start_mm = 10.0; ///< a device's finger that has gone farther is brought again
}

StudyRun::StudyRun(const StudySettings& settings, StudyFinger& finger, StudyKeeping& keeping, StudyEar& ear,
                   StudyTeller& teller)
    : settings_(settings), finger_(finger), keeping_(keeping), ear_(ear), teller_(teller) {
    timer_.setInterval(poll_ms);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &StudyRun::poll);
    connect(&finger_, &StudyFinger::taken, this, &StudyRun::finger_taken);
    connect(&finger_, &StudyFinger::refused, this, &StudyRun::finger_refused);
    connect(&finger_, &StudyFinger::troubled, this, [this](const QString& sentence, bool ends) {
        teller_.sound(Earcon::fault);
        pause_because(sentence);
        if (ends)
            finger_.give_back();
    });
}

void StudyRun::become(State state) {
    state_ = state;
    const bool moves =
        state == State::Coming || state == State::Feeling || (state == State::Ready && finger_.real());
    if (moves && settings_.time == nullptr)
        timer_.start();
    else
        timer_.stop();
    emit changed();
}

// --- from the set-up to the first trial ---

void StudyRun::begin(StudyPlan plan) {
    if (running())
        return;
    plan_ = std::move(plan);
    is_open_ = introduced_ = false;
    records_.clear();
    next_.reset();
    rested_before_ = 0;
    become(State::Consent);
    teller_.tell(consent());
}

void StudyRun::agree() {
    if (state_ == State::Consent)
        open();
}

/// Finger first, so that nothing is written where it cannot be had.
void StudyRun::open() {
    become(State::Opening);
    if (finger_.here())
        return finger_taken();
    finger_.take({{plan_.experiment.surface_width_mm, plan_.experiment.surface_height_mm},
                  plan_.device,
                  strongest_pull_n(plan_.experiment),
                  plan_.force_allowed});
}

void StudyRun::finger_refused(const QString& sentence) {
    if (state_ != State::Opening)
        return;
    if (!is_open_)
        return fail(sentence);
    become(State::Paused);
    teller_.problem(tr("%1 Press Space to try again.").arg(sentence));
}

void StudyRun::finger_taken() {
    if (state_ != State::Opening)
        return;
    if (is_open_)
        return offer();
    if (trying()) {
        StudyKeeping::Known nothing;
        return opened(nothing);
    }
    StudyKeeping::Sitting sitting;
    sitting.folder = plan_.folder;
    sitting.experiment = plan_.experiment;
    sitting.participant = plan_.participant;
    sitting.seed = settings_.new_seed();
    sitting.machine = {QDate::currentDate().toString(Qt::ISODate).toStdString(), settings_.version,
                       finger_.about(), finger_.calibration()};
    keeping_.open(std::move(sitting), [this, number = sitting_](const StudyKeeping::Known& known) {
        if (number == sitting_ && state_ == State::Opening)
            opened(known);
    });
}

void StudyRun::opened(const StudyKeeping::Known& known) {
    if (!known.problem.isEmpty())
        return fail(known.problem);
    is_open_ = true;
    records_ = known.records;
    trials_ = trials_of(plan_.experiment, plan_.participant, known.seed.value_or(settings_.new_seed()));
    offer(known.notice);
}

// --- from trial to trial ---

void StudyRun::offer(const QString& before) {
    next_ = next_trial(plan_.experiment, trials_, records_);
    QString told = before;
    const auto add = [&told](const QString& sentence) { told += (told.isEmpty() ? "" : " ") + sentence; };
    if (!std::exchange(introduced_, true)) {
        if (progress().done > 0)
            add(StudyWords::so_far(progress()));
        add(StudyWords::task(plan_.experiment));
        if (finger_.is_cut())
            add(StudyWords::cut(finger_.limit_n(), strongest_pull_n(plan_.experiment)));
        if (!finger_.real())
            add(tr("Your hand moves the finger with the mouse, on the screen or with the arrow keys, from "
                   "where each "
                   "trial begins. A tone says where the line is: faster is nearer, high is up, and it comes "
                   "from the "
                   "side where the line is."));
    }
    if (!next_) {
        become(State::Done);
        add(tr("That was the last trial. %1 Thank you. Press Space to end.")
                .arg(StudyWords::so_far(progress())));
        return teller_.did(Earcon::list_end, told);
    }
    if (next_->break_due && rested_before_ != next_->number) {
        become(State::Break);
        add(tr("Time for a break. %1 Press Space to go on.").arg(StudyWords::so_far(progress())));
        return teller_.did(Earcon::list_end, told);
    }
    auto trial = trial_of(plan_.experiment, next_->planned, plan_.faces.get());
    std::string problem = trial ? std::string() : trial.error();
    if (trial) {
        laid_ = std::move(*trial);
        problem = finger_.lay([laid = *laid_] { return haptic_scene_of(laid); });
    }
    if (!problem.empty())
        return fail(in_persons_language(problem));
    finger_.bring(laid_->start);
    if (finger_.brought())
        return ready(told);
    become(State::Coming);
    add(tr("The device brings your finger to the start. Let it lead you."));
    teller_.tell(told);
}

void StudyRun::ready(const QString& before) {
    become(State::Ready);
    const QString sentence = StudyWords::ready(plan_.experiment, progress(), laid_->asks);
    teller_.tell(before.isEmpty() ? sentence : before + ' ' + sentence);
}

void StudyRun::start() {
    if (finger_.real() && length(finger_.place() - laid_->start) > near_start_mm) {
        finger_.bring(laid_->start);
        become(State::Coming);
        return teller_.tell(tr("The device brings your finger to the start again."));
    }
    teller_.hush();
    teller_.sound(Earcon::ready);
    if (!trying())
        keeping_.begins(plan_.participant);
    finger_.feel(laid_->start);
    felt_ = std::make_unique<FeltTrial>(*next_, *laid_,
                                        finger_.seen().ticks + 2); // one under way does not know of it
    become(State::Feeling);
}

void StudyRun::poll() {
    if (!finger_.has_servo())
        return;
    finger_.watch(finger_.seen().time); // may take the finger away
    if (state_ == State::Coming && finger_.brought())
        return ready();
    if (state_ != State::Feeling)
        return;
    const ServoSnapshot seen = finger_.seen();
    felt_->feed(seen, finger_.place());
    if (!finger_.real())
        ear_.hear(seen, finger_.place());
    emit felt();
    judge();
}

void StudyRun::judge() {
    switch (felt_->state()) {
    case TrialState::going:
        if (felt_->too_long())
            break_off(State::Paused, tr("This trial has gone on for half an hour. Paused; it is done again. "
                                        "Press Space to go on."));
        return;
    case TrialState::done:
        return keep(felt_->record(plan_.participant, false), State::Coming, {});
    case TrialState::missed:
        return keep(felt_->record(plan_.participant, true), State::Coming,
                    tr("A part of the line was left out; the trial is done again."));
    case TrialState::out_of_time:
        if (plan_.experiment.task == StudyTask::name)
            return felt_enough(true);
        return keep(felt_->record(plan_.participant, true), State::Coming,
                    tr("The time is over; the trial is done again."));
    }
}

void StudyRun::felt_enough(bool out_of_time) {
    if (!laid_->asks)
        return keep(felt_->record(plan_.participant, false), State::Coming, {});
    ask(out_of_time);
}

void StudyRun::ask(bool out_of_time) {
    finger_.stop();
    ear_.silence();
    become(State::Answering);
    teller_.did(Earcon::next, StudyWords::question(plan_.experiment, out_of_time));
}

void StudyRun::answer(int index) {
    const bool names = in_trial() && laid_->asks;
    if (!names || index < 0 || index >= StudyWords::answers(plan_.experiment).size())
        return;
    TrialRecord record = felt_->record(plan_.participant, false);
    for (const StudyFactor& factor : plan_.experiment.factors)
        if (factor.parameter == plan_.experiment.answer)
            record.answer = factor.levels[static_cast<std::size_t>(index)];
    keep(std::move(record), State::Coming, {});
}

// --- what came of it ---

void StudyRun::keep(TrialRecord record, State then, const QString& said) {
    finger_.stop();
    ear_.silence();
    teller_.sound(Earcon::previous);
    after_ = then;
    said_after_ = said;
    keeping_record_ = record;
    std::vector<FingerSample> path = felt_->path();
    felt_.reset();
    become(State::Keeping);
    if (trying())
        return kept({});
    keeping_.keep(std::move(record), std::move(path), [this, number = sitting_](const QString& problem) {
        if (number == sitting_)
            kept(problem);
    });
}

void StudyRun::kept(const QString& problem) {
    if (problem.isEmpty())
        records_.push_back(*keeping_record_);
    keeping_record_.reset();
    if (!problem.isEmpty()) {
        if (after_ == State::Coming)
            after_ = State::Paused;
        become(after_);
        return teller_.problem(
            tr("%1 The trial could not be kept and does not count. Press Space to do it again.")
                .arg(problem));
    }
    if (after_ == State::Coming)
        return offer(said_after_);
    become(after_);
    teller_.tell(said_after_);
}

} // namespace tp
