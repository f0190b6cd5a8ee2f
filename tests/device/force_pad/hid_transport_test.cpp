// SPDX-License-Identifier: Apache-2.0
// The force pad through the real hidapi, with a device made by umockdev.
#include "../hid_node.hpp"
#include "device/force_pad/hid_transport.hpp"
#include "device/force_pad/model_pad.hpp"
#include "found_pad_judge.hpp"
#include "stranger.hpp"

#include <QTest>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <umockdev-1.0/umockdev.h>
#include <unistd.h>
#include <vector>

using namespace tp;

namespace {

/// A HID device with the model pad behind it.
class Bed final : public mock::ListeningNode {
public:
    enum class Behaviour { pad, silent, other_device };

    Bed() { model_.place_knob({10.0, 2.0}); }
    ~Bed() override { end(); }

    bool plug_in(Behaviour behaviour) {
        behave(behaviour);
        return ListeningNode::plug_in();
    }
    void behave(Behaviour behaviour) { behaviour_.store(behaviour); }
    /// Reports from the computer that were answered.
    long answered() const { return answered_.load(); }

private:
    std::size_t report_bytes(std::uint8_t) const override { return 1 + pad::frame_size; }
    void take(const std::vector<std::uint8_t>& bytes) override {
        if (behaviour_.load() == Behaviour::silent)
            return;
        pad::Frame frame;
        std::memcpy(frame.bytes, bytes.data() + 1, pad::frame_size);
        model_.receive(frame);
        model_.step();
        pad::Frame report;
        while (model_.report(report)) {
            if (behaviour_.load() == Behaviour::other_device)
                for (std::uint8_t& byte : report.bytes)
                    byte = static_cast<std::uint8_t>(byte ^ 0x5A);
            if (::write(file(), report.bytes, pad::frame_size) != static_cast<ssize_t>(pad::frame_size))
                return;
        }
        answered_.fetch_add(1);
    }

    ModelPad model_{pad::cable_pad()};
    std::atomic<Behaviour> behaviour_{Behaviour::pad};
    std::atomic<long> answered_{0};
};

struct Bench : FoundPadBench {
    explicit Bench(const Bed& bed, bool patient = true)
        : FoundPadBench(
              find_hid(), open_hid, [&bed] { return bed.answered(); }, patient) {}
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
        judge_a_thousand_frames(bench);
    }

    void unplugged_in_mid_touch_it_is_lost_and_everything_ends() {
        Bed bed;
        QVERIFY(bed.plug_in(Bed::Behaviour::pad));
        Bench bench(bed);
        judge_unplugged_in_mid_touch(bench, [&] { bed.unplug(); });
    }

    void a_pad_that_falls_silent_is_stale_and_heals() {
        Bed bed;
        QVERIFY(bed.plug_in(Bed::Behaviour::pad));
        Bench bench(bed);
        judge_silent_for_a_while(
            bench, [&] { bed.behave(Bed::Behaviour::silent); }, [&] { bed.behave(Bed::Behaviour::pad); });
    }

    void another_device_with_the_same_ids_is_told_apart_data() { other_devices(); }
    void another_device_with_the_same_ids_is_told_apart() {
        QFETCH(bool, silent);
        Bed bed;
        QVERIFY(bed.plug_in(silent ? Bed::Behaviour::silent : Bed::Behaviour::other_device));
        const Bench bench(bed, false);
        judge_another_device(bench);
    }

    void without_permission_a_person_is_told_what_to_do() {
        Bed bed;
        QVERIFY(bed.plug_in(Bed::Behaviour::pad));
        const std::vector<FoundPad> found = find_hid();
        QCOMPARE(found.size(), std::size_t(1));
        const mock::Stranger stranger(bed.root(), {mock::hidraw_node}, {mock::hidraw_node});
        QVERIFY(stranger.good());
        judge_without_permission(open_hid(found.front()));
    }

    void what_was_unplugged_before_it_was_opened_is_gone() {
        const Result<std::unique_ptr<ReportTransport>> opened = open_hid({"/dev/hidraw7", "", ""});
        QVERIFY(!opened.ok());
        QVERIFY2(opened.error().find("unplugged") != std::string::npos, opened.error().c_str());
    }
};

QTEST_APPLESS_MAIN(HidTransportTest)
#include "hid_transport_test.moc"
