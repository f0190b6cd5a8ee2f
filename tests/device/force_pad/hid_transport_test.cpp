// SPDX-License-Identifier: Apache-2.0
// The force pad through the real hidapi, with a device made by umockdev: its /sys and /dev are those of a HID
// device, its node is a pseudo-terminal, and behind it a thread runs the model pad.
#include "../mocked_node.hpp"
#include "device/force_pad/hid_transport.hpp"
#include "device/force_pad/model_pad.hpp"
#include "found_pad_bench.hpp"
#include "mock_hidraw.hpp"
#include "stranger.hpp"

#include <QTest>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <poll.h>
#include <string>
#include <thread>
#include <umockdev-1.0/umockdev.h>
#include <unistd.h>
#include <vector>

using namespace tp;

namespace {

/// A test bed with, once plugged in, one HID device.
class Bed {
public:
    enum class Behaviour { pad, silent, other_device };

    Bed() : bed_(umockdev_testbed_new()) {
        ioctls_ = UMOCKDEV_IOCTL_BASE(g_object_new(umockdev_ioctl_base_get_type(), nullptr));
        g_signal_connect(ioctls_, "handle-ioctl", G_CALLBACK(mock::answer_hidraw_ioctl), nullptr);
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
        const std::string description = mock::usb_description() + mock::hidraw_description();
        file_ = mock::plugged_in(bed_, description, mock::hidraw_node, ioctls_);
        if (file_ < 0)
            return false;
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

struct Bench : FoundPadBench {
    explicit Bench(const Bed& bed) : FoundPadBench(find_hid(), open_hid, [&bed] { return bed.answered(); }) {}
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
        QVERIFY(find_hid().empty());
        QVERIFY(bed.plug_in(Bed::Behaviour::pad)); // late arrival: it was not there a moment ago
        const std::vector<FoundPad> found = find_hid();
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
        bench.until([&] { return bench.loop->snapshot().fault == Fault::device_lost; });
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
        QVERIFY(bench.ticks_until_let_go() <= 60);
        bed.behave(Bed::Behaviour::pad);
        bench.until([&] { return bench.loop->snapshot().fault == Fault::none; });
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
        const std::vector<FoundPad> found = find_hid();
        QCOMPARE(found.size(), std::size_t(1));
        const mock::Stranger stranger(bed.root(), {mock::hidraw_node}, {mock::hidraw_node});
        QVERIFY(stranger.good());
        const Result<std::unique_ptr<ReportTransport>> opened = open_hid(found.front());
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
