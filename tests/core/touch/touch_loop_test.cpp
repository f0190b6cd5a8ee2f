// SPDX-License-Identifier: Apache-2.0
#include "core/touch/touch_loop.hpp"
#include "test_program.hpp"
#include "touch_bench.hpp"

#include <QTest>

#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace touch_loop_test {

using namespace tp;
using namespace tp::testing;

class TouchLoopTest : public QObject {
    Q_OBJECT
private slots:
    void a_line_that_is_crossed_ticks_once_and_there() {
        TouchBench bench;
        const double first = bench.go(-20.0, 20.0, 100.0);
        QCOMPARE(bench.output.tick_count.load(), std::size_t(1));
        QVERIFY(first >= 0.0 && first < 0.25);
        QVERIFY(bench.output.ticks[0] == Tick(0.7, 0.7, 0.008));
        const TouchSnapshot view = bench.loop->snapshot();
        QCOMPARE(view.ticks, std::uint64_t(1));
        QCOMPARE(view.event, LineEventKind::crossed);
        QCOMPARE(view.event_contour, 0);
        QCOMPARE(view.tick_amplitude, 0.7);
        QVERIFY(view.touched && view.engaged && !view.lost);
        QCOMPARE(bench.output.levels, std::size_t(0)); // it has only ticks
    }

    void the_last_event_is_known_until_there_is_another() {
        TouchBench bench;
        FlatScene two{{"far", "near"}, {upright_line(40.0).lines[0], upright_line(0.0).lines[0]}};
        bench.loop->render(make_touch_scene(two).value());
        for (double y = 0.0; y < 8.0; y += 0.1) {
            bench.loop->tell({0.5, y});
            bench.pass();
        }
        const TouchSnapshot view = bench.loop->snapshot();
        QVERIFY(view.events == 1 && view.event == LineEventKind::followed && view.event_contour == 1);
        QCOMPARE(bench.output.tick_count.load(), std::size_t(1));
    }

    void friction_is_felt_on_the_line_and_not_beside_it_or_at_rest() {
        TouchBench bench({}, TouchMeans::friction);
        bench.go(-20.0, -5.0, 100.0);
        QCOMPARE(bench.output.level, 0.0);
        bench.go(-5.0, 0.0, 100.0);
        QVERIFY(bench.output.level > 0.6 && bench.output.level <= 0.7);
        QCOMPARE(bench.loop->snapshot().level, bench.output.level);
        bench.rest(0.09);
        QVERIFY(bench.output.level > 0.6); // it may only be late
        bench.rest(0.02);
        QCOMPARE(bench.output.level, 0.0);
    }

    void a_tick_comes_as_much_earlier_as_the_output_is_late() {
        TouchSettings settings;
        settings.latency_s = 0.040;
        TouchBench bench(settings);
        const double first = bench.go(-40.0, 20.0, 100.0);
        QVERIFY(std::abs(first + 4.0) < 0.25); // 40 ms at 100 mm/s before the line
        bench.loop->set_latency(0.0);
        bench.loop->tell_lifted();
        bench.pass();
        QVERIFY(std::abs(bench.go(-40.0, 20.0, 100.0)) < 0.25);
    }

    void what_lies_ahead_is_bounded() {
        TouchSettings settings;
        settings.latency_s = 5.0;
        TouchBench bench(settings);
        const double first = bench.go(-60.0, 20.0, 300.0);
        QVERIFY(first > -10.5 && first < -9.0); // mm
        for (const double wrong : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
            bench.loop->set_latency(wrong);
            bench.loop->tell_lifted();
            bench.pass();
            QVERIFY(std::abs(bench.go(-40.0, 20.0, 100.0)) < 0.25);
        }
    }

    /// However late an output says that it is.
    void no_output_is_told_more_than_150_ms_before() {
        TouchSettings settings;
        settings.latency_s = 5.0;
        TouchBench bench(settings);
        QVERIFY(std::abs(bench.go(-20.0, 20.0, 20.0) + 3.0) < 0.25); // 150 ms at 20 mm/s
    }

    void a_place_that_is_no_number_is_passed_over() {
        TouchBench bench;
        bench.go(-20.0, -5.0, 100.0);
        const Vec2 before = bench.loop->snapshot().finger();
        const double nan = std::numeric_limits<double>::quiet_NaN();
        for (const Vec2 nowhere : {Vec2(nan, 0.0), Vec2(0.0, nan)}) {
            bench.loop->tell(nowhere);
            bench.pass();
            QVERIFY(bench.loop->snapshot().finger() == before);
        }
    }

