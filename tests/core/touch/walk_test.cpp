// SPDX-License-Identifier: Apache-2.0
// A finger's walk through the loop: its ticks are the crossings that CrossingFinder finds, and none of it allocates.
#include "core/friction/crossing_finder.hpp"
#include "core/touch/touch_loop.hpp"
#include "counted_allocations.hpp"
#include "scenes.hpp"
#include "touch_output_double.hpp"

#include <QTest>

#include <atomic>
#include <thread>

using namespace tp;
using namespace tp::testing;

namespace {

Vec2 place_at(double t) { return {60.0 * std::sin(1.1 * t), 55.0 * std::cos(0.7 * t)}; }

} // namespace

class WalkTest : public QObject {
    Q_OBJECT
private slots:
    void each_step_that_crosses_ticks_and_no_other() {
        const FlatScene face = face_scene(60);
        TouchOutputDouble output;
        VirtualClock clock;
        TouchLoop loop(output, output.capabilities(), clock, {});
        loop.render(make_touch_scene(face).value());
        loop.engage();
        const CrossingFinder finder(face);
        StepCrossings crossings;
        Vec2 before = place_at(0.0);
        std::size_t all = 0;
        for (int i = 0; i < 200'000; ++i) {
            const Vec2 place = place_at(0.001 * i);
            clock.sleep_until(clock.now() + loop.period());
            loop.tell(place);
            const TouchSnapshot last = loop.snapshot();
            loop.tick();
            const TouchSnapshot view = loop.snapshot();
            crossings.clear();
            if (i > 0)
                finder.find(before, place, crossings);
            all += crossings.list().size();
            if (!crossings.list().empty()) {
                QVERIFY2(view.events >= last.events + crossings.list().size(),
                         qPrintable(QString::number(i)));
                QVERIFY2(view.ticks == last.ticks + 1, qPrintable(QString::number(i)));
            } else if (view.events > last.events) {
                QVERIFY2(view.event != LineEventKind::crossed, qPrintable(QString::number(i)));
            }
            before = place;
        }
        qInfo("%zu crossings", all);
        QVERIFY(all > 100);
    }

    void a_million_periods_allocate_nothing() {
        TouchOutputDouble output;
        VirtualClock clock;
        TouchLoop loop(output, output.capabilities(), clock, {});
        loop.engage();
        std::atomic<bool> stop{false};
        std::uint64_t swaps = 0;
        std::thread other([&] {
            for (; !stop; ++swaps) {
                auto scene = make_touch_scene(face_scene(60)).value();
                if (swaps % 3 == 0)
                    scene->tour = scene->flat.lines.front();
                loop.render(swaps % 5 == 4 ? nullptr : std::move(scene));
                loop.choose({0.5, 0.5});
                loop.set_latency(0.02);
            }
        });
        std::uint64_t ticks = 0;
        allocations = 0;
        counting = true;
        // The other thread may be kept from its work for a while, with nothing rendered: then there are more periods.
        for (int i = 0; i < 1'000'000 || (ticks <= 1000 && i < 50'000'000); ++i) {
            clock.sleep_until(clock.now() + loop.period());
            if (i % 100'000 == 0)
                loop.tell_lifted();
            else
                loop.tell(place_at(0.001 * i));
            loop.tick();
            ticks = loop.snapshot().ticks;
        }
        counting = false;
        stop = true;
        other.join();
        QVERIFY(swaps > 10);
        QVERIFY(ticks > 1000);
        QCOMPARE(allocations.load(), 0L);
    }
};

QTEST_APPLESS_MAIN(WalkTest)
#include "walk_test.moc"
