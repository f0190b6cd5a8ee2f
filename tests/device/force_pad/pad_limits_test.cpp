// SPDX-License-Identifier: Apache-2.0
// What a pad does at its very limits, and beyond what it can.
#include "firmware_bench.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <tuple>
#include <utility>

namespace pad_limits_test {

using namespace tp::pad;

namespace {

double place_mm(const FirmwareBench& bench) { return 1e-3 * std::hypot(bench.state.x_um, bench.state.y_um); }

/// Strong enough that only its frames limit it.
PadConfig strong_pad() {
    PadConfig config = cable_pad();
    config.max_force = 40;
    config.max_force_rate = 1e6f;
    config.cables.greatest_tension = 60;
    config.greatest_torque = 1000;
    return config;
}

} // namespace

class PadLimitsTest : public QObject {
    Q_OBJECT
private slots:
    void its_largest_force_itself_is_made_whole() {
        PadConfig config = cable_pad();
        config.max_force = 1;
        FirmwareBench bench(config);
        bench.pull(0, -1000);
        QVERIFY(!bench.has(status::limited));
        QVERIFY(bench.state.force_y_mn == -1000);
        bench.pull(0, -1001);
        QVERIFY(bench.has(status::limited));
        QVERIFY(bench.state.force_y_mn == -1000);
        bench.pad.receive(encode(ForceFrame{++bench.sequence, 0, 0, false}));
        bench.step();
        QVERIFY(!bench.has(status::limited)); // nothing is asked of it any more
    }

    void encoders_that_differ_by_what_is_allowed_are_believed() {
        PadConfig config = cable_pad();
        config.greatest_residual = 0;
        FirmwareBench bench(config);
        bench.pull(500, 0);
        QCOMPARE(int(bench.state.residual_um), 0);
        QVERIFY(!bench.has(status::unsure) && bench.drive.powered);
        bench.sensors.counts[1] += 10;
        bench.step();
        QVERIFY(bench.has(status::unsure) && !bench.drive.powered);
    }

    void the_least_spread_itself_is_no_singular_pose() {
        PadConfig config = pantograph_pad();
        config.least_spread = locate(config.bars, config.mark_angles).spread;
        FirmwareBench bench(config);
        bench.pull(500, 0);
        QVERIFY(!bench.has(status::singular) && !bench.has(status::limited));
        QVERIFY(bench.force() > 0.499);
        config.least_spread *= 1.0001f;
        FirmwareBench other(config);
        other.pull(500, 0);
        QVERIFY(other.has(status::singular) && other.has(status::limited));
        QCOMPARE(other.force(), 0.0);
    }

    /// Of two areas with one border each place is in one.
    void an_outline_has_its_left_and_lower_border_and_not_the_others() {
        for (const auto& [mark, inside] : {std::pair{Vec<float>{-100, 0}, true},
                                           {Vec<float>{100, 0}, false},
                                           {Vec<float>{0, -75}, true},
                                           {Vec<float>{0, 75}, false}}) {
            PadConfig config = cable_pad();
            config.mark = mark;
            FirmwareBench bench(config);
            bench.step();
            QVERIFY(bench.state.x_um == 1000 * static_cast<int>(mark.x));
            QVERIFY(bench.state.y_um == 1000 * static_cast<int>(mark.y));
            QCOMPARE(!bench.has(status::outside), inside);
        }
    }

    void any_outline_is_followed_from_corner_to_corner() {
        PadConfig config = cable_pad();
        const Vec<float> corners[] = {{-90, -60}, {80, -70}, {30, 0}, {90, 70}, {-60, 50}};
        config.corners = 5;
        std::copy(std::begin(corners), std::end(corners), config.outline);
        FirmwareBench bench(config);
        for (const auto& [x, y, inside] : {std::tuple{0.0, 0.0, true},
                                           {29.0, 0.0, true},
                                           {31.0, 0.0, false},
                                           {54.0, 36.0, true}, // the border is at x = 60.9
                                           {64.0, 36.0, false},
                                           {50.0, -36.0, true}, // at 55.7
                                           {58.0, -36.0, false},
                                           {-75.0, -5.0, true}, // at −75
                                           {-76.0, 0.0, false},
                                           {0.0, -66.0, false}, // below it at −65.3
                                           {0.0, -64.0, true},
                                           {0.0, 57.0, true}, // at 58
                                           {0.0, 59.0, false}}) {
            bench.move_to(x, y);
            bench.step();
            QVERIFY2(bench.has(status::outside) != inside, qPrintable(QString("%1 %2").arg(x).arg(y)));
        }
    }

