// SPDX-License-Identifier: Apache-2.0
// What becomes of scenes that were handed over, and what a page sees of the one that is felt.
#include "core/servo/servo_loop.hpp"
#include "device_double.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <memory>

namespace scene_change_test {

using namespace tp;
using tp::testing::DeviceDouble;

namespace {

/// Pulls to the left with half a newton wherever the finger is, and tells when it is gone.
class CountedLaw final : public GuidanceLaw {
public:
    explicit CountedLaw(int& alive) : alive_(alive) { ++alive_; }
    ~CountedLaw() override { --alive_; }
    Guidance at(Vec2) const noexcept override { return {.force = Vec2(-0.5, 0.0), .energy = 0.0}; }

private:
    int& alive_;
};

std::unique_ptr<const HapticScene> counted_scene(int& alive) {
    auto scene = std::make_unique<HapticScene>();
    scene->law = std::make_unique<CountedLaw>(alive);
    return scene;
}

struct Bench {
    DeviceDouble device;
    VirtualClock clock;
    ServoLoop loop;

    explicit Bench(const ServoSettings& settings = {})
        : loop(device, DeviceDouble::capabilities(), clock, settings) {}
    /// The sum of all forces, N.
    double run(double seconds) {
        double sum = 0.0;
        for (const double end = clock.now() + seconds; clock.now() < end - 1e-9;) {
            clock.sleep_until(clock.now() + 0.001);
            loop.tick();
            sum += length(device.last_force());
        }
        return sum;
    }
};

} // namespace

class SceneChangeTest : public QObject {
    Q_OBJECT
private slots:
    /// Hours of browsing through portraits: only the scene that is felt and the one that comes are kept.
    void scenes_that_the_servo_has_left_are_freed() {
        int alive = 0;
        {
            Bench bench;
            for (int i = 0; i < 50; ++i) {
                bench.loop.render(counted_scene(alive));
                QVERIFY(alive >= 1 && alive <= 2);
                bench.run(0.010);
            }
            for (int i = 0; i < 10; ++i) // none of which is felt: the servo stands still
                bench.loop.render(counted_scene(alive));
            QVERIFY(alive >= 2);
            bench.run(0.010);
            bench.loop.render(nullptr);
            bench.run(0.010);
            bench.loop.render(nullptr);
            QCOMPARE(alive, 0);
        }
        QCOMPARE(alive, 0);
    }

    void a_page_sees_the_force_to_either_side() {
        int alive = 0;
        Bench bench;
        bench.device.place = [](double) { return Vec2(7.0, -3.0); };
        bench.loop.render(counted_scene(alive));
        bench.loop.engage();
        bench.run(1.0);
        const ServoSnapshot view = bench.loop.snapshot();
        QVERIFY(length(view.force() - Vec2(-0.5, 0.0)) < 1e-9 && view.finger() == Vec2(7.0, -3.0));
        QVERIFY(view.gain == 1.0 && view.time == bench.clock.now());
        QVERIFY(std::isinf(view.distance) && view.contour == -1);
        QCOMPARE(view.ticks, std::uint64_t(1000));
    }

    /// Without a fade a new scene is there with the next tick, and what sampling leaks is paid back at once.
    void without_a_fade_the_whole_field_is_felt_from_the_first_tick() {
        ServoSettings settings;
        settings.scene_fade = 0.0;
        settings.line_damping_ratio = 0.0;
        const auto felt = [&](bool observer) {
            settings.energy_observer = observer;
            Bench bench(settings);
            bench.device.place = [](double now) { return Vec2(0.0, 1.0 + std::sin(60.0 * now)); };
            auto made =
                make_haptic_scene({200.0, 150.0, {contour_through("line", {{-80, 0}, {80, 0}}, false)}});
            bench.loop.render(std::move(made).value());
            bench.loop.engage();
            bench.run(1.0);
            return bench.run(0.5);
        };
        QVERIFY(std::abs(felt(true) - felt(false)) > 0.1);
    }

    /// A computer that slept in the middle of a tour: the leading place waits where it was.
    void a_tour_does_not_run_ahead_while_the_loop_stands_still() {
        const Scene line{200.0, 150.0, {contour_through("line", {{-80, 0}, {80, 0}}, false)}};
        std::unique_ptr<HapticScene> scene = std::move(make_haptic_scene(line)).value();
        scene->tour = scene->flat.lines.front();
        Bench bench;
        bench.device.place = [&](double) { return Vec2(-79.0, 0.0); };
        bench.loop.render(std::move(scene));
        bench.loop.engage();
        bench.run(0.15);
        const double before = bench.loop.snapshot().tour_progress;
        QVERIFY(before > 0.01);
        bench.clock.sleep_until(bench.clock.now() + 5.0);
        bench.loop.tick();
        QVERIFY(bench.loop.snapshot().tour_progress < before + 0.0021); // ten periods at 30 mm/s
    }

    /// The fastest that hands move is felt; what no hand does is not (SafetyLimits' own numbers).
    void the_limits_are_those_of_the_product() {
        const auto fault_at = [](const SafetyInput& input) {
            SafetyChain chain(SafetyLimits{}, DeviceDouble::capabilities(), 0.001);
            chain.engage(0.0);
            SafetyInput now = input;
            now.now = 0.001;
            now.fresh = true;
            chain.pass(now);
            return chain.fault();
        };
        SafetyInput input;
        input.velocity = {1499.0, 0.0};
        QCOMPARE(fault_at(input), Fault::none);
        input.velocity = {0.0, -1501.0};
        QCOMPARE(fault_at(input), Fault::over_speed);
        input.velocity = Vec2(0.0);
        input.position = {104.9, 0.0};
        QCOMPARE(fault_at(input), Fault::none);
        input.position = {105.1, 0.0};
        QCOMPARE(fault_at(input), Fault::outside_workspace);
    }
};

} // namespace scene_change_test

TP_TEST(scene_change_test, SceneChangeTest, nothing)
#include "scene_change_test.moc"
