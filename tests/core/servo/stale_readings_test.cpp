// SPDX-License-Identifier: Apache-2.0
// What a loop makes of a device's clock that stands still or jumps.
#include "core/servo/servo_loop.hpp"
#include "loop_bench.hpp"
#include "troubled_stamps.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

using namespace tp;
using namespace tp::testing;

namespace {

/// N, the law's at 0.5 mm with K = 0.2 N/mm.
const Vec2 at_rest(0.0, -0.10);

/// A finger on its way up to 0.5 mm above a line at 200 mm/s, where it rests from `arrival` s on.
constexpr double arrival = 2.0;
Vec2 arrives(double now) { return {10.0, 0.5 - 0.2e3 * std::clamp(arrival - now, 0.0, 0.35)}; }

/// A loop in simulated time whose device has trouble with its stamps from the first tick after `begin` s on.
struct Troubled : LoopBench {
    const StampTrouble* trouble = nullptr;

    explicit Troubled(Vec2 (*place)(double)) {
        device.place = place;
        device.stamp = [this](double now) {
            const double stamp = 7.0 + now;
            if (trouble == nullptr) {
                last_ = stamp;
                count_ = 0;
                return stamp;
            }
            return trouble->stamped(stamp, last_, count_++);
        };
        loop.render(line_scene(0.0));
        loop.engage();
    }
    ServoSnapshot tick() {
        run(0.001);
        return loop.snapshot();
    }

private:
    double last_ = 0.0;
    int count_ = 0;
};

void each_of(const std::vector<StampTrouble>& troubles) {
    QTest::addColumn<const StampTrouble*>("trouble");
    for (const StampTrouble& one : troubles)
        QTest::newRow(one.name) << &one;
}

} // namespace

Q_DECLARE_METATYPE(const StampTrouble*)

class StaleReadingsTest : public QObject {
    Q_OBJECT
private slots:
    /// Held, the velocity made the force 0.88 N where the law has 0.10 N.
    void after_200_mm_per_s_readings_that_are_no_newer_are_a_fault_data() { each_of(stale_stamps()); }
    void after_200_mm_per_s_readings_that_are_no_newer_are_a_fault() {
        QFETCH(const StampTrouble*, trouble);
        Troubled bench(arrives);
        bench.run(arrival);
        QCOMPARE(bench.loop.snapshot().fault, Fault::none);
        QVERIFY(bench.loop.snapshot().gain == 1.0);
        bench.trouble = trouble;
        double stale_after = 0.0;
        double zero_after = 0.0;
        for (int ms = 1; ms <= 500; ++ms) {
            const ServoSnapshot view = bench.tick();
            QVERIFY(view.fault == Fault::none || view.fault == Fault::stale_input);
            if (view.fault == Fault::none)
                stale_after = 0.001 * (ms + 1);
            if (view.force() != Vec2(0.0))
                zero_after = 0.001 * (ms + 1);
        }
        QVERIFY2(stale_after <= trouble->stale_within, qPrintable(QString::number(stale_after)));
        QVERIFY2(zero_after <= stale_after + 0.021, qPrintable(QString::number(zero_after)));

        bench.trouble = nullptr; // and it comes back by the ramp, as the law has it
        int blind = 0;
        while (bench.tick().fault != Fault::none)
            QVERIFY(++blind <= trouble->back_after);
        QVERIFY(length(bench.loop.snapshot().force()) < 0.01);
        bench.run(0.6);
        QVERIFY(length(bench.loop.snapshot().force() - at_rest) < 1e-6);
    }

    /// No fault yet, and no old velocity any more: a device that is silent, or whose stamp stands still, for 18 ms. An
    /// old velocity adds up to 0.78 N in that time.
    void after_200_mm_per_s_a_pause_of_18_ms_leaves_the_law_alone_data() {
        QTest::addColumn<bool>("silent");
        QTest::newRow("silent") << true;
        QTest::newRow("stamp_stands_still") << false;
    }
    void after_200_mm_per_s_a_pause_of_18_ms_leaves_the_law_alone() {
        QFETCH(bool, silent);
        Troubled bench(arrives);
        bench.run(arrival);
        bench.device.silent = silent;
        bench.trouble = silent ? nullptr : &stale_stamps().front();
        bench.run(0.018);
        QCOMPARE(bench.loop.snapshot().fault, Fault::none);
        const double left = length(bench.loop.snapshot().force() - at_rest);
        QVERIFY2(left < 0.05, qPrintable(QString::number(left)));
        bench.device.silent = false;
        bench.trouble = nullptr;
        bench.run(0.040);
        QCOMPARE(bench.loop.snapshot().fault, Fault::none);
        QVERIFY(length(bench.loop.snapshot().force() - at_rest) < 0.002);
    }

