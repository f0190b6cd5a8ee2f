// SPDX-License-Identifier: Apache-2.0
#include "corpus.hpp"
#include "described_pads.hpp"
#include "layout_check.hpp"
#include "places.hpp"

#include <QTest>

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>

using namespace tp;
using namespace tp::haptics;

namespace {

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
        Bytes two(ModelHapticPad::descriptor().begin(), ModelHapticPad::descriptor().end());
        const Bytes another{0x85, 0x04, 0x15, 0x00, 0x25, 0x07, 0x75,
                            0x08, 0x95, 0x01, 0x09, 0x21, 0x91, 0x02};
        two.insert(two.end() - 2, another.begin(), another.end());
        QCOMPARE(found(two, layout), std::string());
        QCOMPARE(int(layout.trigger.id), 3);
        QCOMPARE(layout.trigger.bytes, std::size_t(5));
    }

    void a_finger_lies_where_a_number_of_its_own_says() {
        for (const Bytes& other : {Bytes{0xB1, 0x02}, Bytes{0x91, 0x02}, Bytes{0x81, 0x00}, Bytes{0x81, 0x03},
                                   Bytes{0x81, 0x06}}) { // what is set, an array, a constant, a way
            Bytes bytes = with_more_fingers(0);
            Bytes items{0x05, 0x01, 0x75, 0x08, 0x95, 0x01, 0x09, 0x30};
            items.insert(items.end(), other.begin(), other.end());
            bytes.insert(std::find(bytes.begin() + 8, bytes.end(), 0xC0), items.begin(), items.end());
            Layout layout;
            QCOMPARE(found(bytes, layout), std::string());
            QVERIFY(layout.pad);
            QCOMPARE(layout.pad->fingers[0].x.bit, 8u);
            QCOMPARE(int(layout.pad->fingers[0].x.size), 16);
        }
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
