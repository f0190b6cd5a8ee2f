// SPDX-License-Identifier: Apache-2.0
// The files as other programs see them: the PDF rendered by poppler, the SVG through our own reader.
#include "app/photo/tactile/tactile_file.hpp"
#include "core/files/whole_file.hpp"
#include "core/geometry/flatten.hpp"
#include "core/svg/contour_sheet.hpp"
#include "drawn_faces.hpp"
#include "test_program.hpp"

#include <QImage>
#include <QPoint>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <string>

namespace tactile_file_test {

using namespace tp;

namespace {

constexpr double px_per_mm = 20.0;

TactileSheet sheet_on(const Paper& paper) {
    TactileOptions options;
    options.paper = paper;
    options.names = {"Anna"};
    options.title = "Anna <in> the \"garden\" & 정원";
    return make_tactile_sheet(one_drawn_face(), options).value();
}

bool has_poppler() { return !QStandardPaths::findExecutable("pdftoppm").isEmpty(); }

QByteArray output_of(const QString& program, const QStringList& words) {
    QProcess process;
    process.start(program, words);
    return process.waitForFinished(60'000) && process.exitCode() == 0 ? process.readAllStandardOutput() : QByteArray();
}

/// The page as poppler draws it, `px_per_mm`.
QImage rendered(const QString& pdf) {
    const QString stem = pdf + "-page";
    output_of("pdftoppm", {"-r", QString::number(25.4 * px_per_mm), "-gray", "-png", "-singlefile", pdf, stem});
    return QImage(stem + ".png").convertToFormat(QImage::Format_Grayscale8);
}

double darkness(const QImage& page, Vec2 mm) {
    const QPoint at(static_cast<int>(std::floor(mm.x * px_per_mm)), static_cast<int>(std::floor(mm.y * px_per_mm)));
    return page.valid(at) ? 1.0 - qGray(page.pixel(at)) / 255.0 : 0.0;
}

/// How much ink lies across the line at `at`, mm; `within` mm of it is looked at.
double width_across(const QImage& page, Vec2 at, Vec2 along, double within = 2.0) {
    const Vec2 across = Vec2(-along.y, along.x) / length(along);
    constexpr double step = 0.01;
    double sum = 0.0;
    for (double off = -within; off <= within; off += step)
        sum += step * darkness(page, at + off * across);
    return sum;
}

} // namespace

class TactileFileTest : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;

private slots:
    void the_page_has_the_papers_size() {
        if (!has_poppler())
            QSKIP("poppler-utils is not installed.");
        for (const Paper& paper : papers)
            for (const Paper& held : {paper, turned(paper)}) {
                const QString file = folder_.filePath("size.pdf");
                QVERIFY(write_tactile(file.toStdString(), sheet_on(held)).ok());
                const QString info = output_of("pdfinfo", {file});
                const auto size = QRegularExpression("Page size: +([0-9.]+) x ([0-9.]+) pts").match(info);
                QVERIFY2(size.hasMatch(), qPrintable(info));
                QVERIFY(info.contains(QRegularExpression("Pages: +1\n")));
                // Whole points: at most half of one off.
                QVERIFY(std::abs(size.captured(1).toDouble() * 25.4 / 72.0 - held.width_mm) < 0.18);
                QVERIFY(std::abs(size.captured(2).toDouble() * 25.4 / 72.0 - held.height_mm) < 0.18);
            }
    }
    void lines_and_dots_are_printed_in_their_true_size_and_place() {
        if (!has_poppler())
            QSKIP("poppler-utils is not installed.");
        const TactileSheet sheet = sheet_on(papers[0]);
        const QString file = folder_.filePath("sheet.pdf");
        QVERIFY(write_tactile(file.toStdString(), sheet).ok());
        const QImage page = rendered(file);
        QVERIFY(!page.isNull());
        for (const TactileLine& line : sheet.lines) {
            const Polyline flat = flatten(line.path);
            const double at = 0.37 * length_of(flat);
            const Vec2 here = point_along(flat, at);
            const double width = width_across(page, here, point_along(flat, at + 0.1) - here);
            QVERIFY2(std::abs(width - line.width_mm) < 0.05,
                     qPrintable(QString("%1: %2").arg(line.name.c_str()).arg(width)));
            for (double share = 0.0; share <= 1.0; share += 0.01)
                QVERIFY(darkness(page, point_along(flat, share * length_of(flat))) > 0.9);
        }
        for (const Vec2 dot : dots_of(sheet.labels[0].lines, sheet.labels[0].corner)) {
            QVERIFY(std::abs(width_across(page, dot, {0, 1}, 1.2) - 1.5) < 0.06);
            QVERIFY(std::abs(width_across(page, dot, {1, 0}, 1.2) - 1.5) < 0.06);
        }
        // Nothing black outside of the margins.
        for (int y = 0; y < page.height(); y += 2)
            for (int x = 0; x < page.width(); x += 2) {
                const bool inside = x > 9.9 * px_per_mm && y > 9.9 * px_per_mm &&
                                    x < page.width() - 9.9 * px_per_mm && y < page.height() - 9.7 * px_per_mm;
                QVERIFY(inside || qGray(page.pixel(x, y)) > 200);
            }
    }
    void the_title_can_be_read_and_is_no_black_line() {
        if (!has_poppler())
            QSKIP("poppler-utils is not installed.");
        const QString file = folder_.filePath("title.pdf");
        TactileSheet sheet = sheet_on(papers[0]);
        sheet.title = "Anna <in> the garden";
        QVERIFY(write_tactile(file.toStdString(), sheet).ok());
        QVERIFY(output_of("pdftotext", {file, "-"}).contains("Anna <in> the garden"));
        const QImage page = rendered(file);
        int darkest = 255;
        for (int y = static_cast<int>((sheet.title_place().y - 4.0) * px_per_mm); y < page.height(); ++y)
            for (int x = 0; x < page.width(); ++x)
                darkest = std::min(darkest, qGray(page.pixel(x, y)));
        QVERIFY(darkest > 100 && darkest < 200);
    }
    void the_drawing_holds_the_same_lines_in_mm() {
        const TactileSheet sheet = sheet_on(papers[1]);
        const auto read = sheet_from_svg(tactile_svg(sheet));
        QVERIFY2(read.ok(), read.error().c_str());
        QCOMPARE(read->width, 215.9);
        QCOMPARE(read->height, 279.4);
        const std::size_t dots = dots_of(sheet.labels[0].lines, sheet.labels[0].corner).size();
        QCOMPARE(read->contours.size(), sheet.lines.size() + dots);
        for (std::size_t i = 0; i < sheet.lines.size(); ++i) {
            const Polyline other = flatten(read->contours[i]);
            QCOMPARE(read->contours[i].closed, sheet.lines[i].path.closed);
            for (const Vec2 p : flatten(sheet.lines[i].path).points)
                QVERIFY(distance_to(other, p) < 0.02);
        }
        const Rect dot = bounds_of(flatten(read->contours.back()).points);
        QVERIFY(std::abs(dot.width() - 1.5) < 0.01);
        const std::string text = tactile_svg(sheet);
        QVERIFY(text.find("stroke-width:1.5") != std::string::npos && text.find("stroke-width:1\"") != std::string::npos);
        QVERIFY(text.find("Anna &lt;in&gt; the \"garden\" &amp; 정원") != std::string::npos);
        QVERIFY(text.find("width=\"215.9mm\"") != std::string::npos);
    }
    void the_same_sheet_is_the_same_file() {
        const TactileSheet sheet = sheet_on(papers[0]);
        QVERIFY(tactile_pdf(sheet) == tactile_pdf(sheet));
        QVERIFY(tactile_pdf(sheet).find("/CreationDate (D:20000101000000") != std::string::npos);
        QVERIFY(tactile_svg(sheet) == tactile_svg(sheet));
    }
    void a_file_of_another_kind_and_a_folder_that_is_not_there_are_said() {
        const TactileSheet sheet = sheet_on(papers[0]);
        QVERIFY(write_tactile(folder_.filePath("a.doc").toStdString(), sheet).error().starts_with(
            "A tactile sheet is written as .pdf or .svg"));
        QVERIFY(write_tactile("/nowhere/at/all.svg", sheet).error().starts_with("The tactile sheet cannot be saved"));
    }
};

} // namespace tactile_file_test

TP_TEST(tactile_file_test, TactileFileTest, window)
#include "tactile_file_test.moc"
