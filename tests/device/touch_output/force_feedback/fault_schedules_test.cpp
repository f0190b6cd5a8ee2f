// SPDX-License-Identifier: Apache-2.0
// Whatever goes wrong between program and motor, and however much of it at once: what is felt is what was told last, or
// nothing; it ends in time; nobody is left without a sentence.
#include "../../closed_loop/fault_schedules.hpp"
#include "motor_bench.hpp"
#include "test_program.hpp"

#include <QString>
#include <QTest>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace fault_schedules_test {

using namespace tp;
using tp::testing::any_trouble;
using tp::testing::first_schedule;
using tp::testing::MotorBench;
using tp::testing::schedules;
using tp::testing::Trouble;

namespace {

constexpr std::array kinds{FeedbackKind::motor, FeedbackKind::two_motors, FeedbackKind::sine,
                           FeedbackKind::square};
constexpr int troubles_there_are = 7;
constexpr double ms = 0.001;

void set(MotorBench& bench, const Trouble& trouble, bool on) {
    FeedbackTroubles& troubles = bench.motor.troubles;
    switch (trouble.kind) {
    case 0:
        troubles.unplugged = true; // and stays so
        break;
    case 1:
        troubles.refuses = on;
        break;
    case 2:
        troubles.upload_takes_ms = on ? static_cast<unsigned>(250.0 * trouble.size) : 0u;
        break;
    case 3:
        bench.writer_stalled = on;
        break;
    case 4:
        if (on)
            bench.output.halt();
        break;
    case 5:
        if (on)
            bench.output.stop();
        else
            static_cast<void>(bench.output.open().ok()); // not where it was unplugged
        break;
    default:
        break; // ticks that come too fast, which the run itself makes
    }
}

/// What a finger could complain of.
class FeltJudge {
public:
    explicit FeltJudge(MotorBench& bench) : bench_(bench) {}

    void told(const Tick& tick, bool taken) {
        if (!taken)
            return;
        told_ = feedback_of(tick, bench_.motor.kind());
        told_at_ = bench_.motor.now();
        may_shake_ = true;
    }
    void silenced() {
        may_shake_ = false;
        end_refused_ = false;
    }

    void judge(std::uint64_t begun_before) {
        const ModelMotor& motor = bench_.motor;
        end_refused_ = end_refused_ || motor.troubles.refuses; // then its length ends it
        if (motor.shakes() > 0.0) {
            if (motor.shakes_for() > Tick::longest_s)
                complain("it shakes for longer than a tick may last");
            if (motor.begun().length_ms == 0)
                complain("it shakes without an end");
            if (!may_shake_ && !bench_.writer_stalled && !end_refused_)
                complain("it shakes after it was told to be still");
        }
        if (motor.beginnings() > begun_before) {
            if (!may_shake_)
                complain("it began to shake when it was still");
            if (!(motor.begun() == told_))
                complain("it plays something else than it was told");
            if (motor.now() - told_at_ > FeedbackOutput::late_after_s + 2.0 * ms)
                complain("it plays what was told long ago");
        }
        if (bench_.output.lost() && bench_.output.complaint().empty())
            complain("it is lost and nobody says so");
    }
    void complain(const char* what) {
        if (complaint.isEmpty())
            complaint = QString("%1 at %2 s").arg(what).arg(bench_.motor.now());
    }

    QString complaint;

private:
    MotorBench& bench_;
    FeedbackEffect told_;
    double told_at_ = 0.0;
    bool may_shake_ = false;
    bool end_refused_ = false;
};

/// Half a second of ticks, with up to four things that go wrong.
QString complaint_of(int number) {
    std::mt19937 random(static_cast<unsigned>(number));
    std::uniform_real_distribution<double> share(0.0, 1.0);
    MotorBench bench(kinds[static_cast<std::size_t>(number) % kinds.size()]);
    if (!bench.output.open().ok())
        return "it does not open";
    constexpr int duration = 500;
    std::vector<Trouble> troubles(1 + random() % 4);
    for (Trouble& trouble : troubles)
        trouble = any_trouble(random, static_cast<int>(random() % troubles_there_are), duration);

    FeltJudge judge(bench);
    for (int at = 0; at < duration && judge.complaint.isEmpty(); ++at) {
        const std::uint64_t begun = bench.motor.beginnings();
        double often = 0.03;
        for (const Trouble& trouble : troubles) {
            if (at == trouble.from || at == trouble.until) {
                set(bench, trouble, at == trouble.from);
                if ((trouble.kind == 4 && at == trouble.from) || trouble.kind == 5)
                    judge.silenced();
            }
            if (trouble.kind == 6 && at >= trouble.from && at < trouble.until)
                often = 1.0;
        }
        if (share(random) < often) {
            const Tick tick(0.05 + share(random), share(random), 0.06 * share(random));
            judge.told(tick, bench.output.tick(tick));
        }
        bench.step();
        judge.judge(begun);
    }
    const bool plugged = !bench.motor.troubles.unplugged;
    bench.motor.troubles = {};
    bench.motor.troubles.unplugged = !plugged;
    bench.writer_stalled = false;
    bench.run(Tick::longest_s);
    if (bench.motor.shakes() > 0.0)
        judge.complain("it shakes on when nothing is told any more");
    bench.output.stop();
    if (bench.motor.free_places() != 16)
        judge.complain("its place in the device stays taken");
    if (bench.output.open().ok() != plugged)
        judge.complain("opened again it is not as it should be");
    if (plugged && !bench.output.tick(Tick(1.0, 1.0, 0.01)))
        judge.complain("opened again it does not tick");
    bench.output.deliver();
    if (plugged && bench.motor.shakes() == 0.0)
        judge.complain("opened again nothing is felt");
    return judge.complaint;
}

} // namespace

class FaultSchedulesTest : public QObject {
    Q_OBJECT
private slots:
    void whatever_goes_wrong_what_is_felt_is_what_was_told() {
        for (int number = first_schedule(); number < first_schedule() + schedules(); ++number) {
            const QString complaint = complaint_of(number);
            QVERIFY2(complaint.isEmpty(), qPrintable(QString("schedule %1: %2").arg(number).arg(complaint)));
        }
    }
};

} // namespace fault_schedules_test

TP_TEST(fault_schedules_test, FaultSchedulesTest, nothing)
#include "fault_schedules_test.moc"
