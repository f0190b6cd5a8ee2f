// SPDX-License-Identifier: Apache-2.0
#include "core/servo/servo_loop.hpp"
#include "device/simulated/simulated_device.hpp"

#include <QTest>

#include <cmath>
#include <optional>
#include <utility>

using namespace tp;

namespace {

struct Bench {
    SimulatedDevice device;
    VirtualClock clock;
    Capabilities can = device.open().value();
    ServoLoop loop;

    explicit Bench(SimulatedPlant plant = {}, ServoSettings settings = {})
        : device(200.0, 150.0, plant), loop(device, can, clock, settings) {}
    void render(const Contour& contour, TentProfile profile = {}, const Continuity& continuity = {}) {
        auto made = make_haptic_scene(Scene{200.0, 150.0, {contour}}, profile, LawKind::exact, continuity);
        loop.render(std::move(made).value());
        loop.engage();
    }
    void run(double seconds) {
        const double end = clock.now() + seconds;
        while (clock.now() < end - 1e-9) {
            clock.sleep_until(clock.now() + 0.001);
            loop.tick();
        }
    }
    Vec2 finger() const { return loop.snapshot().finger(); }
};

const Contour horizontal = contour_through("line", {{-80.0, 0.0}, {80.0, 0.0}}, false);

/// Amplitude (mm) that is left `seconds` after a handle nobody holds was let go `start` mm beside a line.
double swing_of_released_handle(double stiffness, int delay, double mass, double start,
                                const ServoSettings& settings,
                                std::optional<double> told_damping = std::nullopt, double seconds = 5.0) {
    SimulatedPlant plant;
    plant.told_damping = told_damping;
    plant.mass = mass;
    plant.damping = 0.05;
    plant.hand_stiffness = 0.0;
    plant.hand_damping = 0.0;
    plant.quantum = 0.02;
    plant.delay_ticks = static_cast<std::size_t>(delay);
    Bench bench(plant, settings);
    bench.render(horizontal, {stiffness, 4.0});
    bench.device.place_finger({0.0, 20.0}); // out of reach until the whole force is let in
    bench.run(0.6);
    bench.device.place_finger({0.0, start});
    bench.run(seconds);
    double swing = 0.0;
    for (int i = 0; i < 1000; ++i) {
        bench.run(0.001);
        swing = std::max(swing, std::abs(bench.finger().y));
    }
    return swing;
}

} // namespace

class SimulatedDeviceTest : public QObject {
    Q_OBJECT
private slots:
    void while_it_is_stopped_its_finger_stands_still() {
        Bench bench;
        bench.device.place_finger({0.0, 20.0});
        bench.run(0.1);
        bench.device.move_pointer({0.0, 30.0});
        bench.run(0.01); // on its way
        const Vec2 on_its_way = bench.finger();
        bench.loop.stop();
        bench.clock.sleep_until(bench.clock.now() + 100.0);
        bench.loop.tick();
        QVERIFY(length(bench.finger() - on_its_way) < 1e-9);
        bench.run(1.0);
        QVERIFY(length(bench.finger() - Vec2(0.0, 30.0)) < 0.01);
    }