    void before_a_finger_comes_nothing_is_known() {
        TouchBench bench;
        bench.loop->disengage();
        const TouchSnapshot none = bench.loop->snapshot(); // before the first period
        QVERIFY(none.time == 0.0 && none.level == 0.0 && none.scene == 0 && none.periods == 0);
        QVERIFY(!none.touched && !none.engaged && !none.lost && !none.touring && !none.tour_finished);
        bench.pass();
        const TouchSnapshot view = bench.loop->snapshot();
        QCOMPARE(bench.output.halts.load(), 0); // nothing was to be felt
        QVERIFY(view.finger() == Vec2(0.0) && view.leader() == Vec2(0.0));
        QVERIFY(view.distance == 0.0 && view.level == 0.0);
        QVERIFY(view.tick_time == 0.0 && view.tick_amplitude == 0.0 && view.tour_progress == 0.0);
        QVERIFY(view.periods == 1 && view.ticks == 0 && view.undelivered == 0 && view.events == 0);
        QVERIFY(view.scene == 1 && view.buttons == 0 && view.event_contour == -1);
        QVERIFY(!view.touched && !view.engaged && !view.lost && !view.touring && !view.tour_finished);
        const TouchCapabilities
            can; // an output that says nothing of itself is taken for one that is never late
        QVERIFY(can.delay == 0.0 && can.rate == 0.0 && can.shortest_s == 0.0 && !can.pad);
        const PadTouch touch;
        QVERIFY(touch.time == 0.0 && !touch.touched && touch.place == Vec2(0.0) && touch.buttons == 0);
    }

    void what_it_knows_of_itself() {
        TouchBench bench;
        bench.loop->tell({-5.0, 3.0});
        bench.pass();
        const TouchSnapshot view = bench.loop->snapshot();
        QCOMPARE(view.time, bench.clock.now());
        QVERIFY(view.finger() == Vec2(-5.0, 3.0));
        QVERIFY(std::abs(view.distance - 5.0) < 1e-9);
        QCOMPARE(view.periods, std::uint64_t(1));
        QCOMPARE(view.scene, std::uint64_t(1));
        QCOMPARE(view.events, std::uint64_t(0));
        QVERIFY(!view.touring && !view.tour_finished);
        QCOMPARE(bench.loop->place_to_command().count(), std::uint64_t(1));
        QVERIFY(std::abs(bench.loop->place_to_command().max() - bench.loop->period()) < 1e-9);
        bench.pass(); // with nothing new
        QCOMPARE(bench.loop->place_to_command().count(), std::uint64_t(1));
        bench.loop->tell_lifted();
        bench.pass();
        QVERIFY(bench.loop->snapshot().finger() == Vec2(-5.0, 3.0));
        QVERIFY(!bench.loop->snapshot().touched);
    }

    void a_finger_set_down_elsewhere_has_crossed_nothing() {
        TouchBench bench;
        bench.go(-20.0, -5.0, 100.0);
        bench.loop->tell_lifted();
        bench.pass();
        QVERIFY(!bench.loop->snapshot().touched);
        QVERIFY(bench.output.halts > 0);
        bench.go(5.0, 20.0, 100.0);
        QCOMPARE(bench.output.tick_count.load(), std::size_t(0));
        bench.loop->tell_set_down({-5.0, 0.0}); // a lift that nobody told of
        bench.pass();
        bench.go(-5.0, -2.0, 100.0);
        QCOMPARE(bench.output.tick_count.load(), std::size_t(0));
    }

    /// Nor does it come from where it was before, so that it would be thought to be fast.
    void a_finger_set_down_elsewhere_rests() {
        for (const bool told : {true, false}) {
            TouchSettings settings;
            settings.latency_s = 0.040;
            TouchBench bench(settings);
            bench.go(-30.0, -20.0, 100.0);
            if (told) {
                bench.loop->tell_lifted();
                bench.pass();
            }
            bench.loop->tell_set_down({-2.0, 0.0});
            for (int i = 0; i < 20; ++i) {
                bench.pass();
                bench.loop->tell({-2.0, 0.0});
            }
            QCOMPARE(bench.output.tick_count.load(), std::size_t(0));
        }
    }