    void a_finger_at_rest_feels_nothing_of_a_clock_that_jumps_data() { each_of(survived_stamps()); }
    void a_finger_at_rest_feels_nothing_of_a_clock_that_jumps() {
        QFETCH(const StampTrouble*, trouble);
        Troubled bench([](double) { return Vec2(10.0, 0.5); });
        bench.run(1.0);
        bench.trouble = trouble;
        for (int ms = 0; ms < 1000; ++ms) {
            const ServoSnapshot view = bench.tick();
            QCOMPARE(view.fault, Fault::none);
            QVERIFY(length(view.force() - at_rest) < 1e-9);
        }
    }

    /// Beside the same finger with a clock that does not jump.
    void a_finger_in_motion_is_where_it_is_after_two_readings_data() { each_of(survived_stamps()); }
    void a_finger_in_motion_is_where_it_is_after_two_readings() {
        QFETCH(const StampTrouble*, trouble);
        constexpr double speed = 100.0; // mm/s at most, to and fro across the line
        const auto place = [](double now) {
            return Vec2(20.0 * now - 20.0, 3.0 * std::sin(speed / 3.0 * now));
        };
        Troubled bench(place);
        Troubled twin(place);
        bench.run(1.0);
        twin.run(1.0);
        bench.trouble = trouble;
        const bool lasts = trouble->blind > 2;
        double strongest = 0.0;
        for (int ms = 0; ms < 1000; ++ms) {
            const ServoSnapshot view = bench.tick();
            const ServoSnapshot right = twin.tick();
            QCOMPARE(view.fault, Fault::none);
            const double off = length(view.finger() - right.finger());
            QVERIFY(off <= 1.05e-3 * speed * (trouble->blind - 1));
            strongest = std::max(strongest, length(view.force() - right.force()));
        }
        QVERIFY2(lasts || strongest < 0.05, qPrintable(QString::number(strongest)));
    }

    /// Beside the same finger with a clock that does not jump: 3 m/s, twice of what the chain allows.
    void over_speed_is_noticed_all_the_same_data() { each_of(survived_stamps()); }
    void over_speed_is_noticed_all_the_same() {
        QFETCH(const StampTrouble*, trouble);
        const auto place = [](double now) { return Vec2(-60.0 + 3e3 * std::max(0.0, now - 1.0), 0.5); };
        const auto noticed_after = [](Troubled& bench) {
            int ms = 0;
            while (ms < 40 && bench.tick().fault != Fault::over_speed)
                ++ms;
            return ms;
        };
        Troubled bench(place);
        Troubled twin(place);
        bench.run(1.0);
        twin.run(1.0);
        bench.trouble = trouble;
        const int right = noticed_after(twin);
        QVERIFY(right < 6);
        const int troubled = noticed_after(bench);
        QVERIFY2(troubled <= right + trouble->blind, qPrintable(QString::number(troubled)));
    }

    void a_loop_that_is_started_again_believes_the_clock_that_it_finds() {
        Troubled bench([](double) { return Vec2(10.0, 0.5); });
        bench.run(1.0);
        bench.loop.stop();
        bench.device.stamp = [](double now) { return now - 1e6; };
        bench.device.place = [](double) { return Vec2(12.0, 0.5); };
        QVERIFY(bench.tick().finger() == Vec2(12.0, 0.5));
        QCOMPARE(bench.loop.snapshot().fault, Fault::none);
        bench.run(0.6);
        QVERIFY(length(bench.loop.snapshot().force() - at_rest) < 1e-9);
    }
};

QTEST_APPLESS_MAIN(StaleReadingsTest)
#include "stale_readings_test.moc"
