// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "walking_finger.hpp"

#include <QTest>

#include <cstdint>
#include <random>
#include <type_traits>
#include <vector>

/// What is asked of every touch pad in the closed loop: a finger walks over lines on a model pad and feels a tick at each, while
/// everything goes wrong that can. What a bench is: walking_finger.hpp; it tells what its model does to a finger (`felt`), whether
/// that can hurt (`harmless`), and, of a pad that was told to stop, whether it could hear it (`listens`) and did (`let_go`).
namespace tp::testing {

template <typename Bench>
void judge_every_line(Bench& bench) {
    Walker<Bench> walker{bench};
    while (bench.now < 10.0)
        walker.tick();
    QVERIFY(walker.asked > 80);
    QCOMPARE(walker.delivered, walker.asked);
    bench.run(0.1);
    QCOMPARE(bench.model.ticks(), walker.asked);
}

/// Nothing waits, every tick ends by itself, nothing is felt after a halt, a stop or a loss, and what is not delivered is told.
/// `made(number, seed)` is the open bench of a schedule, null where it cannot be opened.
template <typename Made>
void judge_random_troubles(Made made) {
    for (int number = first_schedule(); number < first_schedule() + schedules(); ++number) {
        const QByteArray name = "schedule " + QByteArray::number(number);
        std::mt19937 random(static_cast<unsigned>(number));
        const auto owned = made(number, static_cast<std::uint32_t>(random()));
        QVERIFY2(owned != nullptr, name);
        auto& bench = *owned;
        Walker<std::remove_reference_t<decltype(bench)>> walker{bench};
        constexpr int ticks = 1200;
        std::vector<Trouble> troubles(1 + random() % 4);
        for (Trouble& trouble : troubles)
            trouble = any_trouble(random, static_cast<int>(random() % trouble_kinds), ticks);
        const int stop_at = number % 4 == 0 ? static_cast<int>(random() % ticks) : ticks;
        int felt_for = 0; // ms at a stretch
        unsigned long heard = 0;
        for (int tick = 0; tick < stop_at; ++tick) {
            for (const Trouble& trouble : troubles) {
                if (tick == trouble.from)
                    set_trouble(bench, trouble, true);
                if (tick == trouble.until)
                    set_trouble(bench, trouble, false);
            }
            walker.tick();
            felt_for = bench.felt() > 0.0 && bench.model.ticks() == heard ? felt_for + 1 : 0;
            heard = bench.model.ticks();
            QVERIFY2(felt_for <= 51, name);
            QVERIFY2(bench.harmless(), name);
            QVERIFY2(walker.sends_outside_the_writer == 0, name);
            if (bench.touch)
                QVERIFY2(bench.can.pad->contains(bench.touch->place), name);
            if (bench.pad.lost())
                QVERIFY2(!bench.pad.tick(Tick(1.0, 1.0, 0.05)) && !bench.pad.complaint().empty(), name);
        }
        const bool reached = bench.listens() && !bench.link.troubles.unplugged && !bench.link.troubles.deaf &&
                             bench.link.troubles.refuse == 0.0 && !bench.pad.lost();
        bench.pad.stop();
        bench.link.advance();
        bench.link.advance();
        if (reached)
            QVERIFY2(bench.felt() == 0.0 && bench.let_go(), name);
        const unsigned long before = bench.model.ticks();
        for (int tick = 0; tick < 51; ++tick)
            walker.tick();
        QVERIFY2(bench.felt() == 0.0 && bench.model.ticks() == before, name);
    }
}

} // namespace tp::testing
