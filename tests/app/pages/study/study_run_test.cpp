// SPDX-License-Identifier: Apache-2.0
// A sitting by itself: its states, the order of its trials, how each ends, what is kept and what is told.
#include "study_parts.hpp"
#include "test_program.hpp"

#include <QDir>
#include <QSignalSpy>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace study_run_test {

using namespace tp;
using State = StudyRun::State;

namespace {

/// To a state, with shapes that are named.
void lead_to(StudyParts& bench, State state) {
    StudyRun& run = bench.run();
    if (state != State::SetUp)
        run.begin(bench.plan(StudyParts::shapes));
    if (state > State::Consent)
        run.agree();
    if (state > State::Opening)
        bench.opened();
    const int named = state == State::Break ? 2 : state == State::Done ? 4 : 0;
    for (int trial = 1; trial <= named; ++trial) {
        if (run.state() == State::Break)
            run.goOn();
        bench.name(0);
    }
    if (state == State::Feeling || state == State::Answering || state == State::Keeping)
        bench.start();
    if (state == State::Answering)
        run.goOn();
    if (state == State::Keeping)
        run.answer(0);
    if (state == State::Paused)
        run.pause();
    if (state == State::Stopping)
        run.stop();
    QCOMPARE(run.state(), state);
}

/// Where it is led from there by itself, the folder and the disk.
State settled(StudyParts& bench) {
    const auto waits = [&] {
        return bench.run().state() == State::Opening || bench.run().state() == State::Keeping;
    };
    return QTest::qWaitFor([&] { return !waits(); }, 60000) ? bench.run().state() : State::Opening;
}

constexpr State all_states[]{State::SetUp,   State::Consent,   State::Opening, State::Ready,
                             State::Feeling, State::Answering, State::Keeping, State::Break,
                             State::Paused,  State::Stopping,  State::Done};

} // namespace

class StudyRunTest : public QObject {
    Q_OBJECT
private slots:
    void the_table_of_its_states_holds_data() {
        QTest::addColumn<State>("from");
        QTest::addColumn<QList<State>>("to"); ///< by agree, Space, an answer, pause and Escape
        using S = State;
        const auto row = [](const char* name, S from, QList<S> to) { QTest::newRow(name) << from << to; };
        row("SetUp", S::SetUp, {S::SetUp, S::SetUp, S::SetUp, S::SetUp, S::SetUp});
        row("Consent", S::Consent, {S::Ready, S::Consent, S::Consent, S::Consent, S::SetUp});
        row("Opening", S::Opening, {S::Ready, S::Ready, S::Ready, S::Ready, S::SetUp});
        row("Ready", S::Ready, {S::Ready, S::Feeling, S::Ready, S::Paused, S::Stopping});
        row("Feeling", S::Feeling, {S::Feeling, S::Answering, S::Ready, S::Paused, S::Stopping});
        row("Answering", S::Answering, {S::Answering, S::Answering, S::Ready, S::Paused, S::Stopping});
        row("Keeping", S::Keeping, {S::Ready, S::Ready, S::Ready, S::Paused, S::Stopping});
        row("Break", S::Break, {S::Break, S::Ready, S::Break, S::Break, S::Stopping});
        row("Paused", S::Paused, {S::Paused, S::Ready, S::Paused, S::Paused, S::Stopping});
        row("Stopping", S::Stopping, {S::Stopping, S::Ready, S::Stopping, S::Stopping, S::SetUp});
        row("Done", S::Done, {S::Done, S::SetUp, S::Done, S::Done, S::SetUp});
    }
    void the_table_of_its_states_holds() {
        QFETCH(State, from);
        QFETCH(QList<State>, to);
        const std::function<void(StudyRun&)> done[]{
            [](StudyRun& run) { run.agree(); }, [](StudyRun& run) { run.goOn(); },
            [](StudyRun& run) { run.answer(0); }, [](StudyRun& run) { run.pause(); },
            [from](StudyRun& run) { QCOMPARE(run.stop(), from != State::SetUp); }};
        for (int i = 0; i < to.size(); ++i) {
            StudyParts bench;
            lead_to(bench, from);
            done[i](bench.run());
            QCOMPARE(settled(bench), to[i]);
            QCOMPARE(bench.finger.has_servo() && bench.finger.seen().force() != Vec2(0.0), false);
        }
    }