    /// A reading that cannot be moves the knob 1.2 m in a millisecond, and ten metres are the end.
    void a_search_that_ran_away_comes_back() {
        FirmwareBench bench;
        bench.sensors.counts[0] = 1 << 30;
        double farthest = 0.0;
        double before = 0.0;
        for (int i = 0; i < 30; ++i) {
            bench.step();
            QVERIFY(bench.has(status::unsure));
            QVERIFY(place_mm(bench) <= before + 1201.0 || before > 8000.0);
            before = place_mm(bench);
            farthest = std::max(farthest, before);
        }
        QVERIFY2(farthest < 10000.0 && farthest > 8500.0, qPrintable(QString::number(farthest)));
        bench.move_to(10.0, -20.0);
        bench.step(12);
        QVERIFY(!bench.has(status::unsure));
        QVERIFY(std::abs(bench.state.x_um * 1e-3 - 10.0) < 0.01);
        QVERIFY(std::abs(bench.state.y_um * 1e-3 + 20.0) < 0.01);
    }

    void homing_ends_a_search_that_is_far_out() {
        FirmwareBench bench;
        bench.sensors.counts[0] = 1 << 30;
        bench.step(6);
        QVERIFY(place_mm(bench) > 5000.0);
        bench.pad.receive(encode(CalibrateFrame{}));
        bench.step();
        QVERIFY(!bench.has(status::unsure));
        QVERIFY(bench.state.x_um == 0 && bench.state.y_um == 0);
    }

    void what_does_not_fit_a_frame_is_told_as_the_most_that_does() {
        FirmwareBench bench(strong_pad());
        for (const auto& [x, y] : {std::pair{30000, 0}, {-30000, 0}, {0, 30000}, {0, -30000}}) {
            bench.pull(x, y);
            QVERIFY(std::abs(bench.state.force_x_mn - x) <= 3);
            QVERIFY(std::abs(bench.state.force_y_mn - y) <= 3);
        }
        bench.pull(-32768, 0);
        QVERIFY(bench.state.force_x_mn < -32760);
        constexpr double counts_per_mm = 4096.0 / (10.0 * 3.14159265358979);
        bench.sensors.counts[0] = static_cast<int32_t>(170.0 * counts_per_mm);
        bench.step();
        QVERIFY(bench.state.residual_um > 40000 && bench.state.residual_um < 60000);
        bench.sensors.counts[0] = static_cast<int32_t>(600.0 * counts_per_mm);
        bench.step();
        QCOMPARE(int(bench.state.residual_um), 65535);
    }

    /// Two angles cannot contradict each other.
    void a_pantograph_has_no_residual() {
        FirmwareBench bench(pantograph_pad());
        bench.step();
        QCOMPARE(int(bench.state.residual_um), 0);
    }

    /// Where it cannot make a force it makes the nearest and says so; where that is more than was asked for, none.
    void near_the_frame_it_says_what_it_cannot_make() {
        FirmwareBench bench;
        bench.move_to(0.0, 109.9);
        bench.pull(0, 0);
        QVERIFY(bench.has(status::armed) && bench.has(status::limited) && bench.has(status::singular));
        QVERIFY(!bench.drive.powered);
        QCOMPARE(bench.force(), 0.0);
        bench.pull(0, 1000); // against the frame, where no cable pulls
        QVERIFY(bench.has(status::limited) && !bench.has(status::singular));
        QVERIFY(bench.drive.powered);
        QVERIFY(bench.force() < 1.0);
        bench.move_to(0.0, 0.0);
        bench.pull(0, 1000);
        QVERIFY(!bench.has(status::limited) && !bench.has(status::singular));
    }

    /// All between two steps of the pad.
    void armed_anew_its_force_grows_from_none() {
        FirmwareBench bench;
        bench.pull(1000, 0);
        bench.pad.receive(encode(ForceFrame{++bench.sequence, 0, 0, false}));
        bench.ask_force(0, 0);
        bench.ask_force(1000, 0);
        bench.step();
        QVERIFY(bench.has(status::armed));
        QVERIFY(bench.force() < 0.102);
    }
};

} // namespace pad_limits_test

TP_TEST(pad_limits_test, PadLimitsTest, nothing)
#include "pad_limits_test.moc"
