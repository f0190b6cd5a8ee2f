// SPDX-License-Identifier: Apache-2.0
// The ticking thread allocates nothing, over a million ticks with scene swaps and tours going on.
#include "core/servo/servo_loop.hpp"
#include "counted_allocations.hpp"
#include "device/simulated/simulated_device.hpp"
#include "scenes.hpp"

#include <QTest>

#include <atomic>
#include <thread>

using namespace tp;
using namespace tp::testing;

namespace {

std::unique_ptr<const HapticScene> face(bool tour, LawKind law, const Continuity& continuity = {}) {
    const FlatScene flat = face_scene(60);
    Scene scene{200.0, 200.0, {}};
    for (std::size_t i = 0; i < flat.lines.size(); ++i)
        scene.contours.push_back(contour_through(flat.names[i], flat.lines[i].points, flat.lines[i].closed));
    auto made = make_haptic_scene(scene, {}, law, continuity);
    std::unique_ptr<HapticScene> haptic = std::move(made).value();
    if (tour)
        haptic->tour = haptic->flat.lines.front();
    return haptic;
}

} // namespace

class AllocationTest : public QObject {
    Q_OBJECT
private slots:
    void the_counter_counts() {
        counting = true;
        const std::vector<int> something(100);
        counting = false;
        QVERIFY(allocations.exchange(0) > 0);
        QCOMPARE(something.size(), std::size_t(100));
    }

    void a_million_ticks_allocate_nothing() {
        VirtualClock clock;
        SimulatedDevice device(200.0, 200.0);
        const Capabilities can = *device.open();
        ServoLoop loop(device, can, clock, ServoSettings{});
        loop.render(face(false, LawKind::exact));
        loop.engage();

        std::atomic<bool> stop{false};
        std::uint64_t swaps = 0;
        std::thread other([&] {
            const Continuity softened[] = {{}, {0.4, 0.0, true}, {0.0, 0.4, false}};
            for (; !stop; ++swaps) {
                const bool tour = swaps % 3 == 0;
                loop.render(swaps % 5 == 4   ? nullptr
                            : swaps % 2 == 1 ? face(tour, LawKind::published)
                                             : face(tour, LawKind::exact, softened[swaps / 2 % 3]));
                device.move_pointer({60.0 * std::cos(0.1 * static_cast<double>(swaps)), 30.0});
            }
        });
        counting = true;
        for (int i = 0; i < 1'000'000; ++i) {
            clock.sleep_until(clock.now() + 0.001);
            loop.tick();
            loop.check();
        }
        counting = false;
        stop = true;
        other.join();
        QCOMPARE(loop.snapshot().ticks, std::uint64_t(1'000'000));
        QVERIFY(swaps > 10);
        QCOMPARE(allocations.load(), 0L);
    }
};

QTEST_APPLESS_MAIN(AllocationTest)
#include "allocation_test.moc"