    void each_state_is_told_shown_and_signalled_once() {
        QStringList shown;
        for (const State state : all_states) {
            StudyParts bench;
            lead_to(bench, state);
            QCOMPARE(bench.run().running(), state != State::SetUp);
            QCOMPARE(bench.run().hand_moves(), state == State::Feeling);
            QCOMPARE(bench.run().consent().isEmpty(), state != State::Consent);
            QCOMPARE(bench.run().answers().size(), state == State::Answering ? 2 : 0);
            shown << bench.run().status();
            bench.voice.clear();
            bench.run().tell_where();
            if (state == State::SetUp)
                QVERIFY(bench.voice.said().isEmpty());
            else if (state == State::Consent)
                QCOMPARE(bench.said(), bench.run().consent());
            else
                QVERIFY2(bench.said().endsWith(bench.run().status() + '.'), qPrintable(bench.said()));
        }
        QCOMPARE(shown.removeDuplicates(), 0);
        StudyParts bench;
        const QSignalSpy changed(bench.sitting.get(), &StudyRun::changed);
        const QSignalSpy felt(bench.sitting.get(), &StudyRun::felt);
        bench.begin(StudyParts::shapes); // Consent, Opening, Ready
        QCOMPARE(changed.size(), 3);
        bench.pass(0.1);
        QCOMPARE(felt.size(), 0);
        bench.start();
        bench.pass(0.1);
        QCOMPARE(changed.size(), 4);
        QCOMPARE(felt.size(), 21);
        bench.run().goOn();
        bench.pass(0.1);
        QCOMPARE(changed.size(), 5);
        QCOMPARE(felt.size(), 21);
        bench.run().answer(2); // there is no third
        bench.run().answer(-1);
        bench.run().begin(bench.plan(StudyParts::lines)); // one goes on
        QCOMPARE(changed.size(), 5);
        QCOMPARE(bench.run().state(), State::Answering);
    }

    void a_pull_that_is_cut_or_raised_is_said_and_stands_in_the_record() {
        for (const bool allowed : {false, true}) {
            StudyParts bench;
            StudyPlan plan = bench.plan(StudyParts::lines); // asks for 5 N
            plan.force_allowed = allowed;
            bench.sitting->begin(plan);
            QCOMPARE(bench.run().consent().startsWith(
                         "The force may be stronger than this program usually allows, up "
                         "to 5.0 newtons. You are asked to take part"),
                     allowed);
            bench.run().agree();
            bench.opened();
            QCOMPARE(bench.said().contains("The pull is cut at 1.0 newtons; the study asks for 5.0."),
                     !allowed);
            bench.follow();
            bench.settle();
            const auto study = read_study(bench.study_folder());
            QVERIFY(study && !study->sittings.empty());
            const std::string& device = study->sittings.front().machine.device;
            QVERIFY2(device.ends_with(allowed ? "at most 5.00 N, raised with the researcher's consent"
                                              : "at most 1.00 N, cut: the study asks for 5.00 N"),
                     device.c_str());
        }
    }

    void in_training_that_asks_nothing_space_ends_the_trial() {
        StudyParts bench;
        bench.begin("experiment: shapes\ntask: name\nfactor shape: circle, square\nanswer: shape\n"
                    "training: 2\ntraining shape: line, curve\nlongest training: 2 s\n");
        QVERIFY2(bench.said().endsWith("Feel the line; nothing is asked. Press Space to start."),
                 qPrintable(bench.said()));
        bench.start();
        bench.run().answer(0); // there is no question
        QCOMPARE(bench.run().state(), State::Feeling);
        bench.run().goOn();
        bench.settle();
        bench.start();
        bench.pass(2.1); // the time is over
        bench.settle();
        const auto records = bench.records();
        QCOMPARE(records.size(), std::size_t{2});
        for (const TrialRecord& record : records)
            QVERIFY(record.training && !record.repeated && record.answer.empty());
        QVERIFY2(bench.said().contains("Feel the shape."), qPrintable(bench.said()));
        bench.start();
        bench.run().goOn();
        QCOMPARE(bench.run().state(), State::Answering);
    }

