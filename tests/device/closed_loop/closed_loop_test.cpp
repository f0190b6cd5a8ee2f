// SPDX-License-Identifier: Apache-2.0
#include "closed_loop_test.hpp"

#include "bench_judge.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>

Q_DECLARE_METATYPE(const tp::testing::StampTrouble*)

namespace tp::testing {

namespace {

/// The lowest and the highest that a handle was, mm above the line.
struct Span {
    double lowest = 1e9;
    double highest = -1e9;
    void add(double y) {
        lowest = std::min(lowest, y);
        highest = std::max(highest, y);
    }
};

} // namespace

Contour line_at(double y, Vec2 middle) {
    return contour_through("line", {{middle.x - 40.0, middle.y + y}, {middle.x + 40.0, middle.y + y}}, false);
}

void ClosedLoopTest::each_variant() const {
    QTest::addColumn<std::size_t>("variant");
    for (std::size_t i = 0; i < device_.variants.size(); ++i)
        QTest::newRow(device_.variants[i]) << i;
}

void ClosedLoopTest::each_variant_and(const std::vector<StampTrouble>& troubles) const {
    QTest::addColumn<std::size_t>("variant");
    QTest::addColumn<const StampTrouble*>("trouble");
    for (std::size_t i = 0; i < device_.variants.size(); ++i)
        for (const StampTrouble& trouble : troubles)
            QTest::addRow("%s, %s", device_.variants[i], trouble.name) << i << &trouble;
}

bool ClosedLoopTest::let_go(const LoopBench& bench) const {
    return bench.lets_go() || (device_.at_rest > 0.0 && length(bench.felt()) < device_.at_rest);
}

std::unique_ptr<LoopBench> ClosedLoopTest::held_above_a_line(std::size_t variant) const {
    std::unique_ptr<LoopBench> bench = device_.make(variant, {.held = Held::firmly}, 0, 1);
    if (!bench->loop)
        return bench;
    const Vec2 middle = bench->middle();
    bench->render({line_at(0.0, middle)});
    bench->place(middle + Vec2(0.0, 4.0));
    bench->run(1.0);
    return bench;
}

QString ClosedLoopTest::settles(std::size_t variant, const Handle& handle, unsigned delay_ms,
                                double start) const {
    const Settling& wanted = device_.settling;
    const auto bench = device_.make(variant, handle, delay_ms, 1);
    if (!bench->loop)
        return QString::fromStdString(bench->error);
    const Vec2 middle = bench->middle();
    bench->render({line_at(0.0, middle)});
    bench->place(middle + Vec2(0.0, 20.0)); // out of reach until the whole force is let in
    bench->run(0.6);
    bench->place(middle + Vec2(0.0, start));
    bench->run(wanted.unjudged);
    BenchJudge judge(device_, *bench, device_.slack(*bench, false));
    bench->after_tick = [&] { judge.judge(); };
    bench->run(4.0);
    Span span;
    bench->after_tick = [&] {
        judge.judge();
        span.add(bench->handle().y - middle.y);
    };
    bench->run(1.0);
    if (std::max(std::abs(span.lowest), std::abs(span.highest)) < wanted.farthest &&
        span.highest - span.lowest < wanted.to_and_fro && judge.complaint.isEmpty())
        return {};
    return QStringLiteral("%1 kg, %2 N, %3 ms, from %4 mm: %5 … %6 mm %7")
        .arg(handle.mass.value_or(0.0))
        .arg(handle.coulomb.value_or(0.0))
        .arg(delay_ms)
        .arg(start)
        .arg(span.lowest)
        .arg(span.highest)
        .arg(judge.complaint);
}

void ClosedLoopTest::a_released_handle_settles_on_the_line() {
    QFETCH(std::size_t, variant);
    const Settling& wanted = device_.settling;
    for (const unsigned delay_ms : {0u, 1u})
        for (const double mass : wanted.masses)
            for (const std::optional<double>& coulomb : wanted.coulombs)
                for (const double start : wanted.starts)
                    QCOMPARE(settles(variant, {.mass = mass, .coulomb = coulomb, .damping = wanted.damping},
                                     delay_ms, start),
                             QString());
}

void ClosedLoopTest::a_hand_is_led_across_from_line_to_line_within_all_limits() {
    QFETCH(std::size_t, variant);
    const auto bench = device_.make(variant, {.held = Held::firmly}, 0, 1);
    QVERIFY2(bench->loop, bench->error.c_str());
    const Vec2 middle = bench->middle();
    bench->render({line_at(4.0, middle), line_at(-4.0, middle)});
    bench->place(middle + Vec2(0.0, 6.0));
    bench->run(1.0);
    QCOMPARE(bench->loop->snapshot().contour, 0);
    BenchJudge judge(device_, *bench, device_.slack(*bench, false));
    Span force;
    bench->after_tick = [&] {
        judge.judge();
        force.add(bench->felt().y);
    };
    for (double y = 6.0; y > -6.0; y -= 0.03) { // 30 mm/s
        bench->move_hand(middle + Vec2(0.0, y));
        bench->tick();
    }
    QCOMPARE(bench->loop->snapshot().contour, 1);
    QVERIFY(force.highest > 0.4); // back to the first line, then on to the second
    QVERIFY(force.lowest < -0.25);
    QVERIFY2(judge.complaint.isEmpty(), qPrintable(judge.complaint));
}

void ClosedLoopTest::unplugged_in_mid_touch_a_reason_is_said_and_nothing_comes_back_by_itself() {
    QFETCH(std::size_t, variant);
    const auto bench = held_above_a_line(variant);
    QVERIFY2(bench->loop, bench->error.c_str());
    QVERIFY(length(bench->felt()) > 0.3);
    bench->unplugged() = true;
    bench->tick();
    QCOMPARE(bench->loop->snapshot().fault, Fault::device_lost);
    QVERIFY(bench->loop->snapshot().force() == Vec2(0.0));
    if (device_.watchdogs[variant] > 0.0) {
        bench->run(device_.watchdogs[variant]);
        QVERIFY(bench->lets_go());
    }
    bench->unplugged() = false;
    bench->run(1.0);
    QVERIFY(bench->loop->snapshot().force() == Vec2(0.0));
    QVERIFY(device_.watchdogs[variant] == 0.0 || bench->lets_go());
    QCOMPARE(bench->loop->snapshot().fault, Fault::device_lost);
}

void ClosedLoopTest::when_the_servo_stands_still_a_device_with_a_watchdog_lets_go() {
    QFETCH(std::size_t, variant);
    if (device_.watchdogs[variant] == 0.0)
        return;
    const auto bench = held_above_a_line(variant);
    QVERIFY2(bench->loop, bench->error.c_str());
    QVERIFY(length(bench->felt()) > 0.3);
    for (double t = 0.0; t < device_.watchdogs[variant]; t += 0.001)
        bench->pass(); // the writer lives, and has nothing new
    QVERIFY(bench->lets_go());
}

/// After a hand that went up at 200 mm/s. The force is gone 20 ms after the fault, and what is under way with it.
void ClosedLoopTest::readings_that_are_no_newer_take_the_force_away() {
    QFETCH(std::size_t, variant);
    QFETCH(const StampTrouble*, trouble);
    const auto bench = held_above_a_line(variant);
    QVERIFY2(bench->loop, bench->error.c_str());
    QVERIFY(length(bench->felt()) > 0.3);
    for (double y = 4.0; y > 0.5; y -= 0.2) {
        bench->move_hand(bench->middle() + Vec2(0.0, y));
        bench->tick();
    }
    bench->stamps().begin(trouble);
    BenchJudge judge(device_, *bench, device_.slack(*bench, false));
    bench->after_tick = [&] { judge.judge(); };
    bench->run(trouble->stale_within + bench->can.delay);
    QCOMPARE(bench->loop->snapshot().fault, Fault::stale_input);
    bench->run(0.021);
    for (int ms = 0; ms < 300; ++ms) {
        bench->run(0.001);
        QCOMPARE(bench->loop->snapshot().fault, Fault::stale_input);
        QVERIFY(bench->loop->snapshot().force() == Vec2(0.0));
        QVERIFY(ms < 4 || let_go(*bench) || device_.slack(*bench, false) > length(bench->felt()));
    }
    bench->stamps().begin(nullptr);
    bench->move_hand(bench->middle() + Vec2(0.0, 4.0));
    bench->run(1.0);
    QCOMPARE(bench->loop->snapshot().fault, Fault::none);
    QVERIFY(length(bench->felt()) > 0.3);
    QVERIFY2(judge.complaint.isEmpty(), qPrintable(judge.complaint));
}

/// The hand goes on at 50 mm/s meanwhile, and is seen where it is.
void ClosedLoopTest::a_clock_that_jumps_is_not_felt() {
    QFETCH(std::size_t, variant);
    QFETCH(const StampTrouble*, trouble);
    const auto bench = held_above_a_line(variant);
    QVERIFY2(bench->loop, bench->error.c_str());
    QVERIFY(length(bench->felt()) > 0.3);
    bench->stamps().begin(trouble);
    BenchJudge judge(device_, *bench, device_.slack(*bench, false));
    bench->after_tick = [&] { judge.judge(); };
    const auto seen_where_it_is = [&](int ms) {
        const double late = 1e-3 * (3 + trouble->blind) + 2.0 * bench->can.delay;
        const double off = length(bench->loop->snapshot().finger() - bench->handle());
        const Fault fault = bench->loop->snapshot().fault;
        QVERIFY2(fault == Fault::none, qPrintable(QString("fault %1 after %2 ms").arg(int(fault)).arg(ms)));
        QVERIFY2(off < 0.1 + 60.0 * late, qPrintable(QString("%1 mm after %2 ms").arg(off).arg(ms)));
    };
    for (int ms = 0; ms < 600; ++ms) {
        const double swing = 2.0 * std::sin(25.0 * 0.001 * ms); // 50 mm/s at most
        bench->move_hand(bench->middle() + Vec2(swing, 4.0 - std::abs(swing)));
        bench->tick();
        seen_where_it_is(ms);
        if (QTest::currentTestFailed())
            return;
    }
    QVERIFY2(judge.complaint.isEmpty(), qPrintable(judge.complaint));
}

void ClosedLoopTest::every_way_out_leaves_no_force() {
    QFETCH(std::size_t, variant);
    struct Way {
        const char* name;
        std::function<void(LoopBench&)> leave;
        bool motors_go_off; ///< and leave nothing at all
    };
    const std::vector<Way> ways{
        {"halt", [](LoopBench& bench) { bench.back_end().halt(); }, true},
        {"stop", [](LoopBench& bench) { bench.back_end().stop(); }, true},
        {"the loop's stop", [](LoopBench& bench) { bench.loop->stop(); }, true},
        {"Escape",
         [](LoopBench& bench) {
             bench.loop->disengage();
             bench.run(0.025);
         },
         false},
    };
    for (const auto& [name, leave, motors_go_off] : ways) {
        const auto bench = held_above_a_line(variant);
        QVERIFY2(bench->loop, bench->error.c_str());
        device_.lean(*bench);
        QVERIFY2(length(bench->felt()) > 0.3, name);
        leave(*bench);
        bench->pass();
        bench->pass();
        QVERIFY2(motors_go_off ? bench->lets_go() : let_go(*bench), name);
    }
}

void ClosedLoopTest::what_takes_the_force_away_is_told_and_it_comes_back_by_the_ramp_or_not_at_all_data() {
    QTest::addColumn<std::size_t>("what");
    for (std::size_t i = 0; i < device_.interruptions.size(); ++i)
        QTest::newRow(device_.interruptions[i].name) << i;
}

void ClosedLoopTest::what_takes_the_force_away_is_told_and_it_comes_back_by_the_ramp_or_not_at_all() {
    QFETCH(std::size_t, what);
    const Interruption& row = device_.interruptions[what];
    const auto bench = held_above_a_line();
    QVERIFY2(bench->loop, bench->error.c_str());
    device_.lean(*bench);
    QVERIFY(length(bench->felt()) > 0.3);
    const auto gone = [&] {
        return row.keeps_its_force ? bench->loop->snapshot().force() == Vec2(0.0) : bench->lets_go();
    };
    row.begin(*bench);
    bench->run(row.within);
    QVERIFY(gone());
    QCOMPARE(bench->loop->snapshot().fault, row.fault);
    const QString told = QString::fromStdString(bench->back_end().complaint());
    QVERIFY2(told.contains(QLatin1String(row.words)), qPrintable(told));
    bench->run(row.lasts);
    QVERIFY(gone());
    row.end(*bench);
    bench->run(0.002);
    QVERIFY(length(bench->felt()) < 0.1);
    BenchJudge judge(device_, *bench, device_.slack(*bench, false));
    bench->after_tick = [&] { judge.judge(); };
    if (row.back_after == 0.0) {
        judge.wanted = false; // what keeps it away was told when it went
        bench->run(1.0);
        QVERIFY(bench->lets_go());
    } else {
        bench->run(row.back_after);
        QVERIFY(length(bench->felt()) > 0.3);
        QCOMPARE(bench->back_end().complaint(), std::string());
    }
    QVERIFY2(judge.complaint.isEmpty(), qPrintable(judge.complaint));
}

} // namespace tp::testing
