// SPDX-License-Identifier: Apache-2.0
// A thumb walks over lines on model pads and feels a tick at each, while everything goes wrong that can.
#include "../../closed_loop/fault_schedules.hpp"
#include "../walking_finger.hpp"
#include "steam_bench.hpp"

#include <QTest>

#include <cstdint>
#include <random>
#include <vector>

using namespace tp;
using tp::testing::any_trouble;
using tp::testing::SteamBench;
using tp::testing::Trouble;
using tp::testing::Walker;

class SteamClosedLoopTest : public QObject {
    Q_OBJECT
private slots:
    void every_line_is_felt() {
        for (const steam::Kind kind : {steam::Kind::deck, steam::Kind::controller, steam::Kind::receiver}) {
            SteamBench bench(kind, 1);
            Walker<SteamBench> walker{bench};
            while (bench.now < 10.0)
                walker.tick();
            QVERIFY(walker.asked > 80);
            QCOMPARE(walker.delivered, walker.asked);
            bench.run(0.1);
            QCOMPARE(bench.model.ticks(), walker.asked);
        }
    }

    /// Nothing waits, every tick ends by itself, nothing is felt after a halt, a stop or a loss, and what is not delivered is told.
    void random_troubles_never_hurt() {
        for (int number = tp::testing::first_schedule();
             number < tp::testing::first_schedule() + tp::testing::schedules(); ++number) {
            std::mt19937 random(static_cast<unsigned>(number));
            const auto kind = static_cast<steam::Kind>(number % 3);
            SteamBench bench(kind, static_cast<unsigned>(number % 2), static_cast<std::uint32_t>(random()));
            QVERIFY2(bench.error.empty(), bench.error.c_str());
            Walker<SteamBench> walker{bench};
            constexpr int ticks = 1200;
            std::vector<Trouble> troubles(1 + random() % 4);
            for (Trouble& trouble : troubles)
                trouble = any_trouble(random, static_cast<int>(random() % tp::testing::trouble_kinds), ticks);
            const int stop_at = number % 4 == 0 ? static_cast<int>(random() % ticks) : ticks;
            const QByteArray name = "schedule " + QByteArray::number(number);
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
                QVERIFY2(bench.model.longest_ms() <= 50.001, name);
                QVERIFY2(walker.sends_outside_the_writer == 0, name);
                if (bench.touch)
                    QVERIFY2(bench.can.pad->contains(bench.touch->place), name);
                if (bench.pad.lost())
                    QVERIFY2(!bench.pad.tick(Tick(1.0, 1.0, 0.05)) && !bench.pad.complaint().empty(), name);
            }
            const bool reached = !bench.link.troubles.unplugged && !bench.link.troubles.deaf &&
                                 bench.link.troubles.refuse == 0.0 && bench.model.on() && !bench.pad.lost();
            bench.pad.stop();
            bench.link.advance();
            bench.link.advance();
            if (reached) {
                QVERIFY2(bench.felt() == 0.0, name);
                QVERIFY2(bench.model.imitates(), name);
            }
            const unsigned long before = bench.model.ticks();
            for (int tick = 0; tick < 51; ++tick)
                walker.tick();
            QVERIFY2(bench.felt() == 0.0 && bench.model.ticks() == before, name);
        }
    }
};

QTEST_APPLESS_MAIN(SteamClosedLoopTest)
#include "closed_loop_test.moc"
