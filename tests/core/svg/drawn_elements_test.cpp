// SPDX-License-Identifier: Apache-2.0
// What of a file is drawn, under which name, and what is refused in which words.
#include "drawn_sheet.hpp"
#include "test_program.hpp"

#include <QTest>

#include <string>
#include <vector>

namespace drawn_elements_test {

using namespace tp;
using namespace tp::testing;

class DrawnElementsTest : public QObject {
    Q_OBJECT

private slots:
    // What is drawn and what is not

    void left_out() {
        const auto contours =
            drawn("<defs><path d='M0 0L1 1'/></defs><symbol><path d='M0 0L1 1'/></symbol><clipPath><path "
                  "d='M0 0L1 1'/>"
                  "</clipPath><mask><g><path d='M0 0L1 1'/></g></mask><marker><path d='M0 0L1 "
                  "1'/></marker><pattern>"
                  "<path d='M0 0L1 1'/></pattern><text>M0 0</text><foreignObject><path d='M0 0L1 "
                  "1'/></foreignObject>"
                  "<use href='#seen'/><image href='a.png'/><x:path xmlns:x='urn:x' d='M0 0L1 1'/>"
                  "<!-- <path d='M0 0L1 1'/> --><path id='seen' d='M0 0L1 1'/>");
        QCOMPARE(contours.size(), std::size_t{1});
        QCOMPARE(contours[0].name, std::string("seen"));
    }

    void broken_elements_that_are_not_drawn_do_no_harm() {
        QVERIFY(drawn("<defs><path d='nonsense'/></defs><g display='none'><path d='nonsense'/></g>").empty());
    }

    void display_none_data() {
        QTest::addColumn<QByteArray>("attributes");
        QTest::addColumn<bool>("seen");
        QTest::newRow("attribute") << QByteArray("display='none'") << false;
        QTest::newRow("style") << QByteArray("style='fill:red;display:none'") << false;
        QTest::newRow("style_with_spaces")
            << QByteArray("style=' Display : NONE !important ; fill:red'") << false;
        QTest::newRow("style_beats_attribute") << QByteArray("display='none' style='display:inline'") << true;
        QTest::newRow("last_declaration_holds") << QByteArray("style='display:none;display:block'") << true;
        QTest::newRow("other_property") << QByteArray("style='-x-display:none;note:display'") << true;
        QTest::newRow("inline") << QByteArray("display='inline'") << true;
    }
    void display_none() {
        QFETCH(QByteArray, attributes);
        QFETCH(bool, seen);
        const std::string text = attributes.toStdString();
        const std::size_t expected = seen ? 1 : 0;
        QCOMPARE(drawn("<path d='M0 0L1 1' " + text + "/>").size(), expected);
        QCOMPARE(drawn("<g " + text + "><path d='M0 0L1 1'/></g>").size(), expected);
        QCOMPARE(read("<svg width='9' height='9' " + text + "><path d='M0 0L1 1'/></svg>").contours.size(),
                 expected);
    }

    void names() {
        const auto contours =
            drawn("<path d='M0 0L1 1'/><path id='left eye' d='M0 0L1 1'/><path id='contour 1' d='M0 0L1 1'/>"
                  "<path id='left eye' d='M0 0L1 1'/><path id=' ' d='M0 0L1 1'/>");
        const std::vector<std::string> expected = {"contour 2", "left eye", "contour 1", "left eye 2",
                                                   "contour 3"};
        QCOMPARE(contours.size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i)
            QCOMPARE(contours[i].name, expected[i]);
    }

    void elements_with_a_prefix() {
        const ContourSheet sheet =
            read("<?xml version='1.0'?><s:svg xmlns:s='http://www.w3.org/2000/svg' width='5' height='5'>"
                 "<s:g><s:path id='a' d='M0 0L1 1'/><path d='M0 0L1 1'/></s:g></s:svg>");
        QCOMPARE(sheet.contours.size(), std::size_t{1});
    }

    void moved_by_style() {
        expect_refusal(on_sheet("<g id='face' style='transform:translate(5px)'/>"), "face");
        QCOMPARE(drawn("<path style='transform:none' d='M0 0L1 1'/>").size(), std::size_t{1});
    }

    void utf16() {
        QByteArray bytes("\xFF\xFE");
        for (const QChar c : QString::fromUtf8(on_sheet("<path id='œil 目' d='M0 0L1 1'/>"))) {
            bytes.append(static_cast<char>(c.unicode() & 0xFF));
            bytes.append(static_cast<char>(c.unicode() >> 8));
        }
        QCOMPARE(read(bytes.toStdString()).contours.at(0).name, std::string("œil 目"));
    }

    // Files that are no drawings

