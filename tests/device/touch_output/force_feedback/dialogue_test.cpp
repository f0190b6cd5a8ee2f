// SPDX-License-Identifier: Apache-2.0
// What a node is asked for and when, request by request.
#include "device/touch_output/force_feedback/feedback_output.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cerrno>
#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace dialogue_test {

using namespace tp;

namespace {

/// What a node was asked for, and what it answers.
struct Diary {
    QStringList asked;
    std::deque<int> answers; ///< errno of the next requests; 0 where there is none
    bool there = true;
    double now = 0.0;
    FeedbackOutput* told_meanwhile = nullptr; ///< is halted while the next change is made

    int answer() {
        const int error = answers.empty() ? 0 : answers.front();
        if (!answers.empty())
            answers.pop_front();
        return error;
    }
    QString taken() { return std::exchange(asked, {}).join(", "); }
};

class WrittenNode final : public FeedbackNode {
public:
    WrittenNode(Diary& diary, FeedbackKind kind) : diary_(diary), kind_(kind) {}
    ~WrittenNode() override { diary_.asked << "closed"; }
    FeedbackKind kind() const override { return kind_; }
    int upload(const FeedbackEffect& effect) noexcept override {
        diary_.asked << QString("change %1 %2 %3 %4")
                            .arg(effect.strong)
                            .arg(effect.weak)
                            .arg(effect.period_ms)
                            .arg(effect.length_ms);
        if (FeedbackOutput* const output = std::exchange(diary_.told_meanwhile, nullptr))
            output->halt();
        return diary_.answer();
    }
    int play(bool on) noexcept override {
        diary_.asked << (on ? "play" : "end");
        return diary_.answer();
    }
    bool there() const noexcept override { return diary_.there; }

private:
    Diary& diary_;
    FeedbackKind kind_;
};

struct Bench {
    Diary diary;
    FeedbackOutput output;

    explicit Bench(FeedbackKind kind = FeedbackKind::two_motors)
        : output(
              {"Twin motors", "00:11"},
              [this, kind]() -> Result<std::unique_ptr<FeedbackNode>> {
                  return std::unique_ptr<FeedbackNode>(std::make_unique<WrittenNode>(diary, kind));
              },
              LatestWriter::Thread::caller, [this] { return diary.now; }) {}
    /// One tick, delivered.
    bool tick(const Tick& tick) {
        const bool taken = output.tick(tick);
        output.deliver();
        return taken;
    }
};

const Tick sharp(1.0, 1.0, 0.008);
const Tick soft(0.5, 0.0, 0.05);

} // namespace

class DialogueTest : public QObject {
    Q_OBJECT
private slots:
    void a_place_is_taken_and_nothing_played_before_a_tick() {
        Bench bench;
        const auto can = bench.output.open();
        QVERIFY(can.ok());
        bench.output.deliver();
        QCOMPARE(bench.diary.taken(), QString("change 0 0 8 1"));
        QCOMPARE(can->name, std::string("Twin motors"));
        QCOMPARE(can->serial_number, std::string("00:11"));
        QCOMPARE(can->means, TouchMeans::rumble);
        QCOMPARE(can->shortest_s, 0.04);
        QVERIFY(!can->pad);
        Bench waves(FeedbackKind::sine);
        QCOMPARE(waves.output.open()->means, TouchMeans::ticks);
    }

    void an_effect_is_changed_only_where_the_tick_differs() {
        Bench bench;
        QVERIFY(bench.output.open().ok());
        bench.diary.taken();
        QVERIFY(bench.tick(sharp));
        QCOMPARE(bench.diary.taken(), QString("change 0 65535 0 40, play"));
        QVERIFY(bench.tick(sharp));
        QCOMPARE(bench.diary.taken(), QString("play"));
        QVERIFY(bench.tick(soft));
        QCOMPARE(bench.diary.taken(), QString("change 32768 0 0 50, play"));
        bench.output.deliver();
        QCOMPARE(bench.diary.taken(), QString());
    }

    void of_ticks_that_come_too_fast_the_newest_is_played() {
        Bench bench;
        QVERIFY(bench.output.open().ok());
        bench.diary.taken();
        QVERIFY(bench.output.tick(soft));
        QVERIFY(bench.tick(sharp));
        QCOMPARE(bench.diary.taken(), QString("change 0 65535 0 40, play"));
    }

    void an_empty_tick_and_friction_are_nothing() {
        Bench bench;
        QVERIFY(bench.output.open().ok());
        bench.diary.taken();
        QVERIFY(bench.tick(Tick()));
        QVERIFY(bench.output.resist(1.0));
        bench.output.deliver();
        QCOMPARE(bench.diary.taken(), QString());
    }

