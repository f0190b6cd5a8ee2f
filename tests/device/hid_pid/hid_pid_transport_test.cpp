// SPDX-License-Identifier: Apache-2.0
// A force stick through the real hidapi, with a device made by umockdev.
#include "../usb/wire_bench.hpp"
#include "device/hid_pid/hid_pid_transport.hpp"
#include "device/registry.hpp"
#include "mock_joystick.hpp"
#include "stranger.hpp"

#include <QTest>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace tp;
using mock::JoystickBed;

namespace {

/// The guard's time is not the simulated one: none stands beside this stick.
class UnhurriedTransport final : public tp::testing::BorrowedJoystickLink {
public:
    explicit UnhurriedTransport(std::unique_ptr<PidTransport> transport)
        : BorrowedJoystickLink(*transport), transport_(std::move(transport)) {}
    Result<std::unique_ptr<ForceGuard>> guard(std::span<const hid::Report>,
                                              std::span<const hid::Report>) override {
        return std::unique_ptr<ForceGuard>(std::make_unique<SimulatedGuard>(diary_));
    }

private:
    std::unique_ptr<PidTransport> transport_;
    GuardDiary diary_;
};

Result<std::unique_ptr<PidTransport>> open_unhurried(const FoundJoystick& stick) {
    auto opened = open_joystick(stick, {});
    if (!opened.ok())
        return Error{opened.error()};
    return std::unique_ptr<PidTransport>(std::make_unique<UnhurriedTransport>(std::move(opened).value()));
}

/// The only stick that is found, behind the real hidapi. An answer is that it took a force.
struct FoundJoystickBench : testing::WireBench<PidJoystick> {
    explicit FoundJoystickBench(JoystickBed& bed) : WireBench([&bed] { return bed.taken(); }) {
        const std::vector<FoundJoystick> found = find_joysticks();
        if (found.size() == 1)
            begin(std::make_unique<PidJoystick>(
                [one = found.front()] { return open_unhurried(one); },
                PidJoystick::Identity{found.front().product, found.front().serial_number},
                JoystickScale{8.0, {-1.0, -1.0}, true}));
        else
            error = "found " + std::to_string(found.size());
    }
};

} // namespace

class HidPidTransportTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        const JoystickBed bed;
        QVERIFY2(umockdev_in_mock_environment() != FALSE, "needs umockdev's preloaded library");
    }

    void a_joystick_is_found_listed_and_draws_its_grip_to_a_line() {
        JoystickBed bed;
        QVERIFY(find_joysticks().empty());
        QVERIFY(bed.plug_in()); // late arrival: it was not there a moment ago
        const std::vector<FoundJoystick> found = find_joysticks();
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found.front().serial_number, std::string("FS-0001"));
        QCOMPARE(found.front().product, std::string("force stick"));
        const std::vector<ListedDevice> listed = list_devices();
        QCOMPARE(listed.size(), std::size_t(2));
        QCOMPARE(listed.back().name, std::string("stick:FS-0001"));
        QCOMPARE(listed.back().interface, std::string("hid"));
        FoundJoystickBench bench(bed);
        QVERIFY2(bench.loop, bench.error.c_str());
        QCOMPARE(bed.effects(), std::size_t(2));
        for (int i = 0; i < 1000; ++i)
            bench.tick();
        const ServoSnapshot view = bench.loop->snapshot();
        QCOMPARE(view.fault, Fault::none);
        QVERIFY(std::abs(view.x - 10.0) < 0.2);
        QVERIFY2(view.y < 2.0, qPrintable(QString::number(view.y))); // drawn to the line
        bench.loop->stop();
        while (bed.effects() > 0) // CTest ends a test that waits for ever
            std::this_thread::yield();
        QVERIFY(bed.force() == Vec2(0.0));
    }

    void what_the_stick_does_not_answer_is_told() {
        JoystickBed bed;
        QVERIFY(bed.plug_in());
        const std::vector<FoundJoystick> found = find_joysticks();
        QCOMPARE(found.size(), std::size_t(1));
        const auto opened = open_joystick(found.front(), {});
        QVERIFY2(opened.ok(), opened.error().c_str());
        hid::Report report;
        report.bytes[0] = 0x12;
        report.size = 5;
        QVERIFY((*opened)->get_feature(report));
        QCOMPARE(int(report.bytes[2]), 3); // nothing was loaded yet
        report.bytes[0] = 0x7F;
        report.size = 5;
        QVERIFY(!(*opened)->get_feature(report));
    }

    void a_signal_takes_the_force_away_without_hidapi() {
        HandlePlant held;
        held.hand_stiffness = 0.5;
        held.hand_damping = 5.0;
        JoystickBed bed(plain_controller(), {}, held);
        QVERIFY(bed.plug_in());
        FoundJoystickBench bench(bed);
        QVERIFY2(bench.loop, bench.error.c_str());
        for (int i = 0; i < 300; ++i)
            bench.tick();
        QVERIFY(length(bed.force()) > 0.05);
        const long before = bed.taken();
        bench.device->halt();
        while (bed.taken() < before + 2 || bed.force() != Vec2(0.0))
            std::this_thread::yield();
    }

    void unplugged_in_mid_touch_it_is_lost_and_everything_ends() {
        JoystickBed bed;
        QVERIFY(bed.plug_in());
        FoundJoystickBench bench(bed);
        QVERIFY2(bench.loop, bench.error.c_str());
        for (int i = 0; i < 300; ++i)
            bench.tick();
        QCOMPARE(bench.loop->snapshot().fault, Fault::none);
        bed.unplug();
        bench.until([&] { return bench.loop->snapshot().fault == Fault::device_lost; });
        QVERIFY(bench.loop->snapshot().force() == Vec2(0.0));
        bench.loop->stop();
        QVERIFY(!bench.device->write(SafeForce{}));
    }

    void another_device_with_the_same_ids_is_no_joystick() {
        const std::vector<std::uint8_t> gamepad = tp::testing::bytes_of(tp::testing::dragonrise_gamepad.hex);
        JoystickBed bed(plain_controller(), gamepad);
        QVERIFY(bed.plug_in());
        QVERIFY(find_joysticks().empty());
        QCOMPARE(list_devices().size(), std::size_t(1));
    }
    void one_that_only_rumbles_is_told_why_it_cannot_be_used() {
        const std::vector<std::uint8_t> rumbles = tp::testing::bytes_of(tp::testing::saitek_rumble_pad.hex);
        JoystickBed bed(plain_controller(), rumbles);
        QVERIFY(bed.plug_in());
        FoundJoystickBench bench(bed);
        QVERIFY2(bench.error.find("its force has no direction") != std::string::npos, bench.error.c_str());
    }

    void without_permission_it_is_listed_and_a_person_is_told_what_to_do() {
        JoystickBed bed;
        QVERIFY(bed.plug_in());
        const mock::Stranger stranger(bed.root(), {mock::hidraw_node}, {mock::hidraw_node});
        QVERIFY(stranger.good());
        const std::vector<FoundJoystick> found = find_joysticks();
        QCOMPARE(found.size(), std::size_t(1));
        const Result<std::unique_ptr<PidTransport>> opened = open_joystick(found.front(), {});
        QVERIFY(!opened.ok());
        QVERIFY2(opened.error().find("udev/rules.d") != std::string::npos, opened.error().c_str());
    }

    void what_was_unplugged_before_it_was_opened_is_gone() {
        const Result<std::unique_ptr<PidTransport>> opened = open_joystick({"/dev/hidraw7", "", ""}, {});
        QVERIFY(!opened.ok());
        QVERIFY2(opened.error().find("unplugged") != std::string::npos, opened.error().c_str());
    }
};

QTEST_APPLESS_MAIN(HidPidTransportTest)
#include "hid_pid_transport_test.moc"