    /// The well of a corner cue adds its own stiffness to the tent's: the worst place for a released handle.
    void a_handle_released_beside_a_ticking_corner_comes_to_rest_data() {
        QTest::addColumn<double>("blend_mm");
        QTest::addColumn<double>("hold_mm");
        QTest::newRow("corner cue") << 0.0 << 0.0;
        QTest::newRow("with blending") << 0.4 << 0.0;
        QTest::newRow("with hysteresis") << 0.0 << 0.4;
    }
    void a_handle_released_beside_a_ticking_corner_comes_to_rest() {
        QFETCH(double, blend_mm);
        QFETCH(double, hold_mm);
        const Contour bent = contour_through("bent", {{-60, 0}, {0, 0}, {0, 60}}, false);
        for (const double stiffness : {0.2, 0.5})
            for (const double mass : {0.05, 0.2})
                for (const Vec2 start :
                     {Vec2(0.7, -0.9), Vec2(-1.0, 0.3), Vec2(3.0, -4.0), Vec2(-2.0, 2.0)}) {
                    SimulatedPlant plant;
                    plant.mass = mass;
                    plant.damping = 0.05;
                    plant.hand_stiffness = 0.0;
                    plant.hand_damping = 0.0;
                    plant.quantum = 0.02;
                    plant.delay_ticks = 2;
                    Bench bench(plant);
                    bench.render(bent, {stiffness, 4.0}, {hold_mm, blend_mm, true});
                    bench.device.place_finger({40.0, -40.0}); // out of reach until the force is let in
                    bench.run(0.6);
                    bench.device.place_finger(start);
                    bench.run(6.0);
                    const Vec2 rest = bench.finger();
                    double swing = 0.0;
                    for (int i = 0; i < 1000; ++i) {
                        bench.run(0.001);
                        swing = std::max(swing, length(bench.finger() - rest));
                    }
                    QVERIFY2(swing < 0.1,
                             qPrintable(QString("K %1 m %2: %3 mm").arg(stiffness).arg(mass).arg(swing)));
                }
    }

    /// Its clock is the servo's: a mouse that does not move leaves a finger that is looked at all the time.
    void a_mouse_at_rest_is_no_stale_reading() {
        Bench bench;
        bench.render(horizontal);
        bench.device.place_finger({0.0, 2.0});
        for (int i = 0; i < 600; ++i) {
            bench.run(0.1);
            QCOMPARE(bench.loop.snapshot().fault, Fault::none);
        }
        QCOMPARE(bench.device.read(70.0)->time, 70.0);
        QCOMPARE(bench.device.read(70.0)->time, 70.0); // the same reading
    }

    void the_finger_follows_the_pointer() {
        Bench bench;
        bench.device.place_finger({10.0, 20.0});
        bench.run(0.1);
        QVERIFY(length(bench.finger() - Vec2(10.0, 20.0)) < 1e-9);
        bench.device.move_pointer({40.0, -20.0});
        bench.run(2.0);
        QVERIFY(length(bench.finger() - Vec2(40.0, -20.0)) < 0.01);
    }

    void the_finger_is_drawn_into_the_line_while_the_pointer_passes_by() {
        Bench bench;
        bench.render(horizontal);
        bench.device.place_finger({-60.0, 5.0});
        bench.run(1.0);
        for (double x = -60.0; x < 60.0; x += 0.06) { // 60 mm/s along the line, 4 mm beside it
            bench.device.move_pointer({x, 4.0});
            bench.run(0.001);
        }
        QVERIFY(bench.finger().y < 2.0);
        QVERIFY(bench.finger().y > 0.5);
        QVERIFY(bench.loop.snapshot().force().y < -0.2);
    }

    void without_a_line_near_by_there_is_no_pull() {
        Bench bench;
        bench.render(horizontal);
        bench.device.place_finger({0.0, 30.0});
        bench.run(2.0);
        QVERIFY(length(bench.finger() - Vec2(0.0, 30.0)) < 1e-6);
    }

    void stays_inside_its_workspace() {
        Bench bench;
        bench.device.move_pointer({500.0, -500.0});
        bench.run(3.0);
        QVERIFY(length(bench.finger() - Vec2(100.0, -75.0)) < 1e-9);
    }

    void a_released_handle_comes_to_rest_on_the_line_data() {
        QTest::addColumn<double>("stiffness");
        QTest::addColumn<int>("delay");
        QTest::addColumn<double>("mass");
        for (const double stiffness : {0.2, 0.5})
            for (const int delay : {0, 1, 2})
                for (const double mass : {0.05, 0.2})
                    QTest::addRow("K %.1f N/mm, %d ticks of delay, %.2f kg", stiffness, delay, mass)
                        << stiffness << delay << mass;
    }
    void a_released_handle_comes_to_rest_on_the_line() {
        QFETCH(double, stiffness);
        QFETCH(int, delay);
        QFETCH(double, mass);
        for (const double start : {2.0, 4.0, 6.0, 7.8})
            QVERIFY(swing_of_released_handle(stiffness, delay, mass, start, {}) < 0.1);
    }