    void nobody_engaged_feels_nothing() {
        TouchBench bench({}, TouchMeans::friction);
        bench.go(-20.0, 0.0, 100.0);
        QVERIFY(bench.output.level > 0.5);
        bench.loop->disengage();
        bench.pass();
        QCOMPARE(bench.output.level, 0.0);
        QCOMPARE(bench.output.halts.load(), 1);
        bench.go(0.0, 1.0, 100.0);
        QCOMPARE(bench.output.level, 0.0);
        QCOMPARE(bench.output.halts.load(), 1); // once is enough
        QVERIFY(!bench.loop->snapshot().engaged);
    }

    void nobody_is_engaged_at_first() {
        TouchOutputDouble output;
        VirtualClock clock;
        TouchLoop loop(output, output.capabilities(), clock, {});
        loop.render(line_at(0.0));
        for (double x = -5.0; x < 5.0; x += 0.1) {
            loop.tell({x, 0.0});
            clock.sleep_until(clock.now() + loop.period());
            loop.tick();
        }
        QCOMPARE(output.tick_count.load(), std::size_t(0));
        QVERIFY(!loop.snapshot().engaged);
    }

    void what_a_finger_passed_while_nothing_was_felt_it_has_not_crossed() {
        TouchBench bench;
        bench.go(-20.0, -5.0, 100.0);
        bench.loop->disengage();
        bench.pass();
        bench.loop->tell({5.0, 0.0});
        bench.pass();
        bench.loop->engage();
        bench.go(5.0, 20.0, 100.0);
        QCOMPARE(bench.output.tick_count.load(), std::size_t(0));
    }

    void a_lost_output_is_told_and_left_alone() {
        TouchBench bench;
        bench.go(-20.0, -5.0, 100.0);
        bench.output.unplugged = true;
        bench.go(-5.0, 20.0, 100.0);
        QVERIFY(bench.loop->snapshot().lost);
        QCOMPARE(bench.output.tick_count.load(), std::size_t(0));
        bench.loop->feel({1.0, 1.0, 0.01});
        bench.pass();
        QCOMPARE(bench.output.tick_count.load(), std::size_t(0));
        bench.output.unplugged = false; // nothing comes back by itself
        bench.go(-20.0, 20.0, 100.0);
        QVERIFY(bench.loop->snapshot().lost);
        QCOMPARE(bench.output.tick_count.load(), std::size_t(0));
    }

    void what_the_output_refuses_is_counted() {
        TouchBench bench;
        bench.output.refuses = true;
        bench.go(-20.0, 20.0, 100.0);
        QCOMPARE(bench.loop->snapshot().undelivered, std::uint64_t(1));
        QCOMPARE(bench.loop->snapshot().ticks, std::uint64_t(0));
        TouchBench brake({}, TouchMeans::friction);
        brake.output.refuses = true;
        brake.loop->tell({30.0, 0.0});
        brake.pass();
        QCOMPARE(brake.loop->snapshot().undelivered, std::uint64_t(1));
    }

    void choices_hold_at_once() {
        TouchBench bench;
        bench.loop->choose({0.3, 0.2});
        bench.go(-20.0, 20.0, 100.0);
        QVERIFY(bench.output.ticks[0] == Tick(0.3, 0.2, 0.008));
    }

    void a_tick_to_try_comes_once_also_where_nobody_is_engaged() {
        TouchBench bench;
        bench.loop->disengage();
        for (const std::size_t count : {std::size_t(1), std::size_t(2)}) {
            bench.pass();
            const double asked = bench.clock.now();
            bench.loop->feel({0.9, 0.1, 0.02});
            bench.rest(0.05);
            QCOMPARE(bench.output.tick_count.load(), count);
            QVERIFY(bench.output.ticks[count - 1] == Tick(0.9, 0.1, 0.02));
            QVERIFY(std::abs(bench.loop->snapshot().tick_time - asked - bench.loop->period()) < 1e-9);
        }
    }

    void a_pad_tells_its_place_and_its_lift() {
        TouchOutputDouble output;
        double x = -4.0;
        bool touched = true;
        output.pad = [&](double now) {
            PadTouch touch;
            touch.time = now;
            touch.touched = touched;
            touch.place = {x, 0.0};
            touch.buttons = 1;
            return std::optional(touch);
        };
        VirtualClock clock;
        TouchSettings settings;
        settings.pad_to_surface.linear *= 5.0;
        TouchLoop loop(output, output.capabilities(), clock, settings);
        loop.render(line_at(10.0));
        loop.engage();
        for (; x < 4.0; x += 0.02) {
            clock.sleep_until(clock.now() + loop.period());
            loop.tick();
            QCOMPARE(loop.snapshot().ticks, std::uint64_t(x > 2.0 ? 1 : 0));
        }
        QVERIFY(std::abs(loop.snapshot().x - 20.0) < 0.2);
        QCOMPARE(loop.snapshot().buttons, std::uint32_t(1));
        touched = false;
        clock.sleep_until(clock.now() + loop.period());
        loop.tick();
        QVERIFY(!loop.snapshot().touched);
    }