    void halted_it_ends_at_once_and_stopped_it_is_closed() {
        Bench bench;
        QVERIFY(bench.output.open().ok());
        QVERIFY(bench.tick(soft));
        bench.diary.taken();
        bench.output.halt();
        bench.output.deliver();
        QCOMPARE(bench.diary.taken(), QString("end"));
        QVERIFY(bench.tick(soft));
        QCOMPARE(bench.diary.taken(), QString("play"));
        bench.output.stop();
        QCOMPARE(bench.diary.taken(), QString("end, closed"));
        bench.output.stop();
        bench.output.halt();
        QVERIFY(!bench.output.tick(soft));
        QVERIFY(!bench.output.resist(1.0));
        QCOMPARE(bench.diary.taken(), QString());
    }

    void halted_while_the_driver_takes_its_time_nothing_is_played() {
        Bench bench;
        QVERIFY(bench.output.open().ok());
        bench.diary.taken();
        QVERIFY(bench.output.tick(soft));
        bench.diary.told_meanwhile = &bench.output;
        bench.output.deliver();
        QCOMPARE(bench.diary.taken(), QString("change 32768 0 0 50"));
        bench.output.deliver();
        QCOMPARE(bench.diary.taken(), QString("end"));
    }

    void a_tick_that_comes_too_late_is_left_out_and_it_is_said() {
        Bench bench;
        QVERIFY(bench.output.open().ok());
        bench.diary.taken();
        QVERIFY(bench.output.tick(sharp));
        bench.diary.now += FeedbackOutput::late_after_s + 0.001;
        bench.output.deliver();
        QCOMPARE(bench.diary.taken(), QString("change 0 65535 0 40"));
        QVERIFY(bench.output.complaint().find("too slowly") != std::string::npos);
        QVERIFY(!bench.output.lost());
        bench.diary.now = 0.0;
        QVERIFY(bench.output.tick(sharp));
        bench.diary.now = FeedbackOutput::late_after_s; // just in time
        bench.output.deliver();
        QCOMPARE(bench.diary.taken(), QString("play"));
        QCOMPARE(bench.output.complaint(), std::string());
    }

    void a_refused_change_is_said_and_made_again() {
        Bench bench;
        QVERIFY(bench.output.open().ok());
        bench.diary.taken();
        bench.diary.answers = {EIO};
        QVERIFY(bench.tick(sharp));
        QCOMPARE(bench.diary.taken(), QString("change 0 65535 0 40"));
        QVERIFY(bench.output.complaint().find("did not play") != std::string::npos);
        QVERIFY(!bench.output.lost());
        QVERIFY(bench.tick(sharp));
        QCOMPARE(bench.diary.taken(), QString("change 0 65535 0 40, play"));
        QCOMPARE(bench.output.complaint(), std::string());
        bench.diary.answers = {EIO};
        QVERIFY(bench.tick(sharp));
        QVERIFY(!bench.output.complaint().empty());
    }

    void unplugged_it_is_lost_whether_it_ticks_or_not() {
        for (const int answer : {0, ENODEV, ENXIO, EBADF}) {
            const bool ticks = answer != 0;
            Bench bench;
            QVERIFY(bench.output.open().ok());
            QVERIFY(!bench.output.lost());
            QCOMPARE(bench.output.complaint(), std::string());
            if (ticks) {
                bench.diary.answers = {answer};
                bench.tick(sharp);
            } else {
                bench.diary.there = false;
            }
            QVERIFY(bench.output.lost());
            QVERIFY(bench.output.complaint().find("was unplugged") != std::string::npos);
            QVERIFY(!bench.output.tick(sharp));
            QVERIFY(!bench.output.resist(1.0));
            bench.output.stop();
            QVERIFY(bench.output.lost());
            bench.diary.there = true;
            QVERIFY(bench.output.open().ok());
            QVERIFY(!bench.output.lost());
            QCOMPARE(bench.output.complaint(), std::string());
        }
    }

    void why_it_cannot_be_reached_is_passed_on() {
        FeedbackOutput output(
            {"Twin motors", ""},
            []() -> Result<std::unique_ptr<FeedbackNode>> { return Error{"It is gone."}; },
            LatestWriter::Thread::caller);
        QCOMPARE(output.open().error(), std::string("It is gone."));
        QVERIFY(!output.tick(sharp));
    }

    void why_it_cannot_be_opened_is_one_sentence_and_nothing_stays_open() {
        const std::vector<std::pair<int, std::string>> whys{
            {ENOSPC, "Other programs use all that the Twin motors can play."},
            {ENODEV, "The Twin motors was unplugged."},
            {EACCES, "resources/udev/70-touchphoto.rules"},
            {EINVAL, "The Twin motors could not be opened."}};
        for (const std::pair<int, std::string>& why : whys) {
            Bench bench;
            bench.diary.answers = {why.first};
            const auto can = bench.output.open();
            QVERIFY(!can.ok());
            QVERIFY2(can.error().find(why.second) != std::string::npos, can.error().c_str());
            QCOMPARE(bench.diary.taken(), QString("change 0 0 8 1, closed"));
            QVERIFY(!bench.output.tick(sharp));
            bench.output.halt();
            QVERIFY(bench.output.open().ok());
        }
    }
};

} // namespace dialogue_test

TP_TEST(dialogue_test, DialogueTest, nothing)
#include "dialogue_test.moc"
