// SPDX-License-Identifier: Apache-2.0
// A driver that takes as long as it likes over a change: whoever tells ticks never waits for it. A call that did would wait for
// ever here, where the driver goes on only after the call, and CTest ends such a test.
#include "../../until.hpp"
#include "device/touch_output/force_feedback/feedback_output.hpp"

#include <QTest>

#include <atomic>
#include <memory>
#include <semaphore>

using namespace tp;
using tp::testing::until;

namespace {

/// Each change but the first waits for a word.
struct Driver {
    std::counting_semaphore<8> changes{0};
    std::atomic<int> changing{0};
    std::atomic<int> played{0};
    std::atomic<int> ended{0};
    std::atomic<bool> there{true};
    std::atomic<bool> closed{false};
};

class SlowNode final : public FeedbackNode {
public:
    explicit SlowNode(std::shared_ptr<Driver> driver) : driver_(std::move(driver)) {}
    ~SlowNode() override { driver_->closed = true; }
    FeedbackKind kind() const override { return FeedbackKind::two_motors; }
    int upload(const FeedbackEffect&) noexcept override {
        if (driver_->changing++ > 0)
            driver_->changes.acquire();
        return 0;
    }
    int play(bool on) noexcept override {
        ++(on ? driver_->played : driver_->ended);
        return 0;
    }
    bool there() const noexcept override { return driver_->there; }

private:
    std::shared_ptr<Driver> driver_;
};

struct Bench {
    std::shared_ptr<Driver> driver = std::make_shared<Driver>();
    FeedbackOutput output{{"Twin motors", ""},
                          [this]() -> Result<std::unique_ptr<FeedbackNode>> {
                              return std::unique_ptr<FeedbackNode>(std::make_unique<SlowNode>(driver));
                          },
                          LatestWriter::Thread::own,
                          [] { return 0.0; }};
};

} // namespace

class SlowDriverTest : public QObject {
    Q_OBJECT
private slots:
    void nobody_waits_for_it_and_the_newest_word_holds() {
        Bench bench;
        QVERIFY(bench.output.open().ok());
        QVERIFY(bench.output.tick(Tick(1.0, 0.0, 0.05)));
        until([&] { return bench.driver->changing == 2; }); // it is at it
        for (int i = 0; i < 1000; ++i)
            QVERIFY(bench.output.tick(Tick(0.5, 0.0, 0.05)));
        QVERIFY(!bench.output.lost());
        QCOMPARE(bench.output.complaint(), std::string());
        bench.output.halt();
        bench.driver->changes.release();
        until([&] { return bench.driver->ended == 1; });
        QCOMPARE(bench.driver->played.load(), 0);
        bench.output.stop();
        QVERIFY(bench.driver->closed);
    }

    void unplugged_while_it_is_at_it_the_loss_is_known_at_once() {
        Bench bench;
        QVERIFY(bench.output.open().ok());
        QVERIFY(bench.output.tick(Tick(1.0, 0.0, 0.05)));
        until([&] { return bench.driver->changing == 2; });
        bench.driver->there = false;
        QVERIFY(bench.output.lost());
        QVERIFY(!bench.output.tick(Tick(1.0, 0.0, 0.05)));
        QVERIFY(bench.output.complaint().find("was unplugged") != std::string::npos);
        bench.driver->changes.release();
        bench.output.stop();
        QVERIFY(bench.driver->closed);
    }

    void one_that_never_answers_is_left_to_itself() {
        const auto driver = std::make_shared<Driver>();
        {
            FeedbackOutput output(
                {"Twin motors", ""},
                [driver]() -> Result<std::unique_ptr<FeedbackNode>> {
                    return std::unique_ptr<FeedbackNode>(std::make_unique<SlowNode>(driver));
                },
                LatestWriter::Thread::own, [] { return 0.0; }); // so that no tick is too late
            QVERIFY(output.open().ok());
            QVERIFY(output.tick(Tick(1.0, 0.0, 0.05)));
            until([&] { return driver->changing == 2; });
            output.stop();
            QVERIFY(!output.tick(Tick(1.0, 0.0, 0.05)));
        }
        QVERIFY(!driver->closed);
        driver->changes.release();
        until([&] { return driver->closed.load(); });
        QCOMPARE(driver->played.load(), 0);
    }
};

QTEST_APPLESS_MAIN(SlowDriverTest)
#include "slow_driver_test.moc"
