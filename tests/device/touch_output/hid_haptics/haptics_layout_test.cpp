// SPDX-License-Identifier: Apache-2.0
#include "../../descriptor_lines.hpp"
#include "corpus.hpp"
#include "device/touch_output/hid_haptics/haptics_reports.hpp"
#include "device/touch_output/hid_haptics/model_haptic_pad.hpp"
#include "layout_check.hpp"
#include "places.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

using namespace tp;
using namespace tp::haptics;

namespace {

using Bytes = std::vector<std::uint8_t>;

/// Empty where it can be used, or why not.
std::string found(std::span<const std::uint8_t> descriptor, Layout& layout) {
    hid::ReportDescriptor parsed;
    if (hid::parse_report_descriptor(descriptor, parsed) != hid::DescriptorFault::none)
        return "cannot be read";
    const char* const why_not = find_layout(parsed, layout);
    return why_not == nullptr ? std::string() : why_not;
}

Layout of_model() {
    Layout layout;
    found(ModelHapticPad::descriptor(), layout);
    return layout;
}

/// The model's descriptor with `from` as `to`.
Bytes with(const Bytes& from, const Bytes& to) {
    Bytes bytes(ModelHapticPad::descriptor().begin(), ModelHapticPad::descriptor().end());
    for (auto at = bytes.begin();
         (at = std::search(at, bytes.end(), from.begin(), from.end())) != bytes.end(); ++at)
        std::copy(to.begin(), to.end(), at);
    return bytes;
}

/// The model's descriptor with `more` fingers besides, each as its first.
Bytes with_more_fingers(std::size_t more) {
    Bytes bytes(ModelHapticPad::descriptor().begin(), ModelHapticPad::descriptor().end());
    const Bytes end{0xC0};
    const auto begin = bytes.begin() + 8; // behind the application and its report's number
    const Bytes finger(begin, std::search(begin, bytes.end(), end.begin(), end.end()) + 1);
    for (std::size_t i = 0; i < more; ++i)
        bytes.insert(bytes.begin() + 8, finger.begin(), finger.end());
    return bytes;
}

/// A pen as Microsoft's guide for haptic pens has it: the list is of constants, whose physical range is the waveform.
Bytes pen() {
    return {0x05, 0x0D, 0x09, 0x02, 0xA1, 0x01, 0x05, 0x0E, 0x09, 0x01, 0xA1, 0x02, 0x85, 0x40, 0x09,
            0x10, 0xA1, 0x02, 0x05, 0x0A, 0x09, 0x03, 0x95, 0x01, 0x75, 0x08, 0x15, 0x03, 0x25, 0x03,
            0x37, 0x03, 0x10, 0x0E, 0x00, 0x47, 0x03, 0x10, 0x0E, 0x00, 0xB1, 0x03, 0xC0, 0x05, 0x0E,
            0x35, 0x00, 0x45, 0x00, 0x15, 0x00, 0x25, 0x03, 0x09, 0x21, 0x91, 0x02, 0xC0, 0xC0};
}

} // namespace

