// SPDX-License-Identifier: Apache-2.0
// The force pad through the real hidapi, with a device made by umockdev: its /sys and /dev are those of a HID
// device, its node is a pseudo-terminal, and behind it a thread runs the model pad.
#include "core/servo/servo_loop.hpp"
#include "device/force_pad/force_pad.hpp"
#include "device/force_pad/hid_transport.hpp"
#include "device/force_pad/model_pad.hpp"
#include "device/force_pad/protocol/usb.hpp"

// GLib's header has a parameter of this name.
#undef signals
#include <QTest>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <linux/hidraw.h>
#include <memory>
#include <poll.h>
#include <string>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <termios.h>
#include <thread>
#include <umockdev-1.0/umockdev.h>
#include <unistd.h>
#include <vector>

using namespace tp;

namespace {

constexpr const char* node = "/dev/hidraw0";
constexpr const char* sys_path =
    "/sys/devices/pci0000:00/usb1/1-1/1-1:1.0/0003:1209:0001.0001/hidraw/hidraw0";

gboolean answer_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client) {
    const gulong request = umockdev_ioctl_client_get_request(client);
    if (_IOC_TYPE(request) != 'H')
        return FALSE;
    UMockdevIoctlData* data = umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0,
                                                          static_cast<gsize>(_IOC_SIZE(request)), nullptr);
    if (data == nullptr) {
        umockdev_ioctl_client_complete(client, -1, EFAULT);
        return TRUE;
    }
    if (request == HIDIOCGRDESCSIZE) {
        const int size = sizeof pad::report_descriptor;
        std::memcpy(data->data, &size, sizeof size);
        umockdev_ioctl_client_complete(client, 0, 0);
    } else if (request == HIDIOCGRDESC) {
        auto* descriptor = reinterpret_cast<hidraw_report_descriptor*>(data->data);
        descriptor->size = sizeof pad::report_descriptor;
        std::memcpy(descriptor->value, pad::report_descriptor, sizeof pad::report_descriptor);
        umockdev_ioctl_client_complete(client, 0, 0);
    } else {
        umockdev_ioctl_client_complete(client, -1, EINVAL);
    }
    umockdev_ioctl_data_unref(data);
    return TRUE;
}

/// A test bed with, once plugged in, one HID device.
class Bed {
public:
    enum class Behaviour { pad, silent, other_device };

    Bed() : bed_(umockdev_testbed_new()) {
        ioctls_ = UMOCKDEV_IOCTL_BASE(g_object_new(umockdev_ioctl_base_get_type(), nullptr));
        g_signal_connect(ioctls_, "handle-ioctl", G_CALLBACK(answer_ioctl), nullptr);
    }
    ~Bed() {
        quit_.store(true);
        if (device_.joinable())
            device_.join();
        if (file_ >= 0)
            ::close(file_);
        g_object_unref(ioctls_);
        g_object_unref(bed_);
    }
    Bed(const Bed&) = delete;
    Bed& operator=(const Bed&) = delete;

