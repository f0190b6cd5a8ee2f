// SPDX-License-Identifier: Apache-2.0
#include "core/svg/sheet_names.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cstddef>
#include <string>
#include <vector>

namespace sheet_names_test {

using namespace tp;

class SheetNamesTest : public QObject {
    Q_OBJECT

private slots:
    void what_is_utf8_stays_data() {
        QTest::addColumn<QByteArray>("bytes");
        for (const char* bytes :
             {"\x01", "\x7F", "\xC2\x80", "\xDF\xBF", "\xE0\xA0\x80", "\xE1\x80\x80", "\xEC\xBF\xBF",
              "\xED\x9F\xBF", "\xEE\x80\x80", "\xEF\xBF\xBF", "\xF0\x90\x80\x80", "\xF1\x80\x80\x80",
              "\xF3\xBF\xBF\xBF", "\xF4\x8F\xBF\xBF"})
            QTest::newRow(QByteArray(bytes).toHex().constData()) << QByteArray(bytes);
    }
    void what_is_utf8_stays() {
        QFETCH(QByteArray, bytes);
        const std::string text = "a" + bytes.toStdString() + "b";
        QCOMPARE(svg::valid_utf8(text), text);
        QCOMPARE(svg::valid_utf8(bytes.toStdString()), bytes.toStdString());
    }

    /// Each byte that belongs to no letter becomes one sign; the letters beside it stay.
    void what_is_no_utf8_is_replaced_data() {
        QTest::addColumn<QByteArray>("bytes");
        for (const char* bytes :
             {"\x80", "\xBF", "\xC0\x80", "\xC1\xBF", "\xC2", "\xDF", "\xE0\x9F\xBF", "\xE0\x80\x80",
              "\xED\xA0\x80", "\xED\xBF\xBF", "\xE1\x80", "\xE1\xBF", "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80",
              "\xF5\x80\x80\x80", "\xF1\x80\x80", "\xFF", "\xFE", "\xF8\x88\x80\x80\x80"})
            QTest::newRow(QByteArray(bytes).toHex().constData()) << QByteArray(bytes);
    }
    void what_is_no_utf8_is_replaced() {
        QFETCH(QByteArray, bytes);
        std::string signs;
        for (int i = 0; i < bytes.size(); ++i)
            signs += "\xEF\xBF\xBD";
        QCOMPARE(svg::valid_utf8("a" + bytes.toStdString() + "b"), "a" + signs + "b");
        QCOMPARE(svg::valid_utf8(bytes.toStdString()), signs); // and where the text ends
    }

    void a_letter_that_breaks_off_takes_no_other_with_it() {
        QCOMPARE(svg::valid_utf8("\xE1\x80x"), std::string("\xEF\xBF\xBD\xEF\xBF\xBDx"));
        QCOMPARE(svg::valid_utf8("\xC2\xC2\x80"), std::string("\xEF\xBF\xBD\xC2\x80"));
        QCOMPARE(svg::valid_utf8("\xF1\x80\xC0\x80"),
                 std::string("\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD"));
    }

    void an_id_shows_what_xml_and_drawing_programs_can_hold() {
        const auto spelled = svg::spelled(
            {"mouth", "left eye", "tab\there", std::string("\x1F\x20\x21"), "\xEF\xBF\xBE", "50%"});
        const std::vector<std::string> ids = {"mouth", "left_eye", "tab_here", "__!", "_", "50%"};
        const std::vector<std::string> exact = {"", "left eye", "tab%09here", "%1F !", "%EF%BF%BE", ""};
        QCOMPARE(spelled.size(), ids.size());
        for (std::size_t i = 0; i < ids.size(); ++i) {
            QCOMPARE(spelled[i].id, ids[i]);
            QCOMPARE(spelled[i].data_name, exact[i]);
        }
    }

    void ids_that_would_be_shared_are_numbered_from_two() {
        const auto spelled = svg::spelled({"left eye", "left_eye", "left\teye", "left\neye"});
        QCOMPARE(spelled[1].id, std::string("left_eye")); // who bears it keeps it
        QCOMPARE(spelled[0].id, std::string("left_eye_2"));
        QCOMPARE(spelled[2].id, std::string("left_eye_3"));
        QCOMPARE(spelled[3].id, std::string("left_eye_4"));
    }

    void the_exact_name_counts_while_it_fits_the_id_data() {
        QTest::addColumn<QByteArray>("id");
        QTest::addColumn<QByteArray>("data_name");
        QTest::addColumn<QByteArray>("name");
        const auto row = [](const char* id, const char* data_name, const char* name) {
            QTest::newRow(id) << QByteArray(id) << QByteArray(data_name) << QByteArray(name);
        };
        row("left_eye", "left eye", "left eye");
        row("left_eye_2", "left eye", "left eye");
        row("left_eye_90", "left eye", "left eye");
        row("left_eye_", "left eye", "left_eye_");
        row("left_eye_x", "left eye", "left_eye_x");
        row("left_eye_2x", "left eye", "left_eye_2x");
        row("left_eye2", "left eye", "left_eye2");
        row("left_ey", "left eye", "left_ey");
        row("mouth", "left eye", "mouth");
        row("mouth_alone", "", "mouth_alone");
        row("_12", "", "_12");
        row(" ", "left eye", "");
        row("", "left eye", "");
        row("a_", "a%09", "a\t"); // what was written for a tab at the end
        row("100%", "100%25", "100%");
        row("%4", "%4", "%4"); // no code
        row("%G1", "%G1", "%G1");
        row("%1G", "%1G", "%1G");
    }
    void the_exact_name_counts_while_it_fits_the_id() {
        QFETCH(QByteArray, id);
        QFETCH(QByteArray, data_name);
        QFETCH(QByteArray, name);
        QCOMPARE(QByteArray::fromStdString(svg::name_from(id.toStdString(), data_name.toStdString())), name);
    }

    void numbers_go_on_where_a_name_is_taken() {
        std::vector<std::string> names = {"", "eye", "eye", "eye 2", "contour 2", "", "eye"};
        svg::make_unique(names);
        const std::vector<std::string> expected = {"contour 1", "eye",       "eye 3", "eye 2",
                                                   "contour 2", "contour 3", "eye 4"};
        QCOMPARE(names, expected);
    }
};

} // namespace sheet_names_test

TP_TEST(sheet_names_test, SheetNamesTest, event_loop)
#include "sheet_names_test.moc"
