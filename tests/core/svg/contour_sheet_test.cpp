// SPDX-License-Identifier: Apache-2.0
#include "core/svg/contour_sheet.hpp"
#include "test_program.hpp"

#include <QTest>

#include <pugixml.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace contour_sheet_test {

using namespace tp;

namespace {

constexpr double tolerance = 1e-9; ///< what the contract promises, in units of the sheet

/// Random sheets: every kind of piece, open and closed, sizes from a nail to a wall.
class Sheets {
public:
    ContourSheet sheet(ContourSheet::Unit unit) {
        ContourSheet sheet{number(1.0, 5000.0), number(1.0, 5000.0), unit, {}};
        const std::size_t count = below(6);
        for (std::size_t i = 0; i < count; ++i)
            sheet.contours.push_back(contour("contour-" + std::to_string(i), sheet));
        return sheet;
    }

private:
    std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }
    double number(double from, double to) {
        return from + (to - from) * static_cast<double>(random_() >> 11u) * 0x1p-53;
    }
    Vec2 point(const ContourSheet& sheet) {
        return {number(-0.2, 1.2) * sheet.width, number(-0.2, 1.2) * sheet.height};
    }
    Piece piece(Vec2 a, Vec2 b, const ContourSheet& sheet) {
        switch (below(3)) {
        case 0:
            return Line{a, b};
        case 1:
            return Quadratic{a, point(sheet), b};
        default:
            return Cubic{a, point(sheet), point(sheet), b};
        }
    }
    Contour contour(std::string name, const ContourSheet& sheet) {
        Contour contour{std::move(name), {}, below(2) == 0};
        const Vec2 start = point(sheet);
        Vec2 at = start;
        const std::size_t count = 2 + below(20);
        for (std::size_t i = 0; i < count; ++i) {
            const Vec2 to = contour.closed && i + 1 == count ? start : point(sheet);
            contour.pieces.push_back(piece(at, to, sheet));
            at = to;
        }
        return contour;
    }

    std::mt19937_64 random_{7};
};

double distance(const Line& p, const Line& q) { return std::max(length(p.a - q.a), length(p.b - q.b)); }
double distance(const Quadratic& p, const Quadratic& q) {
    return std::max({length(p.a - q.a), length(p.control - q.control), length(p.b - q.b)});
}
double distance(const Cubic& p, const Cubic& q) {
    return std::max({length(p.a - q.a), length(p.control_a - q.control_a), length(p.control_b - q.control_b),
                     length(p.b - q.b)});
}

void compare(const Contour& a, const Contour& b) {
    QCOMPARE(b.name, a.name);
    QCOMPARE(b.closed, a.closed);
    QCOMPARE(b.pieces.size(), a.pieces.size());
    for (std::size_t i = 0; i < a.pieces.size(); ++i) {
        QCOMPARE(b.pieces[i].index(), a.pieces[i].index());
        std::visit(
            [&](const auto& p) {
                const auto& q = std::get<std::decay_t<decltype(p)>>(b.pieces[i]);
                QVERIFY(distance(p, q) <= tolerance);
            },
            a.pieces[i]);
    }
}

Contour stroke(std::string name) { return contour_through(std::move(name), {{1, 2}, {3, 5}}, false); }

Result<ContourSheet> there_and_back(const ContourSheet& sheet) {
    return sheet_from_svg(sheet_to_svg(sheet), sheet.unit);
}

Result<ContourSheet> with_names(const std::vector<std::string>& names) {
    ContourSheet sheet{10, 10, ContourSheet::Unit::millimetre, {}};
    for (const std::string& name : names)
        sheet.contours.push_back(stroke(name));
    return there_and_back(sheet);
}

} // namespace

