// SPDX-License-Identifier: Apache-2.0
// Times, numbers and signs as photographs write them: the first and the last of each, and their neighbours.
#include "app/album/metadata/number_text.hpp"
#include "app/album/metadata/time_text.hpp"
#include "app/album/metadata/xmp_text.hpp"
#include "test_program.hpp"

#include <QTest>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace texts_test {

using namespace tp;

namespace {

QByteArray said(const std::optional<std::string>& time) {
    return QByteArray::fromStdString(time.value_or("nothing"));
}

std::string utf8(char32_t code) { return QString::fromUcs4(&code, 1).toStdString(); }

} // namespace

class TextsTest : public QObject {
    Q_OBJECT
private slots:
    void exif_says_when_data() {
        QTest::addColumn<QByteArray>("time");
        QTest::addColumn<QByteArray>("offset");
        QTest::addColumn<QByteArray>("said");
        const auto row = [](const char* time, const char* offset, const char* said) {
            QTest::addRow("%s%s", time, offset) << QByteArray(time) << QByteArray(offset) << QByteArray(said);
        };
        row("2026:05:01 10:15:00", "", "2026-05-01T10:15:00");
        row("2026:05:01 10:15:00", "+02:00", "2026-05-01T10:15:00+02:00");
        row("2026:05:01 10:15:00", " -0930 ", "2026-05-01T10:15:00-09:30");
        row("2026:05:01 10:15:00", "Z", "2026-05-01T10:15:00Z");
        row("2026:05:01 10:15:00", "+15:59", "2026-05-01T10:15:00+15:59");
        row("2026:05:01 10:15:00", "+16:00", "2026-05-01T10:15:00"); // farther than any place on Earth
        row("2026:05:01 10:15:00", "+02:60", "2026-05-01T10:15:00");
        row("2026:05:01 10:15:00", "+2", "2026-05-01T10:15:00");
        row("2026:05:01 10:15:00+01:00", "+02:00", "2026-05-01T10:15:00+01:00"); // its own counts
        row(" 2026:05:01 10:15:00 ", "", "2026-05-01T10:15:00");
        row("2026:05:01", "+02:00", "2026-05-01");
        row("2026:05:01 10:15", "", "2026-05-01T10:15:00");
        row("2026:05:01 10:15:07.75", "", "2026-05-01T10:15:07");
        row("2026:05:01 10:15:07,5", "", "2026-05-01T10:15:07");
        row("2026:05:01 00:00:00", "", "2026-05-01T00:00:00");
        row("2026:05:01 23:59:60", "", "2026-05-01T23:59:60"); // a leap second
        for (const char* none :
             {"2026:05:01 24:00:00", "2026:05:01 10:60:00", "2026:05:01 10:15:61", "2026:05:01 10:15:00 x",
              "2026:05:01T10:15:00", "2026-05-01 10:15:00", "2026:05:01 1:15:00", "2026:5:01 10:15:00",
              "0000:00:00 00:00:00", "", "2026:", "2026:05:01 10:"})
            row(none, "", "nothing");
    }
    void exif_says_when() {
        QFETCH(QByteArray, time);
        QFETCH(QByteArray, offset);
        QFETCH(QByteArray, said);
        QCOMPARE(texts_test::said(exif_time(time.toStdString(), offset.toStdString())), said);
    }

