// SPDX-License-Identifier: Apache-2.0
// What a descriptor says of the touch pad: its size, its fingers, its button.
#include "described_pads.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>

namespace touch_pad_layout_test {

using namespace tp;
using namespace tp::haptics;

class TouchPadLayoutTest : public QObject {
    Q_OBJECT
private slots:
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
        row("degrees", "550e6511", "550f6514", 0.0, 0.0);
        row("of_no_system", "550e6511", "550f6510", 0.0, 0.0);
        row("of_the_makers_own_system", "6511", "6519", 0.0, 0.0);
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

    /// Whichever axis comes first; what a second finger says of it is not asked.
    void a_pad_is_as_large_as_its_first_finger_says() {
        Bytes bytes = model();
        put(bytes, {0x09, 0x30, 0x81}, {0x09, 0x32, 0x81});
        put(bytes, {0x09, 0x31, 0x81}, {0x09, 0x30, 0x81});
        put(bytes, {0x09, 0x32, 0x81}, {0x09, 0x31, 0x81});
        Layout layout;
        QCOMPARE(found(bytes, layout), std::string());
        QVERIFY(layout.pad && distance(layout.pad->size, Vec2(60.0, 100.0)) < 1e-9);
        put(bytes, {0x46, 0xE8, 0x03}, {0x46, 0x20, 0x03}, second_finger);
        put(bytes, {0x46, 0x58, 0x02}, {0x46, 0xF4, 0x01}, second_finger);
        QCOMPARE(found(bytes, layout), std::string());
        QVERIFY(layout.pad && distance(layout.pad->size, Vec2(60.0, 100.0)) < 1e-9);
    }

    void a_pad_is_as_large_as_it_says_in_centimetres_and_tens_of_them() {
        for (const auto& [exponent, width, height] : {std::tuple{0, 10, 6}, {1, 1, 2}, {2, 1, 1}}) {
            Bytes bytes = with({0x55, 0x0E}, {0x55, static_cast<std::uint8_t>(exponent)});
            put(bytes, {0x46, 0xE8, 0x03}, {0x46, static_cast<std::uint8_t>(width), 0});
            put(bytes, {0x46, 0x58, 0x02}, {0x46, static_cast<std::uint8_t>(height), 0});
            Layout layout;
            QCOMPARE(found(bytes, layout), std::string());
            const double one = exponent == 0 ? 10.0 : exponent == 1 ? 100.0 : 1000.0;
            QVERIFY(layout.pad && distance(layout.pad->size, one * Vec2(width, height)) < 1e-9);
        }
    }

    void a_finger_that_lacks_its_tip_or_its_place_is_none() {
        for (const Bytes& part :
             {Bytes{0x09, 0x42, 0x81}, Bytes{0x09, 0x30, 0x81}, Bytes{0x09, 0x31, 0x81}}) {
            const Bytes other{0x09, 0x3F, 0x81};
            Bytes bytes = model();
            put(bytes, part, other, second_finger);
            Layout layout;
            QCOMPARE(found(bytes, layout), std::string());
            QVERIFY(layout.pad);
            QCOMPARE(layout.pad->fingers.size(), std::size_t(1));
            QCOMPARE(layout.pad->fingers[0].tip.bit, 0u);
            put(bytes, part, other);
            QCOMPARE(found(bytes, layout), std::string());
            QVERIFY(!layout.pad);
        }
    }

    /// Of more no pad makes one item.
    void eight_values_of_an_item_are_looked_at() {
        for (const unsigned buttons : {8u, 9u}) { // the first of them last
            Bytes items{0x05, 0x09};
            for (unsigned button = buttons; button > 0; --button)
                items.insert(items.end(), {0x09, static_cast<std::uint8_t>(button)});
            items.insert(items.end(),
                         {0x25, 0x01, 0x75, 0x01, 0x95, static_cast<std::uint8_t>(buttons), 0x81, 0x02});
            Bytes bytes = with({0x05, 0x09, 0x09, 0x01}, {0x05, 0x09, 0x09, 0x0A});
            add(bytes, {0x95, 0x07, 0x81, 0x03}, items);
            Layout layout;
            QCOMPARE(found(bytes, layout), std::string());
            QVERIFY(layout.pad);
            QCOMPARE(layout.pad->button.there(), buttons == 8);
            if (layout.pad->button.there())
                QCOMPARE(layout.pad->button.bit, 95u);
        }
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
};

} // namespace touch_pad_layout_test

TP_TEST(touch_pad_layout_test, TouchPadLayoutTest, nothing)
#include "touch_pad_layout_test.moc"
