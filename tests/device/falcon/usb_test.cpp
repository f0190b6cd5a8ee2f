// SPDX-License-Identifier: Apache-2.0
// The Falcon through the real libusb, with a device made by umockdev.
#include "../usb/wire_bench.hpp"
#include "device/falcon/falcon_usb.hpp"
#include "device/registry.hpp"
#include "mock_falcon.hpp"
#include "stranger.hpp"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace tp;
using mock::UsbFalconBed;

namespace {

/// The guard's time is not the simulated one: none stands beside this Falcon.
class UnhurriedLink final : public testing::BorrowedFalconLink {
public:
    explicit UnhurriedLink(std::unique_ptr<FalconLink> link)
        : BorrowedFalconLink(*link), link_(std::move(link)) {}
    Result<std::unique_ptr<ForceGuard>> guard(std::span<const std::uint8_t>) override {
        return std::unique_ptr<ForceGuard>(std::make_unique<SimulatedGuard>(diary_));
    }

private:
    std::unique_ptr<FalconLink> link_;
    GuardDiary diary_;
};

Result<std::unique_ptr<FalconLink>> open_unhurried(const FoundFalcon& falcon) {
    auto opened = open_falcon(falcon, {});
    if (!opened.ok())
        return Error{opened.error()};
    return std::unique_ptr<FalconLink>(std::make_unique<UnhurriedLink>(std::move(opened).value()));
}

/// The only Falcon that is found, behind the real libusb.
struct Bench : testing::WireBench<Falcon> {
    explicit Bench(UsbFalconBed& bed, bool homed = true)
        : WireBench([&bed] {
              const UsbFalconBed::Seen seen = bed.seen();
              return seen.answered + seen.given_up;
          }) {
        if (homed)
            bed.with_model([](ModelFalcon& model) {
                model.run_firmware(true);
                model.place_grip(testing::falcon_place({10.0, 2.0}));
            });
        begin(std::make_unique<Falcon>(
            [] {
                return open_unhurried({"", "FTFALCON"});
            },
            [] { return testing::falcon_image(); }, "FTFALCON"));
    }
};

} // namespace

class FalconUsbTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        const UsbFalconBed bed;
        QVERIFY2(umockdev_in_mock_environment() != FALSE, "needs umockdev's preloaded library");
    }

    void commands_go_there_and_replies_come_back() {
        UsbFalconBed bed;
        QVERIFY(find_falcons().empty());
        QVERIFY(bed.plug_in()); // late arrival: it was not there a moment ago
        const std::vector<FoundFalcon> found = find_falcons();
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found.front().path, std::string("1-1"));
        QCOMPARE(found.front().serial_number, std::string("FTFALCON"));
        {
            Bench bench(bed);
            QVERIFY2(bench.loop, bench.error.c_str());
            QCOMPARE(bed.seen().loads_begun, 0);
            for (int i = 0; i < 800; ++i)
                bench.tick(true);
            // Drawn to the line; a command that a busy computer gave up on has drawn nothing.
            bench.until([&bench] {
                const ServoSnapshot now = bench.loop->snapshot();
                return now.fault != Fault::none || (std::abs(now.x - 10.0) < 0.5 && now.y < 2.0);
            });
            QCOMPARE(bench.loop->snapshot().fault, Fault::none);
            QVERIFY(bed.seen().command.leds == falcon::led::green);
        }
        // The way out leaves no force, and the interface to others.
        const UsbFalconBed::Seen seen = bed.seen();
        QVERIFY(seen.command.motors == (std::array<std::int16_t, 3>{}));
        QCOMPARE(seen.claimed, 1L);
        QCOMPARE(seen.released, 1L);
    }

    void firmware_is_loaded_over_the_wire_and_the_grip_homed() {
        UsbFalconBed bed;
        QVERIFY(bed.plug_in());
        bed.with_model([](ModelFalcon& model) { model.troubles.broken_loads = 1; });
        Bench bench(bed, false);
        QVERIFY2(bench.loop, bench.error.c_str());
        QCOMPARE(bed.seen().loads_begun, 2);
        QVERIFY(bed.seen().firmware_runs);
        QVERIFY(bench.device->complaint().find("pull the grip out") != std::string::npos);
        bed.with_model([](ModelFalcon& model) { model.place_grip(testing::falcon_place({0.0, 0.0}, 30.0)); });
        std::thread person([&bed] { // moves as soon as the light is blue
            while (bed.seen().command.leds != falcon::led::blue)
                std::this_thread::yield();
            bed.with_model([](ModelFalcon& model) { model.pull_and_push(); });
        });
        const Result<bool> homed = bench.device->home();
        person.join();
        QVERIFY2(homed.ok(), homed.error().c_str());
        QCOMPARE(bench.device->complaint(), std::string());
    }

    void unplugged_in_mid_touch_it_is_lost_and_everything_ends() {
        UsbFalconBed bed;
        QVERIFY(bed.plug_in());
        Bench bench(bed);
        QVERIFY2(bench.loop, bench.error.c_str());
        for (int i = 0; i < 100; ++i)
            bench.tick(true);
        QCOMPARE(bench.loop->snapshot().fault, Fault::none);
        bed.unplug();
        bench.until([&] { return bench.loop->snapshot().fault == Fault::device_lost; });
        QVERIFY(bench.loop->snapshot().force() == Vec2(0.0));
        bench.loop->stop();
        QVERIFY(!bench.device->write(SafeForce{}));
    }

    void unplugged_while_it_is_started_it_says_so() {
        UsbFalconBed bed;
        QVERIFY(bed.plug_in());
        std::thread cable([&bed] {
            while (bed.seen().loads_begun == 0)
                std::this_thread::yield();
            bed.unplug();
        });
        Bench bench(bed, false);
        cable.join();
        QVERIFY(!bench.loop);
        QVERIFY2(bench.error.find("unplugged") != std::string::npos, bench.error.c_str());
    }

    void a_falcon_that_falls_silent_is_stale_and_heals() {
        UsbFalconBed bed;
        QVERIFY(bed.plug_in());
        Bench bench(bed);
        QVERIFY2(bench.loop, bench.error.c_str());
        for (int i = 0; i < 100; ++i)
            bench.tick(true);
        UsbFalconBed::Behaviour silent;
        silent.silent = true;
        bed.behave(silent);
        bench.until([&] {
            const ServoSnapshot seen = bench.loop->snapshot();
            return seen.fault == Fault::stale_input && seen.force() == Vec2(0.0);
        });
        bed.behave({});
        bench.until([&] { return bench.loop->snapshot().fault == Fault::none; });
    }

    void halted_pipes_are_opened_again_and_odd_packets_borne() {
        UsbFalconBed bed;
        QVERIFY(bed.plug_in());
        Bench bench(bed);
        QVERIFY2(bench.loop, bench.error.c_str());
        UsbFalconBed::Behaviour trouble;
        trouble.stalls_in = 3;
        trouble.stalls_out = 3;
        trouble.errors_in = 20;
        trouble.odd_packets = true;
        bed.behave(trouble);
        bench.until([&] { return bed.seen().halts_cleared >= 6; });
        const long before = bed.seen().answered;
        bench.until([&] { return bed.seen().answered > before + 50; });
        bench.until([&] { return bench.loop->snapshot().fault == Fault::none; });
        QVERIFY(!bench.device->lost());
    }

    void another_device_with_the_same_ids_is_told_apart_data() {
        QTest::addColumn<bool>("silent");
        QTest::newRow("says other things") << false;
        QTest::newRow("says nothing") << true;
    }
    void another_device_with_the_same_ids_is_told_apart() {
        QFETCH(bool, silent);
        UsbFalconBed bed;
        QVERIFY(bed.plug_in());
        UsbFalconBed::Behaviour other;
        (silent ? other.silent : other.other_device) = true;
        bed.behave(other);
        Falcon device(
            [] {
                return open_falcon({"1-1", ""}, {});
            },
            [] { return std::vector<std::uint8_t>{}; }, "");
        const Result<Capabilities> can = device.open();
        QVERIFY(!can.ok());
        QVERIFY2(can.error().find("firmware") != std::string::npos, can.error().c_str());
    }

    void another_device_without_the_endpoints_is_not_listed() {
        UsbFalconBed bed;
        QVERIFY(bed.plug_in("FTFALCON", false));
        QVERIFY(find_falcons().empty());
    }

    void the_serial_driver_of_the_system_makes_way_and_comes_back() {
        UsbFalconBed bed;
        UsbFalconBed::Behaviour held;
        held.kernel_driver = true;
        bed.behave(held);
        QVERIFY(bed.plug_in());
        {
            const Result<std::unique_ptr<FalconLink>> opened = open_falcon({"", "FTFALCON"}, {});
            QVERIFY2(opened.ok(), opened.error().c_str());
            QCOMPARE(bed.seen().detached, 1L);
        }
        QCOMPARE(bed.seen().attached, 1L);
    }

    void each_reason_not_to_open_is_a_sentence() {
        UsbFalconBed bed;
        QVERIFY(bed.plug_in());
        QVERIFY(open_falcon({"", "ANOTHER"}, {}).error().find("The Falcon was unplugged") !=
                std::string::npos);
        {
            const mock::Stranger stranger(bed.root(), {UsbFalconBed::node}, {UsbFalconBed::node});
            QVERIFY(stranger.good());
            QCOMPARE(find_falcons().size(), std::size_t(1));
            const std::string words = open_falcon({"1-1", ""}, {}).error();
            QVERIFY2(words.find("udev/rules.d") != std::string::npos, words.c_str());
        }
        UsbFalconBed::Behaviour busy;
        busy.busy = true;
        bed.behave(busy);
        const std::string words = open_falcon({"1-1", ""}, {}).error();
        QVERIFY2(words.find("Close that program") != std::string::npos, words.c_str());
    }

    void it_is_listed_and_its_firmware_is_asked_for() {
        const QTemporaryDir data;
        qputenv("XDG_DATA_HOME", data.path().toUtf8());
        UsbFalconBed bed;
        QVERIFY(bed.plug_in());
        const std::vector<ListedDevice> devices = list_devices();
        QCOMPARE(devices.size(), std::size_t(2));
        QCOMPARE(devices[1].name, std::string("falcon:FTFALCON"));
        QCOMPARE(devices[1].about, std::string("Novint Falcon"));
        QCOMPARE(devices[1].interface, std::string("usb"));
        Result<std::unique_ptr<ForceDevice>> device = device_named("falcon:FTFALCON");
        QVERIFY(device.ok());
        const std::string words = device.value()->open().error();
        QVERIFY2(words.find("firmware.bin") != std::string::npos, words.c_str());

        const std::vector<std::uint8_t> image = testing::falcon_image();
        QVERIFY(QDir(data.path()).mkpath("touchphoto/falcon"));
        QFile file(data.filePath("touchphoto/falcon/firmware.bin"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(reinterpret_cast<const char*>(image.data()), static_cast<qint64>(image.size()));
        file.close();
        const Result<Capabilities> can = device.value()->open();
        QVERIFY2(can.ok(), can.error().c_str());
        QCOMPARE(can->serial_number, std::string("FTFALCON"));
        QVERIFY(!can->calibrated);
    }
};

QTEST_APPLESS_MAIN(FalconUsbTest)
#include "usb_test.moc"
