// SPDX-License-Identifier: Apache-2.0
// How a HEIC file says that its picture is turned, number by number: boxes of each size, lists of each version, every turn.
#include "app/album/metadata/heif_boxes.hpp"
#include "audio/recordings/byte_source.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace heif_numbers_test {

using namespace tp;
using namespace std::string_literals;

namespace {

std::string number(std::uint64_t value, int bytes) {
    std::string text;
    for (int i = bytes - 1; i >= 0; --i)
        text += static_cast<char>((value >> (8 * i)) & 0xFF);
    return text;
}

std::string box(const std::string& type, const std::string& content) {
    return number(content.size() + 8, 4) + type + content;
}

std::string irot(int quarters) { return box("irot", number(static_cast<std::uint64_t>(quarters), 1)); }
std::string imir(int axis) { return box("imir", number(static_cast<std::uint64_t>(axis), 1)); }

struct Uses {
    std::uint64_t item = 1;
    std::vector<std::uint64_t> properties; ///< 1: the first
};

/// A file whose picture is an item of these properties.
struct Heif {
    std::vector<std::string> properties;
    std::vector<Uses> uses;
    std::uint64_t primary = 1;
    int pitm_version = 0, ipma_version = 0, ipma_flags = 0;

    std::string pitm() const {
        return box("pitm", number(static_cast<std::uint64_t>(pitm_version), 1) + number(0, 3) +
                               number(primary, pitm_version == 0 ? 2 : 4));
    }
    std::string ipco() const {
        std::string all;
        for (const std::string& property : properties)
            all += property;
        return box("ipco", all);
    }
    std::string ipma() const {
        std::string all = number(static_cast<std::uint64_t>(ipma_version), 1) +
                          number(static_cast<std::uint64_t>(ipma_flags), 3) + number(uses.size(), 4);
        const bool wide = (ipma_flags & 1) != 0;
        for (const Uses& one : uses) {
            all += number(one.item, ipma_version == 0 ? 2 : 4) + number(one.properties.size(), 1);
            for (const std::uint64_t property : one.properties)
                all += number(property, wide ? 2 : 1);
        }
        return box("ipma", all);
    }
    std::string file() const { return with(pitm() + box("iprp", ipco() + ipma())); }
    static std::string with(const std::string& in_meta) {
        return box("ftyp", "heic\0\0\0\0"s) + box("mdat", "picture") + box("meta", number(0, 4) + in_meta);
    }
};

int orientation(const std::string& file) { return heif_orientation(MemoryBytes(file)).value_or(0); }

int turned_by(const std::vector<std::string>& properties) {
    Heif heif{properties, {{1, {}}}};
    for (std::size_t i = 1; i <= properties.size(); ++i)
        heif.uses[0].properties.push_back(i);
    return orientation(heif.file());
}

std::string told(const std::vector<HeifBox>& boxes) {
    std::string text;
    for (const HeifBox& one : boxes)
        text += one.type + " " + std::to_string(one.begin) + " " + std::to_string(one.size) + "; ";
    return text;
}

std::string boxes(const std::string& bytes) { return told(boxes_in(MemoryBytes(bytes), 0, bytes.size())); }

} // namespace

class HeifNumbersTest : public QObject {
    Q_OBJECT
private slots:
    /// ISO/IEC 23008-12, 6.5.10 and 6.5.12: quarters are anticlockwise, axis 0 is level, and the order counts.
    void each_turn_and_mirror_in_their_order() {
        QCOMPARE(turned_by({}), 1);
        QCOMPARE(turned_by({irot(0)}), 1);
        QCOMPARE(turned_by({irot(1)}), 8);
        QCOMPARE(turned_by({irot(2)}), 3);
        QCOMPARE(turned_by({irot(3)}), 6);
        QCOMPARE(turned_by({imir(0)}), 4);
        QCOMPARE(turned_by({imir(1)}), 2);
        QCOMPARE(turned_by({irot(1), imir(0)}), 5);
        QCOMPARE(turned_by({imir(0), irot(1)}), 7);
        QCOMPARE(turned_by({irot(1), imir(1)}), 7);
        QCOMPARE(turned_by({imir(1), irot(1)}), 5);
        QCOMPARE(turned_by({irot(2), imir(0)}), 2);
        QCOMPARE(turned_by({imir(1), imir(0)}), 3);
        QCOMPARE(turned_by({irot(1), irot(1), irot(1)}), 6);
        QCOMPARE(turned_by({irot(3), imir(1), irot(3), imir(0)}), 3);
    }

