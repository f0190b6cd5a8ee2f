// SPDX-License-Identifier: Apache-2.0
#include "corpus.hpp"
#include "described_pads.hpp"
#include "layout_check.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>

namespace haptics_layout_test {

using namespace tp;
using namespace tp::haptics;

namespace {

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

    void a_trigger_is_one_number_that_can_be_sent_and_the_first_there_is() {
        Layout layout;
        for (const Bytes& item : {Bytes{0x91, 0x00}, Bytes{0x91, 0x03}, Bytes{0x81, 0x02},
                                  Bytes{0xB1, 0x02}}) // an array, a constant, what is told and what is set
            QVERIFY(found(with({0x09, 0x21, 0x91, 0x02}, {0x09, 0x21, item[0], item[1]}), layout)
                        .find("takes no ticks") != std::string::npos);
        Bytes two = model();
        const Bytes another{0x85, 0x04, 0x15, 0x00, 0x25, 0x07, 0x75,
                            0x08, 0x95, 0x01, 0x09, 0x21, 0x91, 0x02};
        two.insert(two.end() - 2, another.begin(), another.end());
        QCOMPARE(found(two, layout), std::string());
        QCOMPARE(int(layout.trigger.id), 3);
        QCOMPARE(layout.trigger.bytes, std::size_t(5));
    }

    void an_intensity_is_one_number_of_the_triggers_report_and_the_first_there_is() {
        const Bytes controller{0x85, 0x03, 0x05, 0x0E};
        for (const Bytes& before :
             {Bytes{0x91, 0x00}, Bytes{0x91, 0x03}, Bytes{0x81, 0x02}, Bytes{0xB1, 0x02}}) {
            Bytes items{0x15, 0x00, 0x25, 0x64, 0x75, 0x08, 0x95, 0x01, 0x09, 0x23};
            items.insert(items.end(), before.begin(), before.end());
            Bytes bytes = model();
            add(bytes, controller, items);
            Layout layout;
            QCOMPARE(found(bytes, layout), std::string());
            const unsigned output = before[0] == 0x91 ? 8u : 0u; // what was put before it
            QCOMPARE(layout.trigger.ordinal.bit, output);
            QCOMPARE(layout.trigger.intensity.bit, output + 8u);
        }
        Bytes bytes = model();
        add(bytes, {0x09, 0x21, 0x91, 0x02}, {0x85, 0x04, 0x25, 0x64, 0x09, 0x23, 0x91, 0x02, 0x85, 0x03});
        add(bytes, {0x25, 0x64, 0x09, 0x23, 0x91, 0x02, 0x25, 0x05},
            {0x09, 0x23, 0x91, 0x02}); // a second one
        Layout layout;
        QCOMPARE(found(bytes, layout), std::string());
        QCOMPARE(int(layout.trigger.id), 3);
        QCOMPARE(layout.trigger.intensity.bit, 8u);
        QCOMPARE(layout.trigger.intensity.most, std::int64_t{100});
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

    /// What else a maker has put into the list, and what is longer than a number can be.
    void only_ordinals_are_waveforms() {
        const Bytes list{0x75, 0x10, 0x95, 0x04, 0xB1, 0x02};
        Bytes bytes = model();
        add(bytes, list, {0x06, 0x00, 0xFF, 0x09, 0x03, 0x95, 0x01, 0xB1, 0x02}); // of a maker's own
        add(bytes, list, {0x1A, 0x03, 0x80, 0x2A, 0x03, 0x80, 0x95, 0x01, 0xB1, 0x02});
        Layout layout;
        QCOMPARE(found(bytes, layout), std::string());
        QCOMPARE(layout.waveforms.size(), std::size_t(5));
        QCOMPARE(layout.waveforms.back().ordinal, 0x8003u);
        QVERIFY(found(with(list, {0x75, 0x40, 0x95, 0x01, 0xB1, 0x02}), layout).find("which ticks it has") !=
                std::string::npos);
    }

    void a_list_is_of_numbers_that_can_be_asked_for_in_the_list_of_a_controller() {
        Layout layout;
        for (const Bytes& item : {Bytes{0xB1, 0x00}, Bytes{0x91, 0x02}, Bytes{0x81, 0x02}})
            QVERIFY(found(with({0x95, 0x04, 0xB1, 0x02}, {0x95, 0x04, item[0], item[1]}), layout)
                        .find("which ticks it has") != std::string::npos);
        Bytes bytes = with({0x09, 0x10, 0xA1, 0x02}, {0x09, 0x12, 0xA1, 0x02});
        const Bytes of_nobody{0x05, 0x0E, 0x09, 0x10, 0xA1, 0x02, 0x05, 0x0A, 0x19, 0x03, 0x29, 0x06,
                              0x15, 0x00, 0x26, 0xFF, 0x7F, 0x75, 0x10, 0x95, 0x04, 0xB1, 0x02, 0xC0};
        bytes.insert(bytes.end(), of_nobody.begin(), of_nobody.end());
        QVERIFY(found(bytes, layout).find("which ticks it has") != std::string::npos);
    }

    void thirty_two_waveforms_are_read_of_a_list_in_two_parts() {
        Bytes bytes = with({0x29, 0x06, 0x15, 0x00, 0x26, 0xFF, 0x7F, 0x75, 0x10, 0x95, 0x04},
                           {0x29, 0x16, 0x15, 0x00, 0x26, 0xFF, 0x7F, 0x75, 0x10, 0x95, 0x14});
        add(bytes, {0x95, 0x14, 0xB1, 0x02}, {0x19, 0x17, 0x29, 0x2A, 0xB1, 0x02}); // 3 to 22, and 23 to 42
        Layout layout;
        QCOMPARE(found(bytes, layout), std::string());
        QCOMPARE(layout.waveforms.size(), std::size_t(32));
        QCOMPARE(layout.waveforms.back().ordinal, 34u);
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
            Bytes long_one = model();
            const Bytes padding{0x75, 0x08, 0x95, static_cast<std::uint8_t>(bytes - 5), 0x91, 0x03};
            long_one.insert(long_one.end() - 2, padding.begin(), padding.end());
            Layout layout;
            QCOMPARE(found(long_one, layout).empty(), bytes == 64);
        }
    }

    void any_bytes_are_read() {
        std::mt19937 random(11);
        const Bytes pad = model();
        for (int i = 0; i < 30000; ++i) {
            std::string bytes(1, static_cast<char>((pad.size() + 3) / 4));
            bytes.append(reinterpret_cast<const char*>(pad.data()), pad.size());
            bytes.resize(1 + 4 * ((pad.size() + 3) / 4), '\0');
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

} // namespace haptics_layout_test

TP_TEST(haptics_layout_test, HapticsLayoutTest, nothing)
#include "haptics_layout_test.moc"