    void without_damping_and_observer_it_does_not() {
        ServoSettings bare;
        bare.energy_observer = false;
        bare.line_damping_ratio = 0.0;
        QVERIFY(swing_of_released_handle(0.2, 1, 0.05, 6.0, bare) > 1.0);
        // The observer alone holds what sampling and delay give, and no more: what is left is the device's own damping,
        // 0.05 N·s/m on 0.05 kg, with a time constant of 2 s.
        bare.energy_observer = true;
        QVERIFY(swing_of_released_handle(0.2, 1, 0.05, 6.0, bare, 0.0, 12.0) < 0.1);
    }

    /// Held where the pull is strongest until all of it is let in, and then let go: no energy but the spring's. With
    /// the force's change limited to 40 N/s these flew 30, 15, 8 and 37, 22, 14 mm.
    void a_handle_let_go_at_full_force_goes_no_farther_than_it_began() {
        for (const auto& [stiffness, range] : {std::pair{0.2, 8.0}, {0.5, 4.0}})
            for (const double mass : {0.05, 0.1, 0.2}) {
                SimulatedPlant plant;
                plant.mass = mass;
                plant.damping = 0.1;
                plant.hand_stiffness = 0.0;
                plant.hand_damping = 0.0;
                Bench bench(plant);
                bench.render(horizontal, {stiffness, range});
                bench.device.place_finger({0.0, range});
                bench.device.hold(true);
                bench.run(0.8);
                QVERIFY(std::abs(bench.loop.snapshot().force().y + std::min(1.5, stiffness * range)) < 1e-9);
                QCOMPARE(bench.finger().y, range);
                bench.device.hold(false);
                double farthest = 0.0;
                for (int i = 0; i < 6000; ++i) {
                    bench.run(0.001);
                    farthest = std::max(farthest, std::abs(bench.finger().y));
                }
                QVERIFY2(farthest <= range, qPrintable(QString("%1 mm").arg(farthest)));
                QVERIFY(std::abs(bench.finger().y) < 0.1);
            }
    }

    void coulomb_friction_holds_the_finger_where_the_force_is_small() {
        SimulatedPlant plant;
        plant.hand_stiffness = 0.0;
        plant.hand_damping = 0.0;
        plant.coulomb = 0.3;
        Bench bench(plant);
        bench.render(horizontal);
        bench.device.place_finger({0.0, 1.0}); // 0.2 N
        bench.run(3.0);
        QVERIFY(std::abs(bench.finger().y - 1.0) < 0.02);
    }

    void its_encoder_has_steps() {
        SimulatedPlant plant;
        plant.quantum = 0.25;
        Bench bench(plant);
        bench.device.place_finger({10.1, 20.2});
        bench.run(0.01);
        QCOMPARE(bench.finger().x, 10.0);
        QCOMPARE(bench.finger().y, 20.25);
    }

    void a_relaxed_hand_lets_itself_be_led_round_a_feature() {
        Bench bench;
        Contour square = contour_through("square", {{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}, true);
        auto made = make_haptic_scene(Scene{200.0, 150.0, {square}});
        auto scene = std::move(made).value();
        scene->tour = scene->flat.lines.front();
        bench.device.place_finger({-40.0, 0.0});
        bench.device.relax(true);
        bench.loop.render(std::move(scene));
        bench.loop.engage();
        double seconds = 0.0;
        double farthest = 0.0;
        while (!bench.loop.snapshot().tour_finished && seconds < 60.0) {
            bench.run(0.05);
            seconds += 0.05;
            if (bench.loop.snapshot().tour_progress > 0.05)
                farthest = std::max(farthest, bench.loop.snapshot().distance);
        }
        QVERIFY(bench.loop.snapshot().tour_finished);
        QVERIFY(farthest < 8.0);
        QVERIFY(seconds > 160.0 / 30.0);
    }
};

QTEST_APPLESS_MAIN(SimulatedDeviceTest)
#include "simulated_device_test.moc"