    void refused_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("word");
        const auto row = [](const char* name, const QByteArray& text, const char* word) {
            QTest::newRow(name) << text << QByteArray(word);
        };
        row("nothing", "", "nothing in it");
        row("white_space", " \n ", "nothing in it");
        row("prose", "Dear Anna,", "nothing in it");
        row("zero_bytes", QByteArray(1000, '\0'), "not an SVG");
        row("a_jpeg", QByteArray("\xFF\xD8\xFF\xE0\x00\x10JFIF", 10), "not an SVG");
        row("compressed", "\x1F\x8B\x08", "svgz");
        row("html", "<html><body/></html>", "<html>");
        row("cut_off", "<svg width='5' height='5'>\n<path d='M0 0L1", "line 2");
        row("mismatched", "<svg width='5'\nheight='5'>\n<g></svg>", "line 3");
        row("two_attributes_run_together", "<svg width='5'height='5'/>", "line 1");
        row("no_size", "<svg/>", "how large");
        row("width_alone", "<svg width='5mm'/>", "how large");
        row("percent_alone", "<svg width='100%' height='100%'/>", "how large");
        row("width_zero", "<svg width='0' height='5'/>", "width");
        row("height_negative", "<svg width='5' height='-5mm'/>", "height");
        row("width_too_large", "<svg width='1e400' height='5'/>", "width");
        row("width_word", "<svg width='wide' height='5'/>", "wide");
        row("width_nan", "<svg width='nan' height='5'/>", "nan");
        row("width_em", "<svg width='5em' height='5'/>", "5em");
        row("width_cm_overflows", "<svg width='1e308cm' height='5'/>", "width");
        row("view_box_three_numbers", "<svg viewBox='0 0 5'/>", "viewBox");
        row("view_box_flat", "<svg width='5' height='5' viewBox='0 0 5 0'/>", "viewBox");
        row("view_box_negative", "<svg viewBox='0 0 -5 5'/>", "viewBox");
        row("view_box_words", "<svg viewBox='a b c d'/>", "viewBox");
        row("view_box_infinite", "<svg viewBox='0 0 1e400 5'/>", "viewBox");
        row("aspect_beyond_double", "<svg width='1e300' viewBox='0 0 1e-300 1'/>", "size");
        row("root_moved_wrongly", "<svg width='5' height='5' transform='jump'/>", "transform");
    }
    void refused() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, word);
        expect_refusal(text.toStdString(), word.toStdString());
    }

    /// A sentence is spoken: at most sixty bytes of a name, no half letter, no line break.
    void a_name_in_a_sentence_is_cut_between_letters_data() {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("said");
        const QByteArray letters(57, 'x');
        QTest::newRow("sixty_bytes") << letters + "abc" << letters + "abc\"";
        QTest::newRow("sixty_one_bytes") << letters + "abcd" << letters + "abc…";
        QTest::newRow("a_letter_across_the_end") << letters + "ab눈" << letters + "ab…";
        QTest::newRow("a_letter_at_the_end") << letters + "눈b" << letters + "눈…";
        QTest::newRow("half_a_letter_at_the_end") << letters + "a눈b" << letters + "a…";
        QTest::newRow("line_break") << QByteArray("left&#10;eye") << QByteArray("left eye");
        QTest::newRow("unit_separator") << QByteArray("left&#31;eye") << QByteArray("left eye");
        QTest::newRow("exclamation_mark_stays") << QByteArray("left!eye") << QByteArray("left!eye");
    }
    void a_name_in_a_sentence_is_cut_between_letters() {
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, said);
        expect_refusal(on_sheet("<path id='" + name.toStdString() + "' d='broken'/>"), said.toStdString());
    }

    void what_has_no_name_is_told_by_its_kind() {
        expect_refusal(on_sheet("<path d='broken'/>"), "The path without an id");
        expect_refusal(on_sheet("<g transform='broken'/>"), "The group without an id");
        expect_refusal(on_sheet("<rect id='frame' width='wide' height='broad'/>"),
                       "\"width\""); // the first of two
    }

    void a_number_too_small_to_be_told_from_zero_is_zero() {
        compare_points(corners(only("<line x1='1e-400' x2='-1e-4000' y2='3'/>")), {{0, 0}, {0, 3}});
    }

    void long_names_are_short_in_sentences() {
        const auto sheet =
            sheet_from_svg(on_sheet("<path id='" + std::string(100'000, 'x') + "' d='broken'/>"));
        QVERIFY(!sheet.ok());
        QVERIFY(sheet.error().size() < 200);
    }
};

} // namespace drawn_elements_test

TP_TEST(drawn_elements_test, DrawnElementsTest, event_loop)
#include "drawn_elements_test.moc"