    void trials_come_in_the_plan_s_order_and_are_kept_one_by_one() {
        QList<QList<std::size_t>> orders;
        for (const int participant : {1, 2}) {
            StudyParts bench;
            bench.participant = participant;
            bench.begin(StudyParts::shapes);
            const auto plan = trials_of(bench.experiment, participant, StudyParts::seed);
            orders << QList<std::size_t>();
            for (int trial = 1; trial <= 4; ++trial) {
                QCOMPARE(bench.run().trial(), QString("Trial %1 of 4").arg(trial));
                QCOMPARE(bench.run().fraction(), 0.25 * (trial - 1));
                bench.name(1);
                const auto records = bench.records(); // on the disk before the next is offered
                QCOMPARE(records.size(), std::size_t(trial));
                QCOMPARE(records.back().trial, trial);
                QCOMPARE(records.back().condition, plan[records.size() - 1].condition);
                QCOMPARE(records.back().seed, plan[records.size() - 1].seed);
                QCOMPARE(records.back().answer, std::string("square"));
                QVERIFY(!records.back().repeated);
                orders.back() << records.back().condition;
                QCOMPARE(bench.run().progress_words(),
                         trial < 4
                             ? QString("Participant %1 has done %2 of 4 trials.").arg(participant).arg(trial)
                             : QString("Participant %1 has done all 4 trials.").arg(participant));
                QCOMPARE(bench.run().state(), trial == 2   ? State::Break
                                              : trial == 4 ? State::Done
                                                           : State::Ready);
                if (trial == 2) {
                    QVERIFY2(bench.said().startsWith("Time for a break."), qPrintable(bench.said()));
                    bench.run().goOn();
                }
            }
            QVERIFY2(bench.said().startsWith("That was the last trial."), qPrintable(bench.said()));
            QCOMPARE(bench.run().trial(), QString());
        }
        QVERIFY(orders[0] != orders[1]);
    }

    void what_is_done_is_told_before_the_first_trial_only() {
        StudyParts bench;
        bench.begin(StudyParts::shapes);
        const QString first = bench.said();
        QVERIFY2(first.startsWith("Feel a shape until you know which it is.") &&
                     first.contains("A tone says where the line is") &&
                     first.endsWith("Trial 1 of 4. Feel the shape. Press Space to start."),
                 qPrintable(first));
        bench.name(0);
        QCOMPARE(bench.said(), QString("Trial 2 of 4. Feel the shape. Press Space to start."));
    }

    void a_line_is_felt_from_its_start_to_its_end() {
        StudyParts bench;
        bench.begin(StudyParts::lines);
        for (int trial = 1; trial <= 3; ++trial) {
            bench.follow();
            bench.settle();
            const TrialRecord record = bench.records().back();
            QCOMPARE(record.training, trial == 1);
            QVERIFY(!record.repeated && record.error_mm && *record.error_mm < 4.0);
            QVERIFY(record.time_s > 1.0 && record.time_s < 20.0);
            const auto path = bench.path_of(record.trial);
            QVERIFY(static_cast<double>(path.size()) >= 100.0 * record.time_s);
            QVERIFY(std::abs(path.back().time_s - record.time_s) < 0.011);
            double strongest = 0.0;
            for (const FingerSample& one : path)
                strongest = std::max(strongest, std::hypot(one.fx_n, one.fy_n));
            QVERIFY2(strongest > 0.005 && strongest < 1.1, qPrintable(QString::number(strongest)));
        }
        QCOMPARE(bench.run().state(), State::Done);
        QVERIFY(!bench.guide.sounds());
    }

    void a_part_that_was_left_out_is_said_and_the_trial_is_done_again() {
        StudyParts bench;
        bench.begin(StudyParts::lines);
        while (bench.run().state() == State::Ready && bench.now().path.closed) {
            bench.follow();
            bench.settle();
        }
        const StudyTrial curve = bench.start();
        bench.go(curve.start + Vec2(0.0, 60.0)); // far round the middle of the curve
        bench.go(curve.path.points.back() + Vec2(0.0, 60.0));
        bench.go(curve.path.points.back());
        for (int i = 0; i < 400 && bench.run().state() == State::Feeling; ++i)
            bench.pass(0.005);
        bench.settle();
        QVERIFY2(bench.said().startsWith("A part of the line was left out; the trial is done again.") &&
                     bench.said().contains(", once more"),
                 qPrintable(bench.said()));
        QVERIFY(bench.records().back().repeated);
        QCOMPARE(bench.run().state(), State::Ready);
        QVERIFY(!bench.now().path.closed); // the same one
    }

    void a_line_that_is_not_followed_to_its_end_is_done_again() {
        StudyParts bench;
        bench.begin(StudyParts::lines);
        bench.follow(0.3);
        bench.run().goOn();
        bench.settle();
        QVERIFY2(bench.said().startsWith("The end of the line was not reached; the trial is done again."),
                 qPrintable(bench.said()));
        QVERIFY(bench.records().back().repeated && bench.records().back().training);
        QCOMPARE(bench.run().trial(), QString("Training 1 of 1"));
        StudyParts hasty;
        hasty.begin("experiment: hasty\ntask: follow\nfactor path: circle, curve\nlongest trial: 1 s\n");
        hasty.start();
        hasty.pass(1.1);
        hasty.settle();
        QVERIFY2(hasty.said().startsWith("The time is over; the trial is done again."),
                 qPrintable(hasty.said()));
        QVERIFY(hasty.records().back().repeated);
        QCOMPARE(hasty.run().fraction(), 0.0);
    }

