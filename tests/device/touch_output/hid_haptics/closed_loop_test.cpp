// SPDX-License-Identifier: Apache-2.0
// A finger walks over lines on a model pad and feels a tick at each, while everything goes wrong that can.
#include "../../closed_loop/fault_schedules.hpp"
#include "haptics_bench.hpp"

#include <QTest>

#include <cmath>

using namespace tp;
using tp::testing::any_trouble;
using tp::testing::HapticsBench;
using tp::testing::Trouble;

namespace {

enum Kind { drop, garble, cut, refuse, mute, deaf, unplugged, stalled, halted, trouble_kinds };

void set_trouble(HapticsBench& bench, const Trouble& trouble, bool on) {
    const double share = on ? trouble.size : 0.0;
    switch (trouble.kind) {
    case drop:
        bench.link.troubles.drop = share;
        break;
    case garble:
        bench.link.troubles.garble = share;
        break;
    case cut:
        bench.link.troubles.cut = share;
        break;
    case refuse:
        bench.link.troubles.refuse = share;
        break;
    case mute:
        bench.link.troubles.mute = on;
        break;
    case deaf:
        bench.link.troubles.deaf = on;
        break;
    case unplugged:
        bench.link.troubles.unplugged = on;
        break;
    case stalled:
        bench.writer_stalled = on;
        break;
    case halted:
        if (on)
            bench.pad.halt();
        break;
    default:
        break;
    }
}

/// Walks to and fro on a pad; a line every 3 mm.
struct Walker {
    HapticsBench& bench;
    int last = 0;
    unsigned long asked = 0;
    unsigned long delivered = 0;

    void tick() {
        const double x = 12.0 * std::sin(4.0 * bench.now);
        bench.model.touch(0, {x, 3.0});
        const unsigned long before = bench.link.sends();
        const bool stalled = bench.writer_stalled;
        bench.writer_stalled = true; // delivered below, so that whoever else sends is seen
        bench.tick();
        bench.writer_stalled = stalled;
        if (bench.touch && bench.touch->touched) {
            const int line = static_cast<int>(std::floor(bench.touch->place.x / 3.0));
            if (line != last) {
                ++asked;
                delivered += bench.pad.tick(Tick(0.7, 0.5, 0.02)) ? 1 : 0;
            }
            last = line;
        }
        sends_outside_the_writer += bench.link.sends() - before;
        if (!stalled)
            bench.pad.deliver();
    }
    unsigned long sends_outside_the_writer = 0;
};

} // namespace

class HapticsClosedLoopTest : public QObject {
    Q_OBJECT
private slots:
    void every_line_is_felt() {
        HapticsBench bench(1);
        QCOMPARE(bench.open(), std::string());
        Walker walker{bench};
        while (bench.now < 10.0)
            walker.tick();
        QVERIFY(walker.asked > 80);
        QCOMPARE(walker.delivered, walker.asked);
        bench.run(0.1);
        QCOMPARE(bench.model.ticks(), walker.asked);
    }

    /// Nothing waits, every tick ends by itself, nothing is felt after a halt, a stop or a loss, and what is not delivered is told.
    void random_troubles_never_hurt() {
        for (int number = tp::testing::first_schedule();
             number < tp::testing::first_schedule() + tp::testing::schedules(); ++number) {
            std::mt19937 random(static_cast<unsigned>(number));
            HapticsBench bench(static_cast<unsigned>(number % 2), static_cast<std::uint32_t>(random()));
            QCOMPARE(bench.open(), std::string());
            Walker walker{bench};
            constexpr int ticks = 1200;
            std::vector<Trouble> troubles(1 + random() % 4);
            for (Trouble& trouble : troubles)
                trouble = any_trouble(random, static_cast<int>(random() % trouble_kinds), ticks);
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
                felt_for = bench.model.felt() > 0.0 && bench.model.ticks() == heard ? felt_for + 1 : 0;
                heard = bench.model.ticks();
                QVERIFY2(felt_for <= 51, name);
                QVERIFY2(bench.model.waveform() != 0x1004, name);
                QVERIFY2(walker.sends_outside_the_writer == 0, name);
                if (bench.touch)
                    QVERIFY2(bench.can.pad->contains(bench.touch->place), name);
                if (bench.pad.lost())
                    QVERIFY2(!bench.pad.tick(Tick(1.0, 1.0, 0.05)) && !bench.pad.complaint().empty(), name);
            }
            const bool reached = !bench.link.troubles.unplugged && !bench.link.troubles.deaf &&
                                 bench.link.troubles.refuse == 0.0 && !bench.pad.lost();
            bench.pad.stop();
            bench.link.advance();
            bench.link.advance();
            if (reached)
                QVERIFY2(bench.model.felt() == 0.0, name);
            const unsigned long before = bench.model.ticks();
            for (int tick = 0; tick < 51; ++tick)
                walker.tick();
            QVERIFY2(bench.model.felt() == 0.0 && bench.model.ticks() == before, name);
        }
    }
};

QTEST_APPLESS_MAIN(HapticsClosedLoopTest)
#include "closed_loop_test.moc"