class ContourSheetTest : public QObject {
    Q_OBJECT

private slots:
    void random_contours_come_back() {
        Sheets sheets;
        for (int i = 0; i < 500; ++i) {
            const auto unit = i % 2 == 0 ? ContourSheet::Unit::millimetre : ContourSheet::Unit::pixel;
            const ContourSheet sheet = sheets.sheet(unit);
            const auto back = there_and_back(sheet);
            QVERIFY2(back.ok(), back.error().c_str());
            QCOMPARE(back->width, sheet.width);
            QCOMPARE(back->height, sheet.height);
            QVERIFY(back->unit == unit);
            QCOMPARE(back->contours.size(), sheet.contours.size());
            for (std::size_t k = 0; k < sheet.contours.size(); ++k) {
                compare(sheet.contours[k], back->contours[k]);
                if (QTest::currentTestFailed())
                    return;
            }
        }
    }

    void numbers_come_back_to_the_last_bit() {
        const std::vector<Vec2> points = {{0.1, 1.0 / 3.0}, {1e-300, 1e300},
                                          {-0.0, 5e-324},   {123456789.123456789, -1e-7},
                                          {1e21, 1e22},     {0x1.fffffffffffffp+1023, 2.5}};
        const ContourSheet sheet{
            0.1, 1.0 / 3.0, ContourSheet::Unit::millimetre, {contour_through("a", points, false)}};
        const auto back = there_and_back(sheet);
        QVERIFY2(back.ok(), back.error().c_str());
        QCOMPARE(back->width, 0.1);
        QCOMPARE(back->height, 1.0 / 3.0);
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            QVERIFY(end_of(back->contours[0].pieces[i]) == points[i + 1]);
    }

    void closed_contours_keep_their_last_piece() {
        const Contour triangle = contour_through("triangle", {{0, 0}, {5, 0}, {0, 5}}, true);
        const auto back = there_and_back({10, 10, ContourSheet::Unit::millimetre, {triangle}});
        QVERIFY(back.ok());
        compare(triangle, back->contours[0]);
        // Open, though its ends meet.
        Contour open = triangle;
        open.closed = false;
        const auto again = there_and_back({10, 10, ContourSheet::Unit::millimetre, {open}});
        QVERIFY(again.ok());
        compare(open, again->contours[0]);
    }

    void dots_come_back() {
        const Contour open = contour_through("open", {{2, 3}}, false);
        const Contour closed = contour_through("closed", {{2, 3}}, true);
        const auto back = there_and_back({10, 10, ContourSheet::Unit::millimetre, {open, closed}});
        QVERIFY2(back.ok(), back.error().c_str());
        QCOMPARE(back->contours.size(), std::size_t{2});
        compare(open, back->contours[0]);
        compare(closed, back->contours[1]);
    }

    void straight_pieces_of_length_zero_are_left_out() {
        const auto back = there_and_back({10,
                                          10,
                                          ContourSheet::Unit::millimetre,
                                          {contour_through("a", {{1, 1}, {1, 1}, {2, 2}, {2, 2}}, false)}});
        QVERIFY(back.ok());
        compare(contour_through("a", {{1, 1}, {2, 2}}, false), back->contours[0]);
    }

    void pieces_that_are_not_finite_and_empty_contours_are_left_out() {
        Contour contour = stroke("a");
        contour.pieces.emplace_back(Line{{3, 5}, {std::nan(""), 0}});
        const auto back = there_and_back(
            {10, 10, ContourSheet::Unit::millimetre, {contour, Contour{"b", {}, true}, stroke("c")}});
        QVERIFY2(back.ok(), back.error().c_str());
        QCOMPARE(back->contours.size(), std::size_t{2});
        compare(stroke("a"), back->contours[0]);
        compare(stroke("c"), back->contours[1]);
    }

    void pieces_that_do_not_join_are_joined() {
        const Contour torn{"a", {Line{{0, 0}, {1, 0}}, Line{{1, 2}, {3, 2}}}, false};
        const auto back = there_and_back({10, 10, ContourSheet::Unit::millimetre, {torn}});
        QVERIFY(back.ok());
        compare(contour_through("a", {{0, 0}, {1, 0}, {1, 2}, {3, 2}}, false), back->contours.at(0));
    }