    void a_calendar_has_so_many_days() {
        constexpr std::array<int, 12> days{31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
        const auto is_day = [](int year, int month, int day) {
            return exif_time(QString::asprintf("%04d:%02d:%02d", year, month, day).toStdString(), "")
                .has_value();
        };
        for (int month = 1; month <= 12; ++month) {
            const int last = days[static_cast<std::size_t>(month - 1)];
            QVERIFY(is_day(2026, month, 1) && is_day(2026, month, last));
            QVERIFY(!is_day(2026, month, 0) && !is_day(2026, month, last + 1));
        }
        for (const auto& [year, leap] :
             {std::pair{2024, true}, {2026, false}, {1900, false}, {2000, true}, {2100, false}}) {
            QCOMPARE(is_day(year, 2, 29), leap);
            QVERIFY(!is_day(year, 2, 30));
        }
        QVERIFY(!is_day(0, 1, 1) && is_day(1, 1, 1) && !is_day(2026, 0, 1) && !is_day(2026, 13, 1));
    }

    void iptc_says_when() {
        QCOMPARE(said(iptc_time("20260501", "101500+0200")), "2026-05-01T10:15:00+02:00");
        QCOMPARE(said(iptc_time("2026-05-01", "10:15:00+02:00")), "2026-05-01T10:15:00+02:00");
        QCOMPARE(said(iptc_time("20260501", "101507")), "2026-05-01T10:15:07");
        QCOMPARE(said(iptc_time("20260501", "")), "2026-05-01");
        QCOMPARE(said(iptc_time("20260501", "1015")), "2026-05-01"); // half a time is none
        QCOMPARE(said(iptc_time("20260501", "256000")), "2026-05-01");
        QCOMPARE(said(iptc_time(std::string_view("20260501\0", 9), "")), "2026-05-01");
        for (const char* none : {"2026050", "202605011", "20260532", "2026:05:01", ""})
            QCOMPARE(said(iptc_time(none, "101500")), "nothing");
    }

    void xmp_says_when_as_far_as_it_knows() {
        QCOMPARE(said(xmp_time("2026")), "2026");
        QCOMPARE(said(xmp_time("0001")), "0001");
        QCOMPARE(said(xmp_time("2026-05")), "2026-05");
        QCOMPARE(said(xmp_time("2026-05-01")), "2026-05-01");
        QCOMPARE(said(xmp_time("2026-05-01T10:15")), "2026-05-01T10:15:00");
        QCOMPARE(said(xmp_time("2026-05-01T10:15:07.5-09:30")), "2026-05-01T10:15:07-09:30");
        for (const char* none :
             {"0000", "202", "20260", "2026-", "2026-13", "2026-00", "2026-05-", "2026-05-32", "2026-05-01T",
              "2026-05-01 10:15", "2026-05-01T10", "2026-05-01T10:15+16:00"})
            QCOMPARE(said(xmp_time(none)), "nothing");
    }

    void numbers_are_read_as_other_programs_write_them() {
        for (const auto& [text, number] :
             {std::pair{"0.5", 0.5}, {" +.25 ", 0.25}, {"-3", -3.0}, {"  1e3", 1000.0}})
            QCOMPARE(number_from(text).value_or(99.0), number);
        for (const char* none :
             {"", " ", "+", "+-5", "+ 5", "1,5", "1.5x", "x1", "1 2", "inf", "nan", "1e999", "\t1"})
            QVERIFY2(!number_from(none), none);
        for (const auto& [number, text] :
             {std::pair{0.5, "0.5"}, {1e21, "1000000000000000000000"}, {-0.001, "-0.001"}}) {
            QCOMPARE(number_text(number), std::string(text)); // some readers know no exponent
            QCOMPARE(*number_from(number_text(number)), number);
        }
        QCOMPARE(*number_from(number_text(5e-324)), 5e-324);
        QCOMPARE(*number_from(number_text(-1.7e308)), -1.7e308);
    }

    /// XML 1.0, 2.2: what it can hold, at each of its borders.
    void what_xml_cannot_hold_is_left_out() {
        for (const char32_t held : {U'\t', U'\n', U'\r', U'\x20', U'\x7F', U'\x80', U'\x7FF', U'\x800',
                                    U'\xD7FF', U'\xE000', U'\xFFFD', U'\x10000', U'\x10FFFF'}) {
            QCOMPARE(holdable("a" + utf8(held) + "b"), "a" + utf8(held) + "b");
            QCOMPARE(unescaped(escaped("a" + utf8(held) + "b")), "a" + utf8(held) + "b");
            const std::string decimal = "&#" + std::to_string(static_cast<unsigned>(held)) + ";";
            const std::string hexadecimal =
                "&#x" + QByteArray::number(static_cast<unsigned>(held), 16).toStdString() + ";";
            QCOMPARE(unescaped(decimal), utf8(held));
            QCOMPARE(unescaped("<" + hexadecimal + ">"), "<" + utf8(held) + ">");
        }
        for (const char32_t left_out :
             {U'\x01', U'\x08', U'\x0B', U'\x0C', U'\x0E', U'\x1F', U'\xFFFE', U'\xFFFF'}) {
            QCOMPARE(holdable("a" + utf8(left_out) + "b"), std::string("ab"));
            const std::string number = "&#" + std::to_string(static_cast<unsigned>(left_out)) + ";";
            QCOMPARE(unescaped(number), number); // not a character: as it is written
        }
        QCOMPARE(holdable("a\xFF\xC3"), std::string("a\xEF\xBF\xBD\xEF\xBF\xBD"));
    }

    void signs_of_markup_become_entities_and_back() {
        QCOMPARE(escaped("<a href=\"x\">&'\r\n\t"),
                 std::string("&lt;a href=&quot;x&quot;&gt;&amp;'&#13;&#10;&#9;"));
        QCOMPARE(unescaped("&lt;&gt;&amp;&quot;&apos;"), std::string("<>&\"'"));
        QCOMPARE(unescaped("&amp;lt;"), std::string("&lt;")); // once, not twice
        for (const char* kept : {"&", "&;", "&unknown;", "&#;", "&#x;", "&#xD800;", "&#1114112;", "&#12a;",
                                 "&lt", "& lt;", "&#0000000065;"}) // longer than any that is needed
            QCOMPARE(unescaped(kept), std::string(kept));
        QCOMPARE(unescaped("&#x10FFFF;"), utf8(U'\x10FFFF'));
        QCOMPARE(unescaped("&#00000065;"), std::string("A"));
        QCOMPARE(unescaped("a\r\nb\rc\r"), std::string("a\nb\nc\n"));
    }
};

} // namespace texts_test

TP_TEST(texts_test, TextsTest, event_loop)
#include "texts_test.moc"