class HapticsLayoutTest : public QObject {
    Q_OBJECT
private slots:
    void a_pad_says_where_everything_is() {
        const Layout layout = of_model();
        QCOMPARE(int(layout.trigger.id), 3);
        QCOMPARE(layout.trigger.bytes, std::size_t(5));
        QVERIFY(layout.trigger.intensity.there());
        QCOMPARE(layout.waveforms.size(), std::size_t(4));
        QVERIFY(layout.pad && layout.pad->fingers.size() == 2 && layout.pad->button.there());
        QVERIFY(distance(layout.pad->size, Vec2(100.0, 60.0)) < 1e-9);
    }

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
        model.waveforms = {0x1004, 0x1005, 0x2001,
                           0x100B}; // all go on until they are stopped, or are the maker's own
        ordinals = read_ordinals(layout, report_of);
        QVERIFY(!ordinals.any());
        QVERIFY(!read_ordinals(layout, [](std::uint8_t, std::size_t) { return Bytes{}; }).any());
        QVERIFY(
            !read_ordinals(layout, [](std::uint8_t, std::size_t) { return Bytes{0x03}; }).any()); // cut short
    }

    void a_pen_whose_list_is_made_of_constants_can_be_used() {
        Layout layout;
        QCOMPARE(found(pen(), layout), std::string());
        QVERIFY(!layout.pad && !layout.trigger.intensity.there());
        const Ordinals ordinals = read_ordinals(layout, [](std::uint8_t, std::size_t) { return Bytes{3}; });
        QCOMPARE(int(ordinals.click), 3);
        const Output report = trigger(layout, ordinals.of(0.3), 0.5);
        QCOMPARE(report.size, std::size_t(2));
        QCOMPARE(int(report.bytes[0]), 0x40);
        QCOMPARE(int(report.bytes[1]), 3);
    }

    void what_cannot_be_used_says_why() {
        Layout layout;
        QVERIFY(found(ModelHapticPad::descriptor_without_trigger(), layout).find("takes no ticks") !=
                std::string::npos);
        QVERIFY(found(with({0x25, 0x07}, {0x25, 0x02}), layout).find("cannot be right") != std::string::npos);
        QVERIFY(found(with({0x09, 0x10, 0xA1}, {0x09, 0x11, 0xA1}), layout).find("which ticks it has") !=
                std::string::npos);
    }

    void a_pad_that_does_not_tell_its_size_ticks_without_telling_places() {
        Layout layout;
        QCOMPARE(found(with({0x65, 0x11}, {0x65, 0x00}), layout), std::string());
        QVERIFY(!layout.pad);
        QCOMPARE(found(with({0x55, 0x0E}, {0x55, 0x07}), layout), std::string()); // 100 000 km
        QVERIFY(!layout.pad);
    }

    /// 10 mm to a metre; centimetres or inches and no other unit.
    void a_pad_is_as_large_as_it_says_data() {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::addColumn<double>("width"); // 0: it is not believed
        QTest::addColumn<double>("height");
        const auto row = [](const char* name, const char* from, const char* to, double width, double height) {
            QTest::newRow(name) << QByteArray::fromHex(from) << QByteArray::fromHex(to) << width << height;
        };
        row("as_it_is", "6511", "6511", 100.0, 60.0);
        row("inches", "6511", "6513", 254.0, 152.4);
        row("degrees", "6511", "6514", 0.0, 0.0);
        row("of_no_system", "6511", "6510", 0.0, 0.0);
        row("squared", "6511", "6521", 0.0, 0.0);
        row("to_the_minus_seventh", "6511", "6591", 0.0, 0.0);
        row("and_grams", "65113500", "66110134", 0.0, 0.0);
        row("narrow", "46e803", "466400", 10.0, 60.0);
        row("too_narrow", "46e803", "466300", 0.0, 0.0);
        row("wide", "46e803", "461027", 1000.0, 60.0);
        row("too_wide", "46e803", "461127", 0.0, 0.0);
        row("too_flat", "465802", "466300", 0.0, 0.0);
        row("not_from_0", "350046", "356446", 90.0, 50.0);
    }
    void a_pad_is_as_large_as_it_says() {
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        QFETCH(double, width);
        QFETCH(double, height);
        Layout layout;
        QCOMPARE(found(with(Bytes(from.begin(), from.end()), Bytes(to.begin(), to.end())), layout),
                 std::string());
        QCOMPARE(layout.pad.has_value(), width > 0.0);
        if (layout.pad)
            QVERIFY(distance(layout.pad->size, Vec2(width, height)) < 1e-9);
    }

    void eight_fingers_are_read_of_one_that_tells_of_more() {
        for (const std::size_t more : {0u, 5u, 6u, 7u, 12u}) {
            Layout layout;
            QCOMPARE(found(with_more_fingers(more), layout), std::string());
            QVERIFY(layout.pad);
            QCOMPARE(layout.pad->fingers.size(), std::min<std::size_t>(2 + more, 8));
            QVERIFY(layout.pad->button.there());
            for (std::size_t i = 0; i < layout.pad->fingers.size(); ++i) {
                QCOMPARE(layout.pad->fingers[i].tip.bit, 40u * i);
                QCOMPARE(layout.pad->fingers[i].contact.bit, 40u * i + 4);
                QCOMPARE(layout.pad->fingers[i].x.bit, 40u * i + 8);
                QCOMPARE(layout.pad->fingers[i].y.bit, 40u * i + 24);
            }
        }
    }

    void thirty_two_waveforms_are_read_of_one_that_tells_of_more() {
        for (const unsigned count : {1u, 4u, 31u, 32u, 33u, 60u}) {
            Layout layout;
            const auto last = static_cast<std::uint8_t>(2 + count);
            const auto all = static_cast<std::uint8_t>(count);
            QCOMPARE(found(with({0x29, 0x06, 0x15, 0x00, 0x26, 0xFF, 0x7F, 0x75, 0x10, 0x95, 0x04},
                                {0x29, last, 0x15, 0x00, 0x26, 0xFF, 0x7F, 0x75, 0x10, 0x95, all}),
                           layout),
                     std::string());
            const unsigned read = std::min(count, 32u);
            QCOMPARE(layout.waveforms.size(), std::size_t{read});
            QCOMPARE(layout.waveforms.back().ordinal, 2 + read);
            QCOMPARE(layout.waveforms.back().slot.bit, 16 * (read - 1));
        }
    }

    void where_its_ordinals_begin_and_end_must_leave_room_for_a_tick_data() {
        QTest::addColumn<int>("least");
        QTest::addColumn<int>("most");
        QTest::addColumn<bool>("usable");
        QTest::newRow("from_2") << 2 << 7 << true;
        QTest::newRow("from_3") << 3 << 7 << false;
        QTest::newRow("from_below_0") << 0xFF << 7 << false;
        QTest::newRow("to_3") << 0 << 3 << true;
        QTest::newRow("to_2") << 0 << 2 << false;
    }
    void where_its_ordinals_begin_and_end_must_leave_room_for_a_tick() {
        QFETCH(int, least);
        QFETCH(int, most);
        QFETCH(bool, usable);
        Layout layout;
        const std::string why = found(with({0x15, 0x00, 0x25, 0x07}, {0x15, static_cast<std::uint8_t>(least),
                                                                      0x25, static_cast<std::uint8_t>(most)}),
                                      layout);
        QCOMPARE(why.empty(), usable);
        QVERIFY(usable || why.find("cannot be right") != std::string::npos);
    }
    void a_trigger_has_64_bytes_at_most() {
        for (const unsigned bytes : {64u, 65u}) { // padded to so many
            Bytes long_one(ModelHapticPad::descriptor().begin(), ModelHapticPad::descriptor().end());
            const Bytes padding{0x75, 0x08, 0x95, static_cast<std::uint8_t>(bytes - 5), 0x91, 0x03};
            long_one.insert(long_one.end() - 2, padding.begin(), padding.end());
            Layout layout;
            QCOMPARE(found(long_one, layout).empty(), bytes == 64);
        }
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
    void fingers_of_another_report_are_left_alone() {
        Bytes bytes = with_more_fingers(0);
        const Bytes finger{0x05, 0x0D, 0x09, 0x22, 0xA1, 0x02};
        const auto second = std::search(bytes.begin() + 9, bytes.end(), finger.begin(), finger.end());
        QVERIFY(second != bytes.end());
        const Bytes report_4{0x85, 0x04};
        bytes.insert(second, report_4.begin(), report_4.end());
        Layout layout;
        QCOMPARE(found(bytes, layout), std::string());
        QVERIFY(layout.pad);
        QCOMPARE(layout.pad->fingers.size(), std::size_t(1));
        QCOMPARE(int(layout.pad->report_id), 1);
        QVERIFY(!layout.pad->button.there());
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

    // The model, of which nothing is read back through what it is to try

    void the_model_says_what_it_has() {
        const std::string wanted = "d0005 1 in -1\nd0022 2 in 0\nd0022 2 in 0\n"
                                   "e0001 2 in 0\ne0010 2 in 3\ne0011 2 in 3\n"
                                   "i1 at 0: 1x1 [d0042] 0..1 0..0 0e0\n"
                                   "i1 at 1: 3x1 -[] 0..1 0..0 0e0\n"
                                   "i1 at 4: 1x4 [d0051] 0..15 0..0 0e0\n"
                                   "i1 at 8: 1x16 [10030] 0..4095 0..1000 11e-2\n"
                                   "i1 at 24: 1x16 [10031] 0..2047 0..600 11e-2\n"
                                   "i1 at 40: 1x1 [d0042] 0..1 0..0 0e0\n"
                                   "i1 at 41: 3x1 -[] 0..1 0..0 0e0\n"
                                   "i1 at 44: 1x4 [d0051] 0..15 0..0 0e0\n"
                                   "i1 at 48: 1x16 [10030] 0..4095 0..1000 11e-2\n"
                                   "i1 at 64: 1x16 [10031] 0..2047 0..600 11e-2\n"
                                   "i1 at 80: 1x1 [90001] 0..1 0..0 0e0\n"
                                   "i1 at 81: 7x1 -[] 0..1 0..0 0e0\n"
                                   "f2 at 0: 4x16 [a0003-a0006] 0..32767 0..0 0e0\n"
                                   "f2 at 64: 4x16 [a0003-a0006] 0..32767 0..0 0e0\n"
                                   "o3 at 0: 1x8 [e0021] 0..7 0..0 0e0\n"
                                   "o3 at 8: 1x8 [e0023] 0..100 0..0 0e0\n"
                                   "o3 at 16: 1x8 [e0024] 0..5 0..0 0e0\n"
                                   "o3 at 24: 1x16 [e0025] 0..1000 0..0 0e0";
        QCOMPARE(tp::testing::lines_of(ModelHapticPad::descriptor()), wanted);
    }
    void the_model_plays_as_long_as_it_is_told() {
        ModelHapticPad model;
        for (const int again : {0, 2}) { // once, and again so often
            model.receive(Bytes{3, 4, 100, static_cast<std::uint8_t>(again), 0, 0});
            int ms = 0;
            for (; model.felt() > 0.0 && ms < 1000; ++ms)
                model.step();
            QCOMPARE(ms, 10 * (1 + again));
        }
    }
    void the_model_tells_its_waveforms_and_how_long_each_is() {
        QCOMPARE(ModelHapticPad().feature(2),
                 (Bytes{0x06, 0x10, 0x03, 0x10, 0x08, 0x10, 0x04, 0x10, 10, 0, 10, 0, 10, 0, 10, 0}));
        QVERIFY(ModelHapticPad().feature(1).empty() && ModelHapticPad().feature(3).empty());
    }

    void any_bytes_are_read() {
        std::mt19937 random(11);
        const auto model = ModelHapticPad::descriptor();
        for (int i = 0; i < 30000; ++i) {
            std::string bytes(1, static_cast<char>((model.size() + 3) / 4));
            bytes.append(reinterpret_cast<const char*>(model.data()), model.size());
            bytes.resize(1 + 4 * ((model.size() + 3) / 4), '\0');
            for (int k = 0; k < 24; ++k)
                bytes.push_back(static_cast<char>(random()));
            for (unsigned k = 0; k < random() % 6; ++k)
                bytes[random() % bytes.size()] = static_cast<char>(random());
            const std::string complaint = test::complaint_about_haptics(bytes);
            QVERIFY2(complaint.empty(), complaint.c_str());
        }
        const auto seeds =
            tp::test::corpus(tp::test::in_source("tests/device/touch_output/hid_haptics/corpus"));
        QVERIFY(seeds.size() >= 4);
        for (const tp::test::Seed& seed : seeds)
            QCOMPARE(seed.name + ": " + test::complaint_about_haptics(seed.text), seed.name + ": ");
    }
};

QTEST_APPLESS_MAIN(HapticsLayoutTest)
#include "haptics_layout_test.moc"