    void other_bits_and_other_properties_turn_nothing() {
        QCOMPARE(turned_by({irot(0xFC)}), 1);
        QCOMPARE(turned_by({irot(0xFD)}), 8);
        QCOMPARE(turned_by({irot(0xFE)}), 3);
        QCOMPARE(turned_by({imir(0xFE)}), 4);
        QCOMPARE(turned_by({imir(0xFF)}), 2);
        QCOMPARE(turned_by({box("ispe", "\1\1\1\1"), irot(1), box("pixi", "\1")}), 8);
    }

    void lists_of_each_version_say_the_same() {
        for (const int pitm_version : {0, 1})
            for (const int ipma_version : {0, 1})
                for (const int flags : {0, 1, 2, 3}) {
                    Heif heif{{irot(1), imir(0), irot(2)}, {{6, {1}}, {5, {2, 3}}, {7, {}}, {5, {1}}}, 5};
                    heif.pitm_version = pitm_version;
                    heif.ipma_version = ipma_version;
                    heif.ipma_flags = flags;
                    QCOMPARE(orientation(heif.file()), 2); // of item 5, as it is said first
                    heif.primary = 6;
                    QCOMPARE(orientation(heif.file()), 8);
                    heif.primary = 7;
                    QCOMPARE(orientation(heif.file()), 1);
                    heif.primary = 8; // nothing is said of it
                    QCOMPARE(orientation(heif.file()), 1);
                }
        Heif wide{{irot(1)}, {{0x10005, {1}}, {5, {}}}, 0x10005};
        wide.pitm_version = wide.ipma_version = 1;
        QCOMPARE(orientation(wide.file()), 8);
        wide.primary = 5;
        QCOMPARE(orientation(wide.file()), 1);
    }

    /// The first bit says that a reader must know the property; 0 is none, and so is what is beyond them.
    void a_property_is_known_by_its_number() {
        Heif heif{std::vector<std::string>(200, irot(0)), {{1, {}}}};
        heif.properties[0] = irot(1);
        heif.properties[126] = irot(2);
        heif.properties[199] = irot(3);
        const auto turned = [&](std::uint64_t property, int flags) {
            heif.ipma_flags = flags;
            heif.uses[0].properties = {property};
            return orientation(heif.file());
        };
        QCOMPARE(turned(0, 0), 1);
        QCOMPARE(turned(1, 0), 8);
        QCOMPARE(turned(0x81, 0), 8);
        QCOMPARE(turned(127, 0), 3);
        QCOMPARE(turned(0xFF, 0), 3);
        QCOMPARE(turned(0x80, 0), 1);
        QCOMPARE(turned(0x8001, 1), 8);
        QCOMPARE(turned(200, 1), 6);
        QCOMPARE(turned(0x8000 | 200, 1), 6);
        QCOMPARE(turned(201, 1), 1);
        QCOMPARE(turned(0, 1), 1);
    }

    void a_list_is_read_up_to_a_megabyte_and_to_its_end() {
        constexpr std::size_t head = 8, entry = 4, most = 1 << 20; // bytes
        for (const bool within : {true, false}) {
            Heif heif{{irot(1)}, std::vector<Uses>((most - head) / entry - (within ? 1 : 0), Uses{7, {1}})};
            heif.uses.push_back({1, {1}});
            QCOMPARE(orientation(heif.file()), within ? 8 : 1);
        }
        Heif heif{{irot(1)}, {{7, {1}}}};
        std::string file = heif.file();
        file[file.size() - 5] = 9; // so many items, of which one is there
        QCOMPARE(orientation(file), 1);
        heif.primary = 0; // nor are those that are not there item 0
        file = heif.file();
        file[file.size() - 5] = 9;
        QCOMPARE(orientation(file), 1);
    }

