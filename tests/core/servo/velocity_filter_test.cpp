// SPDX-License-Identifier: Apache-2.0
#include "core/servo/velocity_filter.hpp"

#include <QTest>

#include <cmath>
#include <numbers>

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

QTEST_APPLESS_MAIN(VelocityFilterTest)
#include "velocity_filter_test.moc"
