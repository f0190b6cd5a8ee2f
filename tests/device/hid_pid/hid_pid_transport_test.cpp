// SPDX-License-Identifier: Apache-2.0
// A force stick through the real hidapi, with a device made by umockdev: its /sys and /dev are those of a HID
// device, its node is a pseudo-terminal, and behind it a thread runs the model stick.
#include "../force_pad/mock_hidraw.hpp"
#include "device/hid_pid/hid_pid_transport.hpp"
#include "device/registry.hpp"
#include "stick_bench.hpp"
#include "stranger.hpp"

#include <QTest>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <fcntl.h>
#include <memory>
#include <mutex>
#include <poll.h>
#include <string>
#include <termios.h>
#include <thread>
#include <umockdev-1.0/umockdev.h>
#include <unistd.h>
#include <vector>

using namespace tp;

namespace {

/// A test bed with, once plugged in, one HID device.
class StickBed {
public:
    explicit StickBed(const StickWire& wire = plain_controller(),
                      std::span<const std::uint8_t> other_descriptor = {}, const HandlePlant& plant = {})
        : bed_(umockdev_testbed_new()), model_(wire, plant),
          descriptor_(other_descriptor.empty() ? wire.descriptor : other_descriptor) {
        ioctls_ = UMOCKDEV_IOCTL_BASE(g_object_new(umockdev_ioctl_base_get_type(), nullptr));
        g_signal_connect(ioctls_, "handle-ioctl", G_CALLBACK(&StickBed::answer_of), this);
        model_.place_grip({10.0, 3.0});
    }
    ~StickBed() {
        quit_.store(true);
        if (device_.joinable())
            device_.join();
        if (file_ >= 0)
            ::close(file_);
        g_object_unref(ioctls_);
        g_object_unref(bed_);
    }
    StickBed(const StickBed&) = delete;
    StickBed& operator=(const StickBed&) = delete;