    void a_shape_is_felt_until_space_an_answer_or_the_end_of_the_time() {
        StudyParts bench;
        bench.begin(StudyParts::shapes);
        const StudyTrial felt = bench.start();
        bench.go(felt.start + Vec2(20.0, 0.0));
        QVERIFY(bench.guide.sounds()); // nobody feels a drawn finger's force
        const double felt_for = bench.time.now();
        bench.run().goOn();
        QVERIFY(!bench.guide.sounds());
        QCOMPARE(bench.said(), QString("Which was it? 1: circle. 2: square."));
        bench.voice.clear();
        bench.run().goOn(); // the question again
        QCOMPARE(bench.said(), QString("Which was it? 1: circle. 2: square."));
        bench.pass(1.0); // thinking is not feeling
        bench.run().answer(1);
        bench.settle();
        QVERIFY(bench.records().back().time_s <= felt_for);
        bench.start();
        bench.pass(1.0);
        bench.run().answer(0);
        QVERIFY(!bench.guide.sounds());
        bench.settle();
        QVERIFY(std::abs(bench.records().back().time_s - 1.0) < 0.02);
        bench.run().goOn(); // after the break
        bench.start();
        bench.pass(2.9);
        QCOMPARE(bench.run().state(), State::Feeling);
        bench.pass(0.2);
        QCOMPARE(bench.run().state(), State::Answering);
        QVERIFY2(bench.said().startsWith("The time is over. Which was it?"), qPrintable(bench.said()));
        bench.run().answer(0);
        bench.settle();
        QVERIFY(std::abs(bench.records().back().time_s - 3.0) < 0.02);
        QVERIFY(!bench.records().back().repeated);
    }

    void the_hand_moves_the_finger_in_a_trial_only() {
        StudyParts bench;
        bench.begin(StudyParts::shapes);
        const Vec2 waits = bench.finger.place();
        bench.run().move_by({30.0, 0.0});
        bench.pass(0.3);
        QVERIFY(length(bench.finger.place() - waits) < 0.1);
        const StudyTrial trial = bench.start();
        QVERIFY(length(bench.finger.place() - trial.start) < 5.0);
        bench.run().move_by({20.0, 0.0});
        bench.pass(0.5);
        QVERIFY(length(bench.finger.place() - trial.start) > 10.0);
    }

    void who_tries_it_out_sees_it_and_nothing_is_kept() {
        StudyParts bench;
        StudyPlan plan = bench.plan(StudyParts::shapes);
        plan.show_scene = true;
        bench.run().begin(plan);
        QVERIFY(bench.run().shown() == nullptr);
        bench.run().agree();
        QCOMPARE(bench.run().state(), State::Ready); // there is no folder to wait for
        QVERIFY(bench.run().trying() && bench.run().shown() != nullptr);
        const Vec2 start = bench.run().shown_finger();
        bench.run().goOn();
        bench.run().move_by({20.0, 0.0});
        bench.pass(0.5);
        QVERIFY(length(bench.run().shown_finger() - start) > 10.0);
        bench.run().answer(0);
        QCOMPARE(bench.run().state(), State::Ready);
        QCOMPARE(bench.run().trial(), QString("Trial 2 of 4"));
        bench.run().stop();
        bench.run().stop();
        QCOMPARE(bench.said(), QString("Stopped."));
        QVERIFY(!QDir(bench.documents()).exists());
        bench.begin(StudyParts::shapes);
        QVERIFY(!bench.run().trying() && bench.run().shown() == nullptr);
        QCOMPARE(bench.run().trial(), QString("Trial 1 of 4"));
    }

    void in_real_time_it_looks_at_the_finger_by_itself() {
        StudyParts bench;
        bench.settings.time = nullptr;
        const QSignalSpy felt(bench.sitting.get(), &StudyRun::felt);
        bench.begin("experiment: hasty\ntask: name\nfactor shape: circle, square\nanswer: shape\n"
                    "longest trial: 1 s\n");
        QCOMPARE(felt.size(), 0);
        bench.run().goOn();
        QTRY_COMPARE_WITH_TIMEOUT(bench.run().state(), State::Answering, 60000);
        QVERIFY(felt.size() > 2);
        bench.run().answer(0);
        bench.settle();
        QVERIFY(bench.records().back().time_s >= 1.0);
    }
};

} // namespace study_run_test

TP_TEST(study_run_test, StudyRunTest, event_loop)
#include "study_run_test.moc"
