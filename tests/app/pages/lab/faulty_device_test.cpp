// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/faulty_device.hpp"
#include "app/pages/lab/tick_tap.hpp"
#include "core/servo/servo_loop.hpp"
#include "device_double.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <functional>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

namespace faulty_device_test {

using namespace tp;
using tp::testing::DeviceDouble;

class FaultyDeviceTest : public QObject {
    Q_OBJECT
private slots:
    void without_faults_it_is_the_device() {
        DeviceDouble behind;
        behind.place = [](double now) { return Vec2(now, 2.0); };
        VirtualClock clock;
        FaultyDevice device(behind, clock);
        for (int i = 0; i < 100; ++i) {
            const auto reading = device.read(i);
            QVERIFY(reading && reading->position == Vec2(i, 2.0));
            QVERIFY(device.write(SafeForce{}));
        }
        QCOMPARE(behind.written.size(), std::size_t{100});
        QVERIFY(!device.lost() && !device.motors_off());
    }

    void it_drops_the_share_that_it_is_told_and_the_same_ones_each_time() {
        const auto run = [](double share) {
            DeviceDouble behind;
            VirtualClock clock;
            FaultyDevice device(behind, clock);
            device.drop = share;
            std::vector<bool> came;
            for (int i = 0; i < 10'000; ++i)
                came.push_back(device.read(i).has_value());
            return came;
        };
        const std::vector<bool> came = run(0.3);
        const auto count = std::count(came.begin(), came.end(), true);
        QVERIFY2(std::abs(count - 7000) < 200, qPrintable(QString::number(count)));
        QVERIFY(came == run(0.3));
        const std::vector<bool> none = run(1.0);
        QCOMPARE(std::count(none.begin(), none.end(), true), 0);
    }

    void every_fault_reaches_the_servo_by_its_name() {
        const std::vector<std::pair<Fault, std::function<void(FaultyDevice&)>>> faults{
            {Fault::stale_input, [](FaultyDevice& device) { device.silent = true; }},
            {Fault::motors_off, [](FaultyDevice& device) { device.its_motors_off = true; }},
            {Fault::device_lost, [](FaultyDevice& device) { device.unplugged = true; }},
            {Fault::device_lost, [](FaultyDevice& device) { device.refuses = true; }},
            {Fault::late_ticks, [](FaultyDevice& device) { device.hang_once(0.02); }},
            {Fault::stalled, [](FaultyDevice& device) { device.hang_once(0.2); }},
        };
        for (const auto& [expected, break_it] : faults) {
            DeviceDouble behind;
            VirtualClock clock;
            FaultyDevice device(behind, clock);
            ServoLoop loop(device, DeviceDouble::capabilities(), clock, {});
            loop.engage();
            const auto tick = [&] {
                clock.sleep_until(clock.now() + 0.001);
                loop.tick();
            };
            for (int i = 0; i < 100; ++i)
                tick();
            QCOMPARE(loop.snapshot().fault, Fault::none);
            break_it(device);
            Fault worst = Fault::none;
            for (int i = 0; i < 100; ++i) {
                tick();
                worst = std::max(worst, loop.snapshot().fault);
            }
            QCOMPARE(worst, expected);
        }
    }

    void motors_that_are_off_get_no_force_and_a_refused_force_halts_the_device() {
        DeviceDouble behind;
        VirtualClock clock;
        FaultyDevice device(behind, clock);
        device.refuses = true;
        QVERIFY(!device.write(SafeForce{}));
        QCOMPARE(behind.halts.load(), 1);
        QVERIFY(behind.written.empty());
    }

    void a_tap_hands_on_every_tick_once_in_order() {
        DeviceDouble behind;
        behind.place = [](double now) { return Vec2(3.0 * now, 0.0); };
        TickTap tap(behind);
        for (int i = 0; i < 5; ++i) {
            tap.read(i);
            tap.write(SafeForce{});
        }
        const std::vector<TickSample> samples = tap.take();
        QCOMPARE(samples.size(), std::size_t{5});
        for (int i = 0; i < 5; ++i) {
            QCOMPARE(samples[static_cast<std::size_t>(i)].time, double(i));
            QCOMPARE(samples[static_cast<std::size_t>(i)].place.x, 3.0 * i);
        }
        QVERIFY(tap.take().empty());
    }

    void a_write_of_the_watchdog_is_no_tick() {
        DeviceDouble behind;
        TickTap tap(behind);
        tap.read(0.0);
        std::thread([&] { tap.write(SafeForce{}); }).join();
        QVERIFY(tap.take().empty());
        tap.write(SafeForce{});
        tap.write(SafeForce{}); // on the way out, without a read
        QCOMPARE(tap.take().size(), std::size_t{1});
        QCOMPARE(behind.written.size(), std::size_t{3});
    }

    void a_page_that_does_not_come_loses_the_newest_ticks_and_nothing_else() {
        DeviceDouble behind;
        const auto tap = std::make_unique<TickTap>(behind);
        for (int i = 0; i < 20'000; ++i) {
            tap->read(i);
            tap->write(SafeForce{});
        }
        const std::vector<TickSample> samples = tap->take();
        QCOMPARE(samples.size(), std::size_t{16384});
        QCOMPARE(samples.back().time, 16383.0);
    }
};

} // namespace faulty_device_test

TP_TEST(faulty_device_test, FaultyDeviceTest, event_loop)
#include "faulty_device_test.moc"
