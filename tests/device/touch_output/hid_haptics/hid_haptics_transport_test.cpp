// SPDX-License-Identifier: Apache-2.0
// A touch pad with haptics through the real hidapi, with a device made by umockdev.
#include "../hid_bed.hpp"
#include "device/touch_output/hid_haptics/hid_haptics_transport.hpp"
#include "device/touch_output/hid_haptics/model_haptic_pad.hpp"
#include "device/touch_output/touch_registry.hpp"
#include "stranger.hpp"

#include <QTest>

#include <string>
#include <thread>
#include <vector>

using namespace tp;

namespace {

/// A pad on the bus.
struct PadBed {
    ModelHapticPad model;
    mock::HidBed bed;

    explicit PadBed(std::span<const std::uint8_t> descriptor = ModelHapticPad::descriptor())
        : bed(mock::HidrawDevice{"touch pad", "HP-0001", descriptor, "06cb", "ce65"},
              {[](auto) { return false; },
               [this](std::uint8_t id) {
                   mock::HidBed::Bytes report = model.feature(id);
                   report.insert(report.begin(), id);
                   return report;
               }}) {}
};

const char* const its_name = "haptics:HP-0001";
constexpr std::size_t output_bytes = 6;

} // namespace

class HidHapticsTransportTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        const PadBed bed;
        QVERIFY2(umockdev_in_mock_environment() != FALSE, "needs umockdev's preloaded library");
    }

    void a_pad_is_listed_and_ticks_under_the_finger() {
        PadBed touch_pad;
        QVERIFY(find_haptic_pads().empty());
        QVERIFY(touch_pad.bed.plug_in());
        const std::vector<ListedTouchOutput> listed = list_touch_outputs();
        QCOMPARE(listed.size(), std::size_t(1));
        QCOMPARE(listed.front().name, std::string(its_name));
        QCOMPARE(listed.front().about, std::string("touch pad"));
        QVERIFY(listed.front().is_pad);
        QCOMPARE(listed.front().serial_number, std::string("HP-0001"));
        QCOMPARE(listed.front().delay, 0.015);

        auto pad = touch_output_named(its_name);
        QVERIFY2(pad.ok(), pad.error().c_str());
        const auto can = (*pad)->open();
        QVERIFY2(can.ok(), can.error().c_str());
        QCOMPARE(touch_pad.bed.hear(output_bytes), (mock::HidBed::Bytes{3, 2, 0, 0, 0, 0}));
        touch_pad.model.touch(0, {5.0, -2.0});
        std::vector<std::uint8_t> report;
        while (!touch_pad.model.report(report))
            touch_pad.model.step();
        QVERIFY(touch_pad.bed.say(report));
        std::optional<PadTouch> touch;
        while (!(touch = (*pad)->read(0.0))) // CTest ends a test that waits for ever
            std::this_thread::yield();
        QVERIFY(touch->touched && distance(touch->place, Vec2(5.0, -2.0)) < 0.04);
        QVERIFY((*pad)->tick(Tick(1.0, 1.0, 0.01)));
        QCOMPARE(touch_pad.bed.hear(output_bytes), (mock::HidBed::Bytes{3, 4, 100, 0, 0, 0}));
        (*pad)->halt();
        QCOMPARE(touch_pad.bed.hear(output_bytes), (mock::HidBed::Bytes{3, 2, 0, 0, 0, 0}));
        (*pad)->stop();
    }

    /// As touch pads are, which are a mouse for a system that knows no better.
    void a_pad_that_is_a_mouse_besides_is_listed_once() {
        std::vector<std::uint8_t> both(ModelHapticPad::descriptor().begin(),
                                       ModelHapticPad::descriptor().end());
        const std::vector<std::uint8_t> mouse{0x05, 0x01, 0x09, 0x02, 0xA1, 0x01, 0x85, 0x09, 0x05,
                                              0x09, 0x19, 0x01, 0x29, 0x08, 0x15, 0x00, 0x25, 0x01,
                                              0x75, 0x01, 0x95, 0x08, 0x81, 0x02, 0xC0};
        both.insert(both.end(), mouse.begin(), mouse.end());
        PadBed touch_pad(both);
        QVERIFY(touch_pad.bed.plug_in());
        QCOMPARE(find_haptic_pads().size(), std::size_t(1));
        PadBed only_a_mouse(mouse);
        QVERIFY(only_a_mouse.bed.plug_in());
        QVERIFY(find_haptic_pads().empty());
    }

    void no_more_of_a_report_is_read_than_there_is() {
        PadBed touch_pad;
        QVERIFY(touch_pad.bed.plug_in());
        const auto pad = open_haptic_pad(find_haptic_pads().front());
        QVERIFY2(pad.ok(), pad.error().c_str());
        QCOMPARE((*pad)->feature(2, 4), (mock::HidBed::Bytes{0x06, 0x10, 0x03, 0x10}));
        QCOMPARE((*pad)->feature(2, 100), touch_pad.model.feature(2));
        QVERIFY((*pad)->feature(2, 0).empty());
        HapticsTransport::Input input;
        QVERIFY((*pad)->read(input, 0) == HapticsTransport::Got::nothing);
        for (const std::size_t size : {1u, 200u}) {
            QVERIFY(touch_pad.bed.say(std::vector<std::uint8_t>(size, 9)));
            HapticsTransport::Got got{};
            while ((got = (*pad)->read(input, 0)) ==
                   HapticsTransport::Got::nothing) // CTest ends one that waits for ever
                std::this_thread::yield();
            QVERIFY(got == HapticsTransport::Got::report && input.size == size && input.bytes[size - 1] == 9);
        }
    }

    void a_pad_that_ticks_by_itself_only_is_listed_and_refused_with_a_sentence() {
        const std::vector<std::uint8_t> descriptor = ModelHapticPad::descriptor_without_trigger();
        PadBed touch_pad(descriptor);
        QVERIFY(touch_pad.bed.plug_in());
        QVERIFY(!list_touch_outputs().front().is_pad);
        auto pad = touch_output_named(its_name);
        QVERIFY(pad.ok());
        QVERIFY((*pad)->open().error().find("takes no ticks from a program") != std::string::npos);
    }

    void unplugged_in_mid_touch_it_is_lost() {
        PadBed touch_pad;
        QVERIFY(touch_pad.bed.plug_in());
        auto pad = touch_output_named(its_name);
        QVERIFY(pad.ok() && (*pad)->open().ok());
        touch_pad.bed.unplug();
        while (!(*pad)->lost())
            (*pad)->read(0.0);
        QVERIFY(!(*pad)->tick(Tick(1.0, 1.0, 0.01)));
        QVERIFY((*pad)->complaint().find("was unplugged") != std::string::npos);
    }

    void another_touchphoto_that_uses_it_is_told_of() {
        PadBed touch_pad;
        QVERIFY(touch_pad.bed.plug_in());
        auto first = touch_output_named(its_name);
        auto second = touch_output_named(its_name);
        QVERIFY(first.ok() && second.ok() && (*first)->open().ok());
        QVERIFY((*second)->open().error().find("Another program uses") != std::string::npos);
    }

    void without_permission_it_is_listed_and_a_person_is_told_what_to_do() {
        PadBed touch_pad;
        QVERIFY(touch_pad.bed.plug_in());
        const mock::Stranger stranger(touch_pad.bed.root(), {mock::hidraw_node}, {mock::hidraw_node});
        QVERIFY(stranger.good());
        auto pad = touch_output_named(its_name);
        QVERIFY2(pad.ok(), pad.error().c_str());
        QVERIFY((*pad)->open().error().find("udev/rules.d") != std::string::npos);
    }
};

QTEST_APPLESS_MAIN(HidHapticsTransportTest)
#include "hid_haptics_transport_test.moc"
