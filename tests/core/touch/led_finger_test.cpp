// SPDX-License-Identifier: Apache-2.0
// A finger that is led along a way.
#include "test_program.hpp"
#include "touch_bench.hpp"

#include <QTest>

#include <cmath>
#include <cstddef>
#include <utility>

namespace led_finger_test {

using namespace tp;
using namespace tp::testing;

class LedFingerTest : public QObject {
    Q_OBJECT
private slots:
    void a_tour_ticks_more_strongly_toward_the_leading_place_and_ends() {
        TouchBench bench;
        bench.loop->tell({0.0, -80.0});
        bench.pass();
        bench.loop->render(line_at(0.0, true));
        const auto last = [&bench] { return bench.loop->snapshot().tick_amplitude; };
        bench.rest(2.0); // the finger stays behind
        QVERIFY(bench.loop->snapshot().touring);
        const std::size_t evenly = bench.output.tick_count;
        QVERIFY(evenly >= 9 && evenly <= 11);
        const double behind = last();
        bench.loop->tell({TickLead::reach_mm, -80.0}); // it goes away
        bench.rest(1.0);
        const double away = last();
        QVERIFY(away > 0.0 && away < 0.5 * behind);
        bench.loop->tell({0.0, -80.0});
        bench.rest(1.0);
        QCOMPARE(last(), behind);
        for (int i = 0; i < 10'000 && !bench.loop->snapshot().tour_finished; ++i) {
            const TouchSnapshot view = bench.loop->snapshot();
            bench.loop->tell(view.finger() + 0.2 * (view.leader() - view.finger()));
            bench.pass();
        }
        QVERIFY(bench.loop->snapshot().tour_finished && !bench.loop->snapshot().touring);
        QCOMPARE(bench.loop->snapshot().tour_progress, 1.0);
        QVERIFY(last() > behind);
        const std::size_t given = bench.output.tick_count;
        bench.rest(1.0);
        QCOMPARE(bench.output.tick_count.load(), given);
    }

    void what_leads_is_told_with_both_of_its_coordinates() {
        TouchBench bench;
        bench.loop->tell({5.0, -80.0});
        bench.pass();
        QVERIFY(bench.loop->snapshot().leader() == Vec2(0.0)); // nothing leads
        bench.loop->render(line_at(5.0, true));
        bench.pass();
        const Vec2 leader = bench.loop->snapshot().leader();
        QCOMPARE(leader.x, 5.0);
        QVERIFY(leader.y >= -80.0 && leader.y < -79.0);
    }

    /// As when the machine has stood still.
    void a_late_period_leads_nobody_far() {
        TouchBench bench;
        bench.loop->tell({0.0, -80.0});
        bench.pass();
        bench.loop->render(line_at(0.0, true));
        bench.pass();
        const Vec2 before = bench.loop->snapshot().leader();
        bench.clock.sleep_until(bench.clock.now() + 5.0);
        bench.loop->tick();
        const double way = length(bench.loop->snapshot().leader() - before);
        QVERIFY2(std::abs(way - 0.3) < 0.01, qPrintable(QString::number(way))); // of ten periods at 30 mm/s
    }

    /// As after an hour of the program: the clock does not begin with the loop.
    void the_first_period_leads_as_far_as_each() {
        TouchOutputDouble output;
        VirtualClock clock;
        clock.sleep_until(3600.0);
        TouchLoop loop(output, output.capabilities(), clock, {});
        loop.render(line_at(0.0, true));
        loop.engage();
        loop.tell({0.0, -80.0});
        for (int i = 1; i <= 3; ++i) {
            clock.sleep_until(clock.now() + loop.period());
            loop.tick();
            const double way = loop.snapshot().leader().y + 80.0;
            QVERIFY2(std::abs(way - 30.0 * i * loop.period()) < 1e-9, qPrintable(QString::number(way)));
        }
    }

    void without_a_way_nobody_is_led() {
        TouchBench bench;
        bench.loop->tell({-5.0, 0.0});
        auto scene = make_touch_scene(upright_line(0.0)).value();
        scene->tour.emplace();
        bench.loop->render(std::move(scene));
        bench.pass();
        QVERIFY(!bench.loop->snapshot().touring);
        bench.loop->render(line_at(0.0, true));
        bench.pass();
        QVERIFY(bench.loop->snapshot().touring);
        bench.loop->render(line_at(0.0)); // and no more
        bench.pass();
        QVERIFY(!bench.loop->snapshot().touring);
        const std::size_t before = bench.output.tick_count;
        bench.go(-5.0, 5.0, 100.0);
        QCOMPARE(bench.output.tick_count.load(), before + 1);
    }

    void nobody_is_led_while_the_finger_is_up() {
        TouchBench bench;
        bench.loop->tell({0.0, -80.0});
        bench.pass();
        bench.loop->render(line_at(0.0, true));
        bench.loop->tell_lifted();
        bench.rest(1.0);
        QCOMPARE(bench.output.tick_count.load(), std::size_t(0));
        QCOMPARE(bench.loop->snapshot().tour_progress, 0.0);
    }
};

} // namespace led_finger_test

TP_TEST(led_finger_test, LedFingerTest, nothing)
#include "led_finger_test.moc"
