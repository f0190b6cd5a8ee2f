// SPDX-License-Identifier: Apache-2.0
#include "described_pads.hpp"
#include "device/touch_output/hid_haptics/haptics_reports.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace haptics_reports_test {

using namespace tp;
using namespace tp::haptics;

class HapticsReportsTest : public QObject {
    Q_OBJECT
private slots:
    void a_finger_is_where_it_lies() {
        const Layout layout = of_model();
        ModelHapticPad model;
        model.touch(0, {-30.0, 20.0});
        model.touch(1, {45.0, -25.0}, true);
        Bytes report;
        while (!model.report(report))
            model.step();
        const auto fingers = fingers_in(layout, report);
        QVERIFY(fingers && fingers->pressed);
        QVERIFY(fingers->fingers[0].there && fingers->fingers[1].there && !fingers->fingers[2].there);
        QVERIFY(distance(fingers->fingers[0].place, Vec2(-30.0, 20.0)) < 0.04);
        QVERIFY(distance(fingers->fingers[1].place, Vec2(45.0, -25.0)) < 0.04);
        QVERIFY(fingers->fingers[0].contact != fingers->fingers[1].contact);
        report[0] = 2;
        QVERIFY(!fingers_in(layout, report)); // another report
        report[0] = 1;
        report.resize(9);
        QVERIFY(!fingers_in(layout, report)); // cut short
        QVERIFY(!fingers_in(layout, {}));
    }

    void the_waveform_is_the_nearest_to_the_sharpness_that_there_is() {
        const Ordinals all{5, 4, 3};
        QCOMPARE(int(all.of(1.0)), 5);
        QCOMPARE(int(all.of(0.5)), 4);
        QCOMPARE(int(all.of(0.0)), 3);
        const Ordinals click_only{5, 0, 0};
        QCOMPARE(int(click_only.of(0.0)), 5);
        QVERIFY(!Ordinals{}.any());
    }

    void the_list_is_read_from_the_device() {
        const Layout layout = of_model();
        ModelHapticPad model;
        const auto report_of = [&model](std::uint8_t id, std::size_t) { return model.feature(id); };
        Ordinals ordinals = read_ordinals(layout, report_of);
        QCOMPARE(int(ordinals.press), 3);
        QCOMPARE(int(ordinals.click), 4);
        QCOMPARE(int(ordinals.hover), 5);
        model.waveforms = {0x1006, 0x1004, 0x1005, 0x100B};
        ordinals = read_ordinals(layout, report_of);
        QVERIFY(ordinals.press == 3 && ordinals.click == 0 && ordinals.hover == 0);
        model.waveforms = {0x1004, 0x1005, 0x2001,
                           0x100B}; // all go on until they are stopped, or are the maker's own
        ordinals = read_ordinals(layout, report_of);
        QVERIFY(!ordinals.any());
        QVERIFY(!read_ordinals(layout, [](std::uint8_t, std::size_t) { return Bytes{}; }).any());
        QVERIFY(
            !read_ordinals(layout, [](std::uint8_t, std::size_t) { return Bytes{0x03}; }).any()); // cut short
    }

    /// HID Usage Tables: the number in the report stands for a waveform by the field's physical range, where it has one.
    void a_number_stands_for_a_waveform() {
        WaveformEntry entry;
        entry.logical_min = 3;
        entry.logical_max = 5;
        QCOMPARE(entry.usage_of(0x1003), std::int64_t{0x1003}); // no range: itself
        entry.physical_min = 3;
        entry.physical_max = 5;
        QCOMPARE(entry.usage_of(4), std::int64_t{4});
        entry.physical_min = 0x1003;
        entry.physical_max = 0x1007;
        for (const auto& [value, usage] :
             {std::pair{3, 0x1003}, {4, 0x1005}, {5, 0x1007}, {2, 0x1003}, {9, 0x1007}})
            QCOMPARE(entry.usage_of(value), std::int64_t{usage});
        entry.physical_min = 0;
        entry.physical_max = 4;
        QCOMPARE(entry.usage_of(5), std::int64_t{4});
        entry.physical_min = -4;
        entry.physical_max = 0;
        QCOMPARE(entry.usage_of(5), std::int64_t{0});
        QCOMPARE(entry.usage_of(3), std::int64_t{-4});
        entry.physical_min = 3;
        entry.physical_max = 7;
        QCOMPARE(entry.usage_of(5), std::int64_t{7});
        entry.physical_min = 1;
        entry.physical_max = 5;
        QCOMPARE(entry.usage_of(3), std::int64_t{1});
        entry.logical_max = 3; // one value
        QCOMPARE(entry.usage_of(3), std::int64_t{1});
        QCOMPARE(entry.usage_of(8), std::int64_t{1});
    }