    void hostile_names_come_back_data() {
        QTest::addColumn<QByteArray>("name");
        QTest::newRow("plain") << QByteArray("mouth");
        QTest::newRow("with_space") << QByteArray("left eye of Anna");
        QTest::newRow("only_spaces") << QByteArray("   ");
        QTest::newRow("space_at_both_ends") << QByteArray(" eye ");
        QTest::newRow("markup") << QByteArray("</path><script>alert('1')</script>");
        QTest::newRow("quotes_and_ampersands") << QByteArray("\"'&amp;&#65;<>");
        QTest::newRow("line_breaks_and_tabs") << QByteArray("a\nb\r\nc\td");
        QTest::newRow("control_characters") << QByteArray("\x01\x02\x1F\x7F");
        QTest::newRow("zero_byte") << QByteArray("a\0b", 3);
        QTest::newRow("percent") << QByteArray("50%20 %41%zz%");
        QTest::newRow("korean") << QByteArray("왼쪽 눈");
        QTest::newRow("emoji_with_joiners") << QByteArray("👩‍👧 👁️");
        QTest::newRow("right_to_left") << QByteArray("עין \xE2\x80\xAEשמאל");
        QTest::newRow("combining_marks") << QByteArray("A\xCC\x81nna e\xCC\x88");
        QTest::newRow("byte_order_mark") << QByteArray("\xEF\xBB\xBF"
                                                       "eye");
        QTest::newRow("non_characters") << QByteArray("\xEF\xBF\xBE\xEF\xBF\xBF");
        QTest::newRow("next_line_U+0085") << QByteArray("a\xC2\x85"
                                                        "b");
        QTest::newRow("highest_code_point") << QByteArray("\xF4\x8F\xBF\xBF");
        QTest::newRow("looks_numbered") << QByteArray("eye 2");
        QTest::newRow("looks_like_ours") << QByteArray("contour 1");
        QTest::newRow("comment_end") << QByteArray("-->]]>");
        QTest::newRow("style_injection") << QByteArray("a;display:none");
        QTest::newRow("10_000_letters") << QByteArray(10'000, 'x');
    }
    void hostile_names_come_back() {
        QFETCH(QByteArray, name);
        const auto back = with_names({"first", name.toStdString(), "last"});
        QVERIFY2(back.ok(), back.error().c_str());
        QCOMPARE(back->contours.size(), std::size_t{3});
        QCOMPARE(back->contours[1].name, name.toStdString());
    }

    void names_that_would_share_an_id_come_back() {
        const std::vector<std::string> names = {"left eye", "left_eye", "left\teye", "left_eye_2",
                                                "left\neye"};
        const auto back = with_names(names);
        QVERIFY2(back.ok(), back.error().c_str());
        for (std::size_t i = 0; i < names.size(); ++i)
            QCOMPARE(back->contours[i].name, names[i]);
    }

    void bytes_that_are_no_utf8_become_replacement_characters() {
        const auto back = with_names({"a\xFF"
                                      "b",
                                      "\xC0\x80", "\xED\xA0\x80"});
        QVERIFY2(back.ok(), back.error().c_str());
        QCOMPARE(back->contours[0].name, std::string("a\xEF\xBF\xBD"
                                                     "b"));
    }

    void names_are_made_unique() {
        const auto back =
            with_names({"eye", "eye", "eye 2", "eye", "", "", "contour 1", "contour", "contour"});
        QVERIFY2(back.ok(), back.error().c_str());
        const std::vector<std::string> expected = {
            "eye", "eye 3", "eye 2", "eye 4", "contour 3", "contour 4", "contour 1", "contour", "contour 2"};
        std::vector<std::string> names;
        for (const Contour& contour : back->contours)
            names.push_back(contour.name);
        QCOMPARE(std::set<std::string>(names.begin(), names.end()).size(), names.size());
        QCOMPARE(names, expected);
    }

    void who_renames_an_element_means_it() {
        std::string text = sheet_to_svg({10, 10, ContourSheet::Unit::millimetre, {stroke("left eye")}});
        const std::size_t at = text.find("id=\"left_eye\"");
        QVERIFY(at != std::string::npos);
        text.replace(at, 13, "id=\"mouth\"");
        const auto sheet = sheet_from_svg(text);
        QVERIFY(sheet.ok());
        QCOMPARE(sheet->contours[0].name, std::string("mouth"));
    }

    void a_drawing_program_finds_what_it_expects() {
        const std::string text =
            sheet_to_svg({210, 297, ContourSheet::Unit::millimetre, {stroke("left eye")}});
        pugi::xml_document document;
        QVERIFY(document.load_string(text.c_str()));
        const auto root = document.child("svg");
        QCOMPARE(root.attribute("xmlns").value(), "http://www.w3.org/2000/svg");
        QCOMPARE(root.attribute("width").value(), "210mm");
        QCOMPARE(root.attribute("height").value(), "297mm");
        QCOMPARE(root.attribute("viewBox").value(), "0 0 210 297");
        QVERIFY(*root.child("title").text().get() != '\0');
        const auto path = root.child("path");
        QCOMPARE(path.attribute("id").value(), "left_eye");
        QCOMPARE(path.attribute("d").value(), "M 1 2 L 3 5");
        const std::string style = path.attribute("style").value();
        QVERIFY(style.find("fill:none") != std::string::npos);
        QVERIFY(style.find("stroke-width:0.5") != std::string::npos);
        const std::string pixels = sheet_to_svg({640, 480, ContourSheet::Unit::pixel, {stroke("a")}});
        QVERIFY(pixels.find("width=\"640px\"") != std::string::npos);
        QVERIFY(pixels.find("stroke-width:2;") != std::string::npos);
    }

    void a_sheet_without_size_is_written_but_not_read() {
        for (const double size : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
            const auto back = there_and_back({size, 10, ContourSheet::Unit::millimetre, {}});
            QVERIFY(!back.ok());
            QVERIFY(back.error().ends_with('.'));
        }
    }

    void scene_has_its_origin_at_the_centre_and_y_up() {
        const ContourSheet sheet{200,
                                 100,
                                 ContourSheet::Unit::millimetre,
                                 {contour_through("a", {{0, 0}, {200, 100}, {100, 40}}, false)}};
        const Scene scene = scene_from_sheet(sheet);
        QCOMPARE(scene.width_mm, 200.0);
        QCOMPARE(scene.height_mm, 100.0);
        QCOMPARE(scene.contours[0].name, std::string("a"));
        QVERIFY(start_of(scene.contours[0].pieces[0]) == Vec2(-100, 50));
        QVERIFY(end_of(scene.contours[0].pieces[0]) == Vec2(100, -50));
        QVERIFY(end_of(scene.contours[0].pieces[1]) == Vec2(0, 10));
    }

    void scene_and_sheet_are_each_others_inverse() {
        Sheets sheets;
        for (int i = 0; i < 100; ++i) {
            const ContourSheet sheet = sheets.sheet(ContourSheet::Unit::millimetre);
            const ContourSheet back = sheet_from_scene(scene_from_sheet(sheet));
            QCOMPARE(back.width, sheet.width);
            QCOMPARE(back.height, sheet.height);
            QVERIFY(back.unit == ContourSheet::Unit::millimetre);
            for (std::size_t k = 0; k < sheet.contours.size(); ++k) {
                compare(sheet.contours[k], back.contours[k]);
                if (QTest::currentTestFailed())
                    return;
            }
        }
    }

    void pixels_are_no_place_on_a_surface() {
        const Scene scene = scene_from_sheet({640, 480, ContourSheet::Unit::pixel, {stroke("a")}});
        QVERIFY(scene.contours.empty());
        QCOMPARE(scene.width_mm, 0.0);
    }
};

} // namespace contour_sheet_test

TP_TEST(contour_sheet_test, ContourSheetTest, event_loop)
#include "contour_sheet_test.moc"