    void no_scene_is_nothing_and_another_one_is_felt_at_once() {
        TouchBench bench;
        bench.loop->render(nullptr);
        bench.go(-20.0, 20.0, 100.0);
        QCOMPARE(bench.output.tick_count.load(), std::size_t(0));
        QCOMPARE(bench.loop->render(line_at(30.0)), std::uint64_t(3));
        bench.go(20.0, 40.0, 100.0);
        QCOMPARE(bench.output.tick_count.load(), std::size_t(1));
        QCOMPARE(bench.loop->snapshot().scene, std::uint64_t(3));
    }

    void stopping_switches_off_and_releases() {
        TouchBench bench({}, TouchMeans::friction);
        bench.go(-20.0, 0.0, 100.0);
        bench.loop->stop();
        QCOMPARE(bench.output.level, 0.0);
        QCOMPARE(bench.output.stops, 1);
        QCOMPARE(bench.loop->snapshot().level, 0.0);
        QVERIFY(!bench.loop->snapshot().engaged);
        QVERIFY(bench.output.halts > 0);
        const int halts = bench.output.halts;
        bench.loop->disengage();
        bench.pass();
        QCOMPARE(bench.output.halts.load(), halts); // there is nothing more to be halted
    }

    void one_that_goes_away_leaves_nothing_to_be_felt() {
        TouchBench bench({}, TouchMeans::friction);
        bench.go(-20.0, 0.0, 100.0);
        QVERIFY(bench.output.level > 0.5);
        bench.loop.reset();
        QCOMPARE(bench.output.level, 0.0);
        QCOMPARE(bench.output.stops, 1);
    }

    void a_place_never_waits_longer_than_two_milliseconds() {
        for (const double rate : {0.0, -1.0, 60.0, 300.0, std::numeric_limits<double>::quiet_NaN()})
            QCOMPARE(touch_rate(rate), 500.0);
        QCOMPARE(touch_rate(800.0), 800.0);
        QCOMPARE(touch_rate(1e9), 1000.0);
    }

    void a_scene_without_a_contour_is_refused() {
        QCOMPARE(make_touch_scene({}).error(), std::string("The scene has no line that can be felt."));
        FrictionChoices choices;
        choices.width_mm = -1.0;
        QCOMPARE(make_touch_scene(upright_line(0.0), choices).error(), choices.problem());
    }

    /// What was missed is not made up for in a burst.
    void after_a_late_period_its_thread_goes_on_in_step() {
        TouchOutputDouble output;
        VirtualClock clock;
        std::vector<double> times;
        std::atomic<bool> seen{false};
        output.pad = [&](double now) {
            if (times.size() < 40)
                times.push_back(now);
            else
                seen.store(true);
            if (times.size() == 10)
                clock.sleep_until(now + 2.65 * (times[1] - times[0]));
            return std::optional<PadTouch>();
        };
        TouchLoop loop(output, output.capabilities(), clock, {});
        loop.start();
        QTRY_VERIFY(seen.load());
        loop.stop();
        QCOMPARE(loop.snapshot().scene, std::uint64_t(0)); // none was handed over
        for (std::size_t i = 1; i < times.size(); ++i)
            QVERIFY2(std::abs(times[i] - times[i - 1] - (i == 10 ? 3.0 : 1.0) * loop.period()) < 1e-9,
                     qPrintable(QString::number(static_cast<int>(i))));
        QVERIFY(loop.lateness().count() >= 40);
        QVERIFY(loop.lateness().max() < 1e-9);
    }

    void its_own_thread_ticks_until_it_is_stopped() {
        TouchOutputDouble output;
        SteadyClock clock;
        TouchLoop loop(output, output.capabilities(), clock, {});
        loop.feel({1.0, 1.0, 0.01});
        loop.start();
        loop.start(); // goes on
        QVERIFY(loop.running());
        QTRY_COMPARE(output.tick_count.load(), std::size_t(1));
        loop.stop();
        QVERIFY(!loop.running());
    }
};

} // namespace touch_loop_test

TP_TEST(touch_loop_test, TouchLoopTest, nothing)
#include "touch_loop_test.moc"