    /// And is asked for once, whatever number it has.
    void a_list_is_in_one_report_or_in_several() {
        Layout layout = of_model();
        layout.waveforms.resize(3);
        for (const std::array<std::uint8_t, 3>& ids :
             {std::array<std::uint8_t, 3>{0, 0, 0}, {1, 1, 1}, {2, 2, 3}, {1, 2, 3}, {2, 1, 2}}) {
            for (std::size_t i = 0; i < 3; ++i)
                layout.waveforms[i].report_id = ids[i];
            Bytes asked;
            const Ordinals ordinals = read_ordinals(layout, [&asked](std::uint8_t id, std::size_t) {
                asked.push_back(id);
                return ModelHapticPad().feature(2);
            });
            QVERIFY(ordinals.press == 3 && ordinals.click == 4 && ordinals.hover == 5);
            Bytes wanted(ids.begin(), ids.end());
            wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
            QVERIFY(asked == wanted);
        }
    }

    void only_what_ends_by_itself_and_can_be_asked_for_is_noted_data() {
        QTest::addColumn<int>("ordinal");
        QTest::addColumn<int>("most");
        QTest::addColumn<QByteArray>("report");
        QTest::addColumn<bool>("noted");
        const auto row = [](const char* name, int ordinal, int most, const char* report, bool noted) {
            QTest::newRow(name) << ordinal << most << QByteArray::fromHex(report) << noted;
        };
        row("click", 3, 7, "03100000", true);
        row("with_its_page", 3, 7, "03100e00", true);
        row("of_another_page", 3, 7, "03100f00", false);
        row("the_makers_own", 3, 7, "03900000", false);
        row("stop", 2, 7, "03100000", false);
        row("the_last", 7, 7, "03100000", true);
        row("behind_the_last", 8, 7, "03100000", false);
        row("of_a_byte", 255, 1000, "03100000", true);
        row("of_more_than_a_byte", 259, 1000, "03100000", false);
        row("cut_short", 3, 7, "031000", false);
        row("longer", 3, 7, "0310000000", true);
    }
    void only_what_ends_by_itself_and_can_be_asked_for_is_noted() {
        QFETCH(int, ordinal);
        QFETCH(int, most);
        QFETCH(QByteArray, report);
        QFETCH(bool, noted);
        Layout layout = of_model();
        layout.trigger.ordinal.most = most;
        WaveformEntry entry;
        entry.ordinal = static_cast<std::uint32_t>(ordinal);
        entry.slot = {0, 32, 0, 0xFFFFFFFF};
        Ordinals noticed;
        note(layout, entry, Bytes(report.begin(), report.end()), noticed);
        QCOMPARE(int(noticed.click), noted ? ordinal : 0);
        QVERIFY(noticed.press == 0 && noticed.hover == 0);
    }

    /// A list of constants would say the same of whatever does not come.
    void what_did_not_come_is_no_waveform() {
        WaveformEntry entry;
        entry.ordinal = 3;
        entry.slot = {8, 8, 0, 255};
        entry.physical_min = entry.physical_max = 0x1003;
        for (const std::size_t bytes : {0u, 1u, 2u}) {
            Ordinals noticed;
            note(of_model(), entry, Bytes(bytes, 3), noticed);
            QCOMPARE(noticed.any(), bytes == 2);
        }
    }

