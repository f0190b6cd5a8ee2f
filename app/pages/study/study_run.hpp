// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/study/felt_trial.hpp"
#include "app/pages/study/study_ear.hpp"
#include "app/pages/study/study_finger.hpp"
#include "app/pages/study/study_keeping.hpp"
#include "app/pages/study/study_plan.hpp"
#include "app/pages/study/study_settings.hpp"
#include "app/pages/study/study_teller.hpp"
#include "app/pages/study/study_words.hpp"
#include "core/experiment/next_trial.hpp"
#include "core/experiment/trial_order.hpp"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace tp {

/// One participant's sitting: consent, then trial after trial. A trial's record and path are on the disk before the next one is
/// offered. Whatever breaks a trial off takes the force away first; the trial is then done again.
///
/// | state     | goes on by                                   | breaks off by                                    |
/// |-----------|----------------------------------------------|--------------------------------------------------|
/// | SetUp     | begin → Consent                              |                                                  |
/// | Consent   | agree → Opening                              | stop → SetUp                                     |
/// | Opening   | finger and folder are there → Coming         | refused → SetUp or Paused; stop → SetUp          |
/// | Coming    | the finger is at the start → Ready           | pause → Paused; stop → Stopping                  |
/// | Ready     | Space → Feeling                              | the same                                         |
/// | Feeling   | end, time or Space → Answering or Keeping    | the same, after Keeping                          |
/// | Answering | answer → Keeping                             | the same, after Keeping                          |
/// | Keeping   | written → Coming, Break or Done              | not written → Paused                             |
/// | Break     | Space → Coming                               | stop → Stopping                                  |
/// | Paused    | Space → Opening                              | stop → Stopping                                  |
/// | Stopping  | Space → Opening                              | stop → SetUp                                     |
/// | Done      | Space, stop → SetUp                          |                                                  |
class StudyRun final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")

    Q_PROPERTY(State state READ state NOTIFY changed)
    Q_PROPERTY(bool running READ running NOTIFY changed)
    /// "Trial 3 of 150"; nothing of what it puts before the finger.
    Q_PROPERTY(QString trial READ trial NOTIFY changed)
    Q_PROPERTY(QString progress READ progress_words NOTIFY changed)
    Q_PROPERTY(double fraction READ fraction NOTIFY changed)
    /// What goes on and what can be done.
    Q_PROPERTY(QString status READ status NOTIFY changed)
    Q_PROPERTY(QString consent READ consent NOTIFY changed)
    /// While an answer is asked for.
    Q_PROPERTY(QStringList answers READ answers NOTIFY changed)
    /// The researcher tries it out, sees the scene, and nothing is kept.
    Q_PROPERTY(bool trying READ trying NOTIFY changed)
    /// mm
    Q_PROPERTY(double surfaceWidth READ surface_width NOTIFY changed)
    Q_PROPERTY(double surfaceHeight READ surface_height NOTIFY changed)
    /// The hand moves a drawn finger now.
    Q_PROPERTY(bool handMoves READ hand_moves NOTIFY changed)
public:
    enum class State {
        SetUp,
        Consent,
        Opening,
        Coming, ///< the device brings the finger to the start
        Ready,
        Feeling,
        Answering,
        Keeping,
        Break,
        Paused,
        Stopping, ///< asked whether to stop
        Done
    };
    Q_ENUM(State)

    /// All must outlive it.
    StudyRun(const StudySettings& settings, StudyFinger& finger, StudyKeeping& keeping, StudyEar& ear,
             StudyTeller& teller);

    State state() const { return state_; }
    bool running() const { return state_ != State::SetUp; }
    QString trial() const;
    QString progress_words() const;
    double fraction() const;
    QString status() const;
    QString consent() const;
    QStringList answers() const;
    bool trying() const { return plan_.show_scene; }
    /// The lines of the trial, for whoever tries it out; null in every sitting that is kept.
    const FlatScene* shown() const;
    Vec2 shown_finger() const;
    bool hand_moves() const { return state_ == State::Feeling && !finger_.real(); }
    double surface_width() const { return plan_.experiment.surface_width_mm; }
    double surface_height() const { return plan_.experiment.surface_height_mm; }

    /// Asks for consent.
    void begin(StudyPlan plan);
    Q_INVOKABLE void agree();
    /// The one key that goes on, whatever goes on.
    Q_INVOKABLE void goOn();
    /// By the number of an answer, from 0.
    Q_INVOKABLE void answer(int index);
    Q_INVOKABLE void pause() { pause_because({}); }
    /// Asks, then stops; false where nothing runs.
    Q_INVOKABLE bool stop();

    /// Takes the force away, at once; `why`: a sentence.
    void pause_because(const QString& why);
    /// The page goes out of sight: paused, and the device is free for others.
    void leave();
    /// Tells a person who comes back where one is.
    void tell_where();
    /// The hand of a drawn finger moves, mm, x right, y up.
    void move_by(Vec2 way);
    void poll();

signals:
    void changed();
    /// It is over; `participant` may go on another day.
    void ended();
    /// The finger has moved, for those who see it.
    void felt();

private:
    void become(State state);
    bool in_trial() const { return state_ == State::Feeling || state_ == State::Answering; }
    void open();
    void finger_taken();
    void finger_refused(const QString& sentence);
    void opened(const StudyKeeping::Known& known);
    void offer(const QString& before = {});
    void ready(const QString& before = {});
    void start();
    void judge();
    void felt_enough(bool out_of_time);
    void ask(bool out_of_time);
    void keep(TrialRecord record, State then, const QString& said);
    void kept(const QString& problem);
    void break_off(State then, const QString& said);
    void end(const QString& said);
    void fail(const QString& problem);
    StudyProgress progress() const;

    static constexpr int poll_ms = 5; ///< 200 samples a second

    const StudySettings& settings_;
    StudyFinger& finger_;
    StudyKeeping& keeping_;
    StudyEar& ear_;
    StudyTeller& teller_;
    State state_ = State::SetUp;
    StudyPlan plan_;
    bool is_open_ = false; ///< the folder
    bool introduced_ = false;
    std::vector<PlannedTrial> trials_;
    std::vector<TrialRecord> records_; ///< this participant's
    std::optional<NextTrial> next_;
    std::optional<StudyTrial> laid_; ///< the trial that comes
    int rested_before_ = 0;          ///< number of the trial whose break is over
    std::unique_ptr<FeltTrial> felt_;
    std::optional<TrialRecord> keeping_record_;
    State after_ = State::Coming; ///< when it is kept
    QString said_after_;
    std::uint64_t sitting_ = 0; ///< what an older one waited for is not told
    QTimer timer_;
};

} // namespace tp