    bool plug_in(Behaviour behaviour) {
        std::string descriptor;
        for (const std::uint8_t byte : pad::report_descriptor) {
            constexpr const char* digits = "0123456789ABCDEF";
            descriptor += digits[byte >> 4];
            descriptor += digits[byte & 0xF];
        }
        const std::string description =
            "P: /devices/pci0000:00/usb1/1-1\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nA: idVendor=1209\\n\n"
            "A: idProduct=0001\\n\nA: manufacturer=touchphoto\\n\nA: product=force pad\\n\nA: "
            "serial=TPC-0001\\n\n"
            "A: bcdDevice=0100\\n\n\n"
            "P: /devices/pci0000:00/usb1/1-1/1-1:1.0\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\n"
            "A: bInterfaceNumber=00\\n\n\n"
            "P: /devices/pci0000:00/usb1/1-1/1-1:1.0/0003:1209:0001.0001\nE: SUBSYSTEM=hid\n"
            "E: HID_ID=0003:00001209:00000001\nE: HID_NAME=force pad\nE: HID_PHYS=usb-0/input0\nE: "
            "HID_UNIQ=TPC-0001\n"
            "H: report_descriptor=" +
            descriptor +
            "\n\nP: /devices/pci0000:00/usb1/1-1/1-1:1.0/0003:1209:0001.0001/hidraw/hidraw0\nN: hidraw0\n"
            "E: SUBSYSTEM=hidraw\nE: DEVNAME=/dev/hidraw0\nE: MAJOR=246\nE: MINOR=0\n"
            "L: device=../../../0003:1209:0001.0001\n\n";
        if (umockdev_testbed_add_from_string(bed_, description.c_str(), nullptr) == FALSE ||
            umockdev_testbed_attach_ioctl(bed_, node, ioctls_, nullptr) == FALSE)
            return false;
        file_ = umockdev_testbed_get_dev_fd(bed_, node);
        if (file_ < 0)
            return false;
        termios raw{};
        if (tcgetattr(file_, &raw) == 0) {
            cfmakeraw(&raw);
            tcsetattr(file_, TCSANOW, &raw);
        }
        behaviour_.store(behaviour);
        device_ = std::thread([this] { be_a_device(); });
        return true;
    }
    void unplug() { unplug_.store(true); }
    void behave(Behaviour behaviour) { behaviour_.store(behaviour); }
    /// Reports from the computer that were answered.
    long answered() const { return answered_.load(); }
    std::string root() const {
        char* folder = umockdev_testbed_get_root_dir(bed_);
        std::string copy = folder;
        g_free(folder);
        return copy;
    }

private:
    void be_a_device() {
        ModelPad model(pad::cable_pad());
        model.place_knob({10.0, 2.0});
        constexpr std::size_t size = 1 + pad::frame_size; // the report id leads
        std::vector<std::uint8_t> waiting;
        while (!quit_.load()) {
            if (unplug_.load()) {
                umockdev_testbed_uevent(bed_, sys_path, "remove");
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
            while (waiting.size() >= size) {
                pad::Frame frame;
                std::memcpy(frame.bytes, waiting.data() + 1, pad::frame_size);
                waiting.erase(waiting.begin(), waiting.begin() + size);
                answer(model, frame);
            }
        }
    }
    void answer(ModelPad& model, const pad::Frame& frame) {
        if (behaviour_.load() == Behaviour::silent)
            return;
        model.receive(frame);
        model.step();
        pad::Frame report;
        while (model.report(report)) {
            if (behaviour_.load() == Behaviour::other_device)
                for (std::uint8_t& byte : report.bytes)
                    byte = static_cast<std::uint8_t>(byte ^ 0x5A);
            if (::write(file_, report.bytes, pad::frame_size) != static_cast<ssize_t>(pad::frame_size))
                return;
        }
        answered_.fetch_add(1);
    }

    UMockdevTestbed* bed_;
    UMockdevIoctlBase* ioctls_ = nullptr;
    std::thread device_;
    int file_ = -1;
    std::atomic<bool> quit_{false};
    std::atomic<bool> unplug_{false};
    std::atomic<Behaviour> behaviour_{Behaviour::pad};
    std::atomic<long> answered_{0};
};

/// A servo on the only pad that is found, in simulated time: one tick for each report that went there and
/// back.
struct Bench {
    Bed& bed;
    VirtualClock clock;
    std::unique_ptr<ForcePad> device;
    std::unique_ptr<ServoLoop> loop;
    std::string error;

    explicit Bench(Bed& made) : bed(made) {
        const std::vector<FoundPad> found = find_pads();
        if (found.size() != 1) {
            error = "found " + std::to_string(found.size());
            return;
        }
        device = std::make_unique<ForcePad>([pad = found.front()] { return open_hid(pad); });
        Result<Capabilities> can = device->open();
        if (!can.ok()) {
            error = can.error();
            return;
        }
        loop = std::make_unique<ServoLoop>(*device, can.value(), clock, ServoSettings{});
        auto scene = make_haptic_scene(
            Scene{200.0, 150.0, {contour_through("line", {{-80.0, 0.0}, {80.0, 0.0}}, false)}});
        loop->render(std::move(scene).value());
        loop->engage();
    }
    void tick(bool answered) {
        const long before = bed.answered();
        clock.sleep_until(clock.now() + 0.001);
        loop->tick();
        while (answered && bed.answered() == before) // CTest ends a test that waits for ever
            std::this_thread::yield();
    }
};

} // namespace

class HidTransportTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        const Bed bed;
        QVERIFY2(umockdev_in_mock_environment() != FALSE, "needs umockdev's preloaded library");
    }

    void a_thousand_reports_go_there_and_back() {
        Bed bed;
        QVERIFY(find_pads().empty());
        QVERIFY(bed.plug_in(Bed::Behaviour::pad)); // late arrival: it was not there a moment ago
        const std::vector<FoundPad> found = find_pads();
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found.front().serial_number, std::string("TPC-0001"));
        QCOMPARE(found.front().product, std::string("force pad"));
        Bench bench(bed);
        QVERIFY2(bench.loop, bench.error.c_str());
        for (int i = 0; i < 1000; ++i)
            bench.tick(true);
        const ServoSnapshot view = bench.loop->snapshot();
        QCOMPARE(view.fault, Fault::none);
        QVERIFY(std::abs(view.x - 10.0) < 0.1);
        QVERIFY(view.y < 2.0); // drawn to the line
        QCOMPARE(bench.device->bad_frames(), std::uint64_t(0));
    }

    void unplugged_in_mid_touch_it_is_lost_and_everything_ends() {
        Bed bed;
        QVERIFY(bed.plug_in(Bed::Behaviour::pad));
        Bench bench(bed);
        QVERIFY2(bench.loop, bench.error.c_str());
        for (int i = 0; i < 300; ++i)
            bench.tick(true);
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

    void a_pad_that_falls_silent_is_stale_and_heals() {
        Bed bed;
        QVERIFY(bed.plug_in(Bed::Behaviour::pad));
        Bench bench(bed);
        QVERIFY2(bench.loop, bench.error.c_str());
        for (int i = 0; i < 700; ++i)
            bench.tick(true);
        QVERIFY(bench.loop->snapshot().gain == 1.0);
        bed.behave(Bed::Behaviour::silent);
        for (int i = 0; i < 60; ++i)
            bench.tick(false);
        QCOMPARE(bench.loop->snapshot().fault, Fault::stale_input);
        QVERIFY(bench.loop->snapshot().force() == Vec2(0.0));
        bed.behave(Bed::Behaviour::pad);
        while (bench.loop->snapshot().fault != Fault::none) {
            bench.tick(false);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }

    void another_device_with_the_same_ids_is_told_apart_data() {
        QTest::addColumn<bool>("silent");
        QTest::newRow("says other things") << false;
        QTest::newRow("says nothing") << true;
    }
    void another_device_with_the_same_ids_is_told_apart() {
        QFETCH(bool, silent);
        Bed bed;
        QVERIFY(bed.plug_in(silent ? Bed::Behaviour::silent : Bed::Behaviour::other_device));
        Bench bench(bed);
        QVERIFY(!bench.loop);
        QVERIFY2(bench.error.find("does not answer like a force pad") != std::string::npos,
                 bench.error.c_str());
    }

    void without_permission_a_person_is_told_what_to_do() {
        Bed bed;
        QVERIFY(bed.plug_in(Bed::Behaviour::pad));
        const std::vector<FoundPad> found = find_pads();
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(::chmod((bed.root() + node).c_str(), 0), 0);
        const bool root = ::geteuid() == 0; // whom no permission keeps out
        if (root) {
            // umockdev's own way to the test bed stays open to all.
            QCOMPARE(::chmod(bed.root().c_str(), 0755), 0);
            QCOMPARE(::chmod((bed.root() + "/ioctl" + node).c_str(), 0777), 0);
            QCOMPARE(::seteuid(65534), 0);
        }
        const Result<std::unique_ptr<ReportTransport>> opened = open_hid(found.front());
        if (root)
            QCOMPARE(::seteuid(0), 0);
        QVERIFY(!opened.ok());
        QVERIFY2(opened.error().find("udev/rules.d") != std::string::npos, opened.error().c_str());
    }

    void what_was_unplugged_before_it_was_opened_is_gone() {
        const Result<std::unique_ptr<ReportTransport>> opened = open_hid({"/dev/hidraw7", "", ""});
        QVERIFY(!opened.ok());
        QVERIFY2(opened.error().find("unplugged") != std::string::npos, opened.error().c_str());
    }
};

QTEST_APPLESS_MAIN(HidTransportTest)
#include "hid_transport_test.moc"