    void where_a_part_is_missing_nothing_is_said() {
        const Heif heif{{irot(1)}, {{1, {1}}}};
        QCOMPARE(orientation(heif.file()), 8);
        QCOMPARE(orientation(Heif::with(box("iprp", heif.ipco() + heif.ipma()))), 0);
        QCOMPARE(orientation(Heif::with(heif.pitm())), 0);
        QCOMPARE(orientation(Heif::with(heif.pitm() + box("iprp", heif.ipma()))), 0);
        QCOMPARE(orientation(Heif::with(heif.pitm() + box("iprp", heif.ipco()))), 0);
        QCOMPARE(orientation(Heif::with("")), 0);
        QCOMPARE(orientation(box("ftyp", "heic")), 0);
        QCOMPARE(orientation(box("ftyp", "heic") + box("meta", "\0\0\0"s)), 0);
        QCOMPARE(orientation(box("mdat", "x") + heif.file()), 0); // no such file begins so
        QCOMPARE(orientation(box("ftyp", "heic") + box("mdat", "x")), 0);
    }

    /// ISO/IEC 14496-12, 4.2: 32 bits, 64 bits behind a 1, or 0: to the end.
    void boxes_of_each_size() {
        QCOMPARE(boxes(box("abcd", "12345") + box("efgh", "")), std::string("abcd 8 5; efgh 21 0; "));
        const std::string large = number(1, 4) + "long" + number(19, 8) + "abc";
        QCOMPARE(boxes(large + box("next", "1")), std::string("long 16 3; next 27 1; "));
        QCOMPARE(boxes(number(1, 4) + "none" + number(16, 8)), std::string("none 16 0; "));
        QCOMPARE(boxes(number(1, 4) + "less" + number(15, 8)), std::string());
        QCOMPARE(boxes(number(1, 4) + "more" + number(17, 8)), std::string());
        QCOMPARE(boxes(box("abcd", "") + number(0, 4) + "rest1234"), std::string("abcd 8 0; rest 16 4; "));
        for (const int size : {2, 7})
            QCOMPARE(boxes(box("abcd", "") + number(static_cast<std::uint64_t>(size), 4) + "bad.12345678"),
                     std::string("abcd 8 0; "));
        QCOMPARE(boxes(number(13, 4) + "fits12345"), std::string("fits 8 5; "));
        QCOMPARE(boxes(number(14, 4) + "long12345"), std::string());
        QCOMPARE(boxes(box("abcd", "") + "\0\0\0\x08"
                                         "cut"s),
                 std::string("abcd 8 0; "));
        const std::string all = "xx" + box("abcd", "12") + box("efgh", "34");
        QCOMPARE(told(boxes_in(MemoryBytes(all), 2, 10)), std::string("abcd 10 2; "));
        QCOMPARE(told(boxes_in(MemoryBytes(all), 2, 9)), std::string());
        QCOMPARE(told(boxes_in(MemoryBytes(all), 2, 1'000)), std::string("abcd 10 2; efgh 20 2; "));
        QCOMPARE(told(boxes_in(MemoryBytes(all), 1'000, 1'000)), std::string());
    }

    void no_more_than_a_thousand_boxes_are_looked_at() {
        std::string many;
        for (int i = 0; i < 1'001; ++i)
            many += box("abcd", "");
        QCOMPARE(boxes_in(MemoryBytes(many), 0, many.size()).size(), std::size_t{1'000});
    }

    void a_box_is_the_first_of_its_type() {
        const std::string bytes = box("a...", "1") + box("b...", "22") + box("b...", "333");
        const auto all = boxes_in(MemoryBytes(bytes), 0, bytes.size());
        QCOMPARE(box_of("b...", all)->size, std::uint64_t{2});
        QVERIFY(!box_of("c...", all));
    }
};

} // namespace heif_numbers_test

TP_TEST(heif_numbers_test, HeifNumbersTest, event_loop)
#include "heif_numbers_test.moc"
