// SPDX-License-Identifier: Apache-2.0
#include "app/photo/tactile/tactile_sheet.hpp"
#include "core/geometry/flatten.hpp"
#include "drawn_faces.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <string>

using namespace tp;

namespace {

Rect block_of(const TactileLabel& label) { return {label.corner, label.corner + size_of(label.lines)}; }

/// The least distance of a label to a line's edge, by looking at every point of the lines.
double distance_to_lines(const TactileSheet& sheet, const TactileLabel& label) {
    const Rect block = block_of(label);
    double least = 1e9;
    for (const TactileLine& line : sheet.lines)
        for (const Vec2 p : flatten(line.path, {0.02, 5.0}).points)
            least = std::min(least, length(p - glm::clamp(p, block.min, block.max)) - 0.5 * line.width_mm);
    return least;
}

std::string problem_with(const TactileSheet& sheet) {
    constexpr double edge = TactileSheet::margin_mm - 1e-6;
    if (sheet.lines.empty() || sheet.lines.front().name != "orientation mark")
        return "no orientation mark";
    if (least_gap(sheet.lines) < 3.0)
        return "lines are " + std::to_string(least_gap(sheet.lines)) + " mm apart";
    for (const TactileLine& line : sheet.lines) {
        if (line.width_mm < 1.0 || line.width_mm > 1.5)
            return line.name + " is " + std::to_string(line.width_mm) + " mm wide";
        const double half = 0.5 * line.width_mm;
        for (const Vec2 p : flatten(line.path).points)
            if (p.x - half < edge || p.y - half < edge || p.x + half > sheet.width_mm - edge ||
                p.y + half > sheet.height_mm - edge)
                return line.name + " leaves the margins";
    }
    for (std::size_t i = 0; i < sheet.labels.size(); ++i) {
        const Rect block = block_of(sheet.labels[i]);
        if (block.min.x < edge || block.min.y < edge || block.max.x > sheet.width_mm - edge ||
            block.max.y > sheet.height_mm - edge)
            return sheet.labels[i].name + " leaves the margins";
        if (distance_to_lines(sheet, sheet.labels[i]) < 2.95)
            return sheet.labels[i].name + " is too close to a line";
        for (std::size_t k = 0; k < i; ++k) {
            const Rect other = block_of(sheet.labels[k]);
            if (block.min.x < other.max.x && other.min.x < block.max.x && block.min.y < other.max.y &&
                other.min.y < block.max.y)
                return "two labels overlap";
        }
        if (!sheet.title.empty() && block.max.y > sheet.title_place().y - TactileSheet::title_mm &&
            block.min.y < sheet.title_place().y + 1.0)
            return "a label lies in the title";
    }
    return {};
}

TactileOptions named(std::vector<std::string> names) {
    TactileOptions options;
    options.names = std::move(names);
    return options;
}

} // namespace

