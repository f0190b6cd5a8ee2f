// SPDX-License-Identifier: Apache-2.0
#include "core/servo/velocity_filter.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace velocity_filter_test {

using namespace tp;

class VelocityFilterTest : public QObject {
    Q_OBJECT
private slots:
    void settles_on_a_steady_speed() {
        VelocityFilter filter(40.0);
        for (int i = 0; i < 200; ++i)
            filter.feed(0.001 * i, {0.05 * i, -0.02 * i});
        QVERIFY(length(filter.velocity() - Vec2(50.0, -20.0)) < 1e-6);
    }

    void a_handle_that_is_first_seen_far_out_does_not_seem_to_move() {
        VelocityFilter filter(40.0);
        QVERIFY(filter.velocity() == Vec2(0.0));
        filter.feed(5.0, {80.0, -40.0});
        QVERIFY(filter.velocity() == Vec2(0.0));
        filter.feed(5.001, {80.0, -40.0});
        QVERIFY(filter.velocity() == Vec2(0.0));
    }

    /// A step answers as a first-order low-pass of 40 Hz does: 1 − 1/e of it after 4 ms.
    void is_as_slow_as_its_cut_off_says() {
        for (const bool by_default : {false, true}) {
            VelocityFilter filter = by_default ? VelocityFilter() : VelocityFilter(40.0);
            filter.feed(0.0, {0.0, 0.0});
            const double period = 1.0 / (2.0 * std::numbers::pi * 40.0);
            filter.feed(period, {100.0 * period, 0.0});
            QVERIFY(std::abs(filter.velocity().x - 100.0 * (1.0 - std::exp(-1.0))) < 1e-9);
        }
    }

    void one_encoder_step_reads_as_less_than_a_quarter_of_the_raw_difference() {
        VelocityFilter filter(40.0);
        for (int i = 0; i < 100; ++i)
            filter.feed(0.001 * i, {0.0, 0.0});
        filter.feed(0.1, {0.09, 0.0});
        QVERIFY(filter.velocity().x < 0.25 * 90.0);
    }

    /// 200 mm/s at 1 kHz, and then no more readings: at twice the time between two readings it still holds; from
    /// there it falls as the low-pass of 40 Hz does, and after 20 ms there is none.
    void an_old_velocity_is_not_held() {
        VelocityFilter filter(40.0);
        double now = 0.0;
        for (int i = 0; i < 200; ++i) {
            now = 0.001 * i;
            filter.feed(now, {0.2 * i, 0.0});
            filter.elapse(now);
        }
        QVERIFY(std::abs(filter.velocity().x - 200.0) < 1e-6);
        for (int silent_ms = 1; silent_ms <= 40; ++silent_ms) {
            filter.elapse(now + 0.001 * silent_ms);
            const double overdue = 0.001 * std::max(0, silent_ms - 2);
            const double left =
                silent_ms > 20 ? 0.0 : 200.0 * std::exp(-2.0 * std::numbers::pi * 40.0 * overdue);
            QVERIFY2(std::abs(filter.velocity().x - left) < 1e-6, qPrintable(QString::number(silent_ms)));
            if (silent_ms == 20)
                QVERIFY(filter.velocity().x < 0.02 * 200.0);
        }
        now += 0.041; // the next reading says what came of the time between
        filter.feed(now, {0.2 * 199, 0.0});
        filter.elapse(now);
        QVERIFY(filter.velocity() == Vec2(0.0));
    }

    /// A reading each 4 ms, which a loop of 1 kHz asks for.
    void between_the_readings_of_a_slow_device_it_holds() {
        VelocityFilter filter(40.0);
        for (int ms = 0; ms < 400; ++ms) {
            if (ms % 4 == 0)
                filter.feed(0.001 * ms, {0.05 * ms, 0.0});
            filter.elapse(0.001 * ms);
            QVERIFY(ms < 200 || std::abs(filter.velocity().x - 50.0) < 1e-3);
        }
    }

    void ignores_what_is_not_newer_or_not_a_number() {
        VelocityFilter filter;
        filter.feed(0.0, {0.0, 0.0});
        filter.feed(0.001, {0.1, 0.0});
        const Vec2 before = filter.velocity();
        filter.feed(0.001, {5.0, 0.0});
        filter.feed(0.0005, {5.0, 0.0});
        filter.feed(0.002, {std::nan(""), 0.0});
        filter.feed(std::nan(""), {1.0, 0.0});
        QVERIFY(filter.velocity() == before);
    }
};

} // namespace velocity_filter_test

TP_TEST(velocity_filter_test, VelocityFilterTest, nothing)
#include "velocity_filter_test.moc"