    void a_third_of_the_sharpness_is_each_waveforms() {
        const Ordinals all{5, 4, 3};
        for (const auto& [sharpness, ordinal] :
             {std::pair{0.67, 5}, {2.0 / 3.0, 4}, {0.34, 4}, {1.0 / 3.0, 3}, {0.1, 3}})
            QCOMPARE(int(all.of(sharpness)), ordinal);
        QCOMPARE(int(Ordinals{0, 4, 3}.of(1.0)), 4);
        QCOMPARE(int(Ordinals{5, 0, 3}.of(0.5)), 5);
        QCOMPARE(int(Ordinals{5, 4, 0}.of(0.0)), 4);
        QCOMPARE(int(Ordinals{0, 0, 3}.of(0.5)), 3);
        QVERIFY(Ordinals({1, 0, 0}).any() && Ordinals({0, 1, 0}).any() && Ordinals({0, 0, 1}).any());
    }

    void a_tick_is_as_strong_as_told() {
        Layout layout = of_model();
        for (const auto& [amplitude, strength] : {std::pair{0.0, 0}, {0.5, 50}, {1.0, 100}}) {
            const Output report = trigger(layout, 4, amplitude);
            const Bytes wanted{3, 4, static_cast<std::uint8_t>(strength), 0, 0, 0};
            QVERIFY(Bytes(report.all().begin(), report.all().end()) == wanted);
        }
        layout.trigger.intensity.least = 20;
        QCOMPARE(int(trigger(layout, 4, 0.0).bytes[2]), 20);
        QCOMPARE(int(trigger(layout, 4, 0.5).bytes[2]), 60);
        const Output still = stop(layout);
        QVERIFY(Bytes(still.all().begin(), still.all().end()) == (Bytes{3, 2, 0, 0, 0, 0}));
    }

    void a_place_is_a_share_of_what_its_axis_can_say() {
        Layout layout = of_model();
        layout.pad->fingers[0].x.least = 1000;
        layout.pad->fingers[0].x.most = 3000;
        for (const auto& [value, x] :
             {std::pair{2000, 0.0}, {1000, -50.0}, {2500, 25.0}, {500, -50.0}, {4000, 50.0}}) {
            Bytes report(12);
            report[0] = 1;
            report[2] = static_cast<std::uint8_t>(value & 0xFF);
            report[3] = static_cast<std::uint8_t>(value >> 8);
            QVERIFY(std::abs(fingers_in(layout, report)->fingers[0].place.x - x) < 1e-9);
        }
    }

    void a_report_that_is_cut_short_tells_of_no_finger() {
        const Layout layout = of_model();
        for (std::size_t size = 0; size <= 12; ++size) {
            Bytes report(size, 0xFF);
            if (size > 0)
                report[0] = 1;
            const auto fingers = fingers_in(layout, report);
            QCOMPARE(fingers.has_value(), size >= 11);
            QCOMPARE(fingers && fingers->pressed, size == 12);
        }
    }

    void of_a_finger_of_which_a_part_did_not_come_nothing_is_told() {
        ModelHapticPad model;
        model.touch(0, {0.0, 0.0});
        Bytes report;
        while (!model.report(report))
            model.step();
        QVERIFY(fingers_in(of_model(), report));
        for (hid::Slot FingerSlots::*part :
             {&FingerSlots::tip, &FingerSlots::contact, &FingerSlots::x, &FingerSlots::y}) {
            Layout layout = of_model();
            (layout.pad->fingers[0].*part).bit = 88; // behind its end
            QVERIFY(!fingers_in(layout, report));
        }
    }

    void without_numbers_of_reports_and_of_contacts_fingers_are_told_apart_all_the_same() {
        Layout layout = of_model();
        layout.numbered = false;
        for (FingerSlots& places : layout.pad->fingers)
            places.contact = {};
        const auto fingers = fingers_in(layout, Bytes(11, 0x01));
        QVERIFY(fingers && fingers->fingers[0].there && fingers->fingers[1].there);
        QCOMPARE(fingers->fingers[0].contact, std::int64_t{0});
        QCOMPARE(fingers->fingers[1].contact, std::int64_t{1});
        layout.pad.reset();
        QVERIFY(!fingers_in(layout, Bytes(11, 0x01)));
    }
};

} // namespace haptics_reports_test

TP_TEST(haptics_reports_test, HapticsReportsTest, nothing)
#include "haptics_reports_test.moc"