    bool plug_in() {
        const mock::HidrawDevice shown{"force stick", "FS-0001", descriptor_};
        const std::string description = mock::usb_description(shown) + mock::hidraw_description(shown);
        if (umockdev_testbed_add_from_string(bed_, description.c_str(), nullptr) == FALSE ||
            umockdev_testbed_attach_ioctl(bed_, mock::hidraw_node, ioctls_, nullptr) == FALSE)
            return false;
        file_ = umockdev_testbed_get_dev_fd(bed_, mock::hidraw_node);
        if (file_ < 0)
            return false;
        termios raw{};
        if (tcgetattr(file_, &raw) == 0) {
            cfmakeraw(&raw);
            tcsetattr(file_, TCSANOW, &raw);
        }
        device_ = std::thread([this] { be_a_stick(); });
        return true;
    }
    void unplug() { unplug_.store(true); }
    /// Forces from the computer that were taken.
    long taken() const { return taken_.load(); }
    std::size_t effects() {
        const std::lock_guard lock(mutex_);
        return model_.effects();
    }
    Vec2 force() {
        const std::lock_guard lock(mutex_);
        return model_.force();
    }
    std::string root() const {
        char* folder = umockdev_testbed_get_root_dir(bed_);
        std::string copy = folder;
        g_free(folder);
        return copy;
    }

private:
    static gboolean answer_of(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
        return static_cast<StickBed*>(self)->answer(client);
    }
    gboolean answer(UMockdevIoctlClient* client) {
        return mock::answer_hid_class(client, [this](gulong request, std::span<std::uint8_t> data) {
            constexpr unsigned set_feature = 0x06;
            constexpr unsigned get_feature = 0x07;
            constexpr unsigned get_input = 0x0A;
            // On a bus a request comes after what was written before it; here they go different ways. The
            // gain is the last that is written before an effect is asked for.
            while (_IOC_NR(request) == set_feature && !gain_taken_.load() && !quit_.load())
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            const std::lock_guard lock(mutex_);
            std::vector<std::uint8_t> told;
            if (_IOC_NR(request) == set_feature)
                return model_.set_feature(data) ? static_cast<int>(data.size()) : -1;
            if (_IOC_NR(request) == get_feature && !model_.get_feature(data[0], told))
                return -1;
            if (_IOC_NR(request) == get_input && data[0] == model_.wire().axes)
                told = model_.axes_report();
            if (told.empty())
                return mock::descriptor_answer(request, data, descriptor_);
            std::copy_n(told.begin(), std::min(told.size(), data.size()), data.begin());
            return static_cast<int>(std::min(told.size(), data.size()));
        });
    }
    /// Bytes of an output report with its id; the node is a stream and keeps no borders.
    std::size_t size_of(std::uint8_t id) const {
        const StickWire& wire = model_.wire();
        return id == wire.set_effect                               ? 1 + wire.effect_bytes
               : id == wire.constant_force || id == wire.operation ? 4
                                                                   : 2;
    }
    void be_a_stick() {
        std::vector<std::uint8_t> waiting;
        while (!quit_.load()) {
            if (unplug_.load()) {
                umockdev_testbed_uevent(bed_, mock::hidraw_sys_path, "remove");
                ::close(file_);
                file_ = -1;
                return;
            }
            pollfd ready{file_, POLLIN, 0};
            if (::poll(&ready, 1, 5) <= 0)
                continue;
            std::uint8_t bytes[4096];
            const ssize_t count = ::read(file_, bytes, sizeof bytes);
            if (count <= 0) { // nobody has it open
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
                continue;
            }
            waiting.insert(waiting.end(), bytes, bytes + count);
            while (!waiting.empty() && waiting.size() >= size_of(waiting[0])) {
                const auto size = static_cast<std::ptrdiff_t>(size_of(waiting[0]));
                take({waiting.begin(), waiting.begin() + size});
                waiting.erase(waiting.begin(), waiting.begin() + size);
            }
        }
    }
    void take(const std::vector<std::uint8_t>& report) {
        std::vector<std::uint8_t> told;
        {
            const std::lock_guard lock(mutex_);
            model_.receive(report);
            model_.step();
            while (model_.report(told)) {
            }
        }
        if (!told.empty() && ::write(file_, told.data(), told.size()) != static_cast<ssize_t>(told.size()))
            return;
        constexpr std::uint8_t gain = 0x0D;
        if (report[0] == gain)
            gain_taken_.store(true);
        if (report[0] == model_.wire().constant_force)
            taken_.fetch_add(1);
    }

    UMockdevTestbed* bed_;
    UMockdevIoctlBase* ioctls_ = nullptr;
    std::thread device_;
    int file_ = -1;
    std::atomic<bool> quit_{false};
    std::atomic<bool> unplug_{false};
    std::atomic<bool> gain_taken_{false};
    std::atomic<long> taken_{0};
    std::mutex mutex_; ///< of the model
    ModelStick model_;
    std::span<const std::uint8_t> descriptor_;
};

/// A servo on the only stick that is found, in simulated time.
struct FoundStickBench {
    StickBed& bed;
    VirtualClock clock;
    std::unique_ptr<PidStick> device;
    std::unique_ptr<ServoLoop> loop;
    std::string error;

    explicit FoundStickBench(StickBed& test_bed) : bed(test_bed) {
        const std::vector<FoundStick> found = find_sticks();
        if (found.size() != 1) {
            error = "found " + std::to_string(found.size());
            return;
        }
        device =
            std::make_unique<PidStick>([one = found.front()] { return open_stick(one); },
                                       PidStick::Identity{found.front().product, found.front().serial_number},
                                       StickScale{8.0, {-1.0, -1.0}, true});
        Result<Capabilities> can = device->open();
        if (!can.ok()) {
            error = can.error();
            return;
        }
        loop = std::make_unique<ServoLoop>(*device, can.value(), clock, ServoSettings{});
        auto scene = make_haptic_scene(
            Scene{200.0, 150.0, {contour_through("line", {{-50.0, 0.0}, {50.0, 0.0}}, false)}});
        loop->render(std::move(scene).value());
        loop->engage();
    }
    /// Waits until the stick took a force: CTest ends a test that waits for ever.
    void tick(bool wait = true) {
        const long before = bed.taken();
        clock.sleep_until(clock.now() + 0.001);
        loop->tick();
        while (wait && bed.taken() == before)
            std::this_thread::yield();
    }
};

} // namespace

class HidPidTransportTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        const StickBed bed;
        QVERIFY2(umockdev_in_mock_environment() != FALSE, "needs umockdev's preloaded library");
    }

    void a_stick_is_found_listed_and_draws_its_grip_to_a_line() {
        StickBed bed;
        QVERIFY(find_sticks().empty());
        QVERIFY(bed.plug_in()); // late arrival: it was not there a moment ago
        const std::vector<FoundStick> found = find_sticks();
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found.front().serial_number, std::string("FS-0001"));
        QCOMPARE(found.front().product, std::string("force stick"));
        const std::vector<ListedDevice> listed = list_devices();
        QCOMPARE(listed.size(), std::size_t(2));
        QCOMPARE(listed.back().name, std::string("stick:FS-0001"));
        QCOMPARE(listed.back().interface, std::string("hid"));
        FoundStickBench bench(bed);
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

    void a_signal_takes_the_force_away_without_hidapi() {
        HandlePlant held;
        held.hand_stiffness = 0.5;
        held.hand_damping = 5.0;
        StickBed bed(plain_controller(), {}, held);
        QVERIFY(bed.plug_in());
        FoundStickBench bench(bed);
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
        StickBed bed;
        QVERIFY(bed.plug_in());
        FoundStickBench bench(bed);
        QVERIFY2(bench.loop, bench.error.c_str());
        for (int i = 0; i < 300; ++i)
            bench.tick();
        QCOMPARE(bench.loop->snapshot().fault, Fault::none);
        bed.unplug();
        while (bench.loop->snapshot().fault != Fault::device_lost) {
            bench.tick(false);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        QVERIFY(bench.loop->snapshot().force() == Vec2(0.0));
        bench.loop->stop();
        QVERIFY(!bench.device->write(SafeForce{}));
    }

    void another_device_with_the_same_ids_is_no_stick() {
        const std::vector<std::uint8_t> gamepad = tp::testing::bytes_of(tp::testing::dragonrise_gamepad.hex);
        StickBed bed(plain_controller(), gamepad);
        QVERIFY(bed.plug_in());
        QVERIFY(find_sticks().empty());
        QCOMPARE(list_devices().size(), std::size_t(1));
    }
    void one_that_only_rumbles_is_told_why_it_cannot_be_used() {
        const std::vector<std::uint8_t> rumbles = tp::testing::bytes_of(tp::testing::saitek_rumble_pad.hex);
        StickBed bed(plain_controller(), rumbles);
        QVERIFY(bed.plug_in());
        FoundStickBench bench(bed);
        QVERIFY2(bench.error.find("its force has no direction") != std::string::npos, bench.error.c_str());
    }

    void without_permission_it_is_listed_and_a_person_is_told_what_to_do() {
        StickBed bed;
        QVERIFY(bed.plug_in());
        const mock::Stranger stranger(bed.root(), {mock::hidraw_node}, {mock::hidraw_node});
        QVERIFY(stranger.good());
        const std::vector<FoundStick> found = find_sticks();
        QCOMPARE(found.size(), std::size_t(1));
        const Result<std::unique_ptr<PidTransport>> opened = open_stick(found.front());
        QVERIFY(!opened.ok());
        QVERIFY2(opened.error().find("udev/rules.d") != std::string::npos, opened.error().c_str());
    }

    void what_was_unplugged_before_it_was_opened_is_gone() {
        const Result<std::unique_ptr<PidTransport>> opened = open_stick({"/dev/hidraw7", "", ""});
        QVERIFY(!opened.ok());
        QVERIFY2(opened.error().find("unplugged") != std::string::npos, opened.error().c_str());
    }
};

QTEST_APPLESS_MAIN(HidPidTransportTest)
#include "hid_pid_transport_test.moc"