class TactileSheetTest : public QObject {
    Q_OBJECT
private slots:
    void one_face_fills_the_paper() {
        const auto sheet = make_tactile_sheet(one_drawn_face(), named({"Anna"}));
        QVERIFY(sheet.ok());
        QCOMPARE(problem_with(*sheet), std::string());
        QVERIFY(sheet->lines.size() >= 6);
        QCOMPARE(sheet->labels.size(), 1u);
        const auto outline = std::find_if(sheet->lines.begin(), sheet->lines.end(),
                                          [](const TactileLine& l) { return l.name == "outline"; });
        const Rect box = bounds_of(flatten(outline->path).points);
        // From margin to margin, less its own width; to scale.
        QVERIFY2(std::abs(box.width() + 1.5 - 190.0) < 0.3, qPrintable(QString::number(box.width())));
        const Rect in_pixels = bounds_of(flatten(one_drawn_face().faces[0].contours[4]).points);
        QVERIFY(std::abs(box.width() - in_pixels.width() * sheet->mm_per_px) < 0.01);
        QVERIFY(std::abs(box.height() - in_pixels.height() * sheet->mm_per_px) < 0.01);
    }
    void spacing_widths_margins_and_labels_hold_for_any_faces_on_any_paper() {
        int labels = 0, faces = 0;
        for (unsigned seed = 0; seed < 36; ++seed) {
            const Extraction extraction = drawn_faces(seed);
            TactileOptions options;
            for (std::size_t i = 0; i < extraction.faces.size(); ++i)
                options.names.push_back(i % 3 == 2 ? "Grandmother Rosalind" : "Anna");
            const Paper& paper = papers[seed % papers.size()];
            options.paper = seed % 3 ? paper : turned(paper);
            options.title = seed % 2 ? "All of us" : "";
            options.language = seed % 5 ? "en" : "de";
            const auto sheet = make_tactile_sheet(extraction, options);
            QVERIFY2(sheet.ok(), sheet.error().c_str());
            QVERIFY2(problem_with(*sheet).empty(), (std::to_string(seed) + ": " + problem_with(*sheet)).c_str());
            labels += static_cast<int>(sheet->labels.size());
            faces += static_cast<int>(extraction.faces.size());
            options.face = seed % extraction.faces.size();
            const auto single = make_tactile_sheet(extraction, options);
            QVERIFY2(problem_with(*single).empty(), (std::to_string(seed) + ": " + problem_with(*single)).c_str());
            QCOMPARE(single->labels.size(), 1u);
        }
        QVERIFY2(labels > faces * 3 / 4, qPrintable(QString("%1 of %2").arg(labels).arg(faces)));
    }
    void what_was_simplified_is_said() {
        Extraction shut = one_drawn_face();
        shut.faces[0].contours[0] = mapped(shut.faces[0].contours[0], [](Vec2 p) { return Vec2(p.x, 300.0 + 0.1 * (p.y - 300.0)); });
        const auto sheet = make_tactile_sheet(shut, {});
        QCOMPARE(problem_with(*sheet), std::string());
        QVERIFY(std::find(sheet->notes.begin(), sheet->notes.end(),
                          "The left eye is drawn as one line, because its two sides would be too close to be told apart.") !=
                sheet->notes.end());
    }
    void a_line_beside_another_is_left_out_and_said() {
        Extraction extraction = one_drawn_face();
        extraction.faces[0].contours.push_back(mapped(extraction.faces[0].contours[4], [](Vec2 p) { return p + Vec2(2, -2); }));
        extraction.faces[0].contours.back().name = "beard";
        const auto sheet = make_tactile_sheet(extraction, {});
        QCOMPARE(problem_with(*sheet), std::string());
        QVERIFY(std::any_of(sheet->notes.begin(), sheet->notes.end(),
                            [](const std::string& note) { return note.starts_with("The beard is left out"); }));
    }
    void any_name_gives_a_label_or_a_sentence() {
        for (const std::string& name :
             {std::string(), std::string("😀😀"), std::string(300, 'n'), std::string("محمد بن سلمان"), std::string("김민수"),
              std::string("\x00\xff\xfe", 3), std::string("Anna\nMaria\tO'Neill-Smith 3rd (Nana)")}) {
            const auto sheet = make_tactile_sheet(one_drawn_face(), named({name}));
            QVERIFY2(sheet.ok(), sheet.error().c_str());
            QCOMPARE(problem_with(*sheet), std::string());
            QVERIFY(name.empty() || !sheet->labels.empty() || !sheet->notes.empty());
        }
        const auto cut = make_tactile_sheet(one_drawn_face(), named({std::string(300, 'n')}));
        QCOMPARE(cut->labels[0].lines.size(), 3u);
        QVERIFY(cut->notes.back().ends_with("is cut off after 3 line(s) of braille.") ||
                cut->notes.front().ends_with("is cut off after 3 line(s) of braille."));
    }
    void a_long_title_is_shortened() {
        TactileOptions options;
        options.title = std::string(500, 'W');
        const auto sheet = make_tactile_sheet(one_drawn_face(), options);
        QVERIFY(sheet->title.ends_with("…") && sheet->title.size() < 100);
    }
    void the_same_faces_give_the_same_sheet() {
        const auto one = make_tactile_sheet(drawn_faces(7), named({"Anna"}));
        const auto other = make_tactile_sheet(drawn_faces(7), named({"Anna"}));
        QCOMPARE(one->lines.size(), other->lines.size());
        for (std::size_t i = 0; i < one->lines.size(); ++i)
            QVERIFY(flatten(one->lines[i].path).points == flatten(other->lines[i].path).points);
    }
    void what_cannot_be_drawn_is_said() {
        Extraction none;
        none.problem = "No face was found in this picture.";
        QCOMPARE(make_tactile_sheet(none, {}).error(), none.problem);
        TactileOptions second;
        second.face = 1;
        QCOMPARE(make_tactile_sheet(one_drawn_face(), second).error(),
                 std::string("There is no face 2 in this picture; it has 1."));
        Extraction empty = one_drawn_face();
        empty.faces[0].contours.clear();
        QVERIFY(!make_tactile_sheet(empty, {}).ok());
        TactileOptions language;
        language.names = {"Anna"};
        language.language = "tlh";
        QVERIFY(!make_tactile_sheet(one_drawn_face(), language).ok());
    }
    void papers_by_name() {
        QCOMPARE(paper_named("A4")->height_mm, 297.0);
        QCOMPARE(paper_named("braille")->width_mm, 11.5 * 25.4);
        QVERIFY(!paper_named("a5"));
        QCOMPARE(turned(*paper_named("a3")).width_mm, 420.0);
    }
};

QTEST_GUILESS_MAIN(TactileSheetTest)
#include "tactile_sheet_test.moc"
