// SPDX-License-Identifier: Apache-2.0
// Two readers, one drawing: our contours lie where Qt draws them, in files as Inkscape writes them.
#include "core/svg/contour_sheet.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QFile>
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace qt_agrees_test {

using namespace tp;

namespace {

constexpr double px_per_unit = 10.0; ///< of the viewBox
/// Half of the widest stroke of these files, 0.4 units drawn by transforms that stretch by less than 1.6:
/// 0.32 units or 3.2 px. A pixel that is half covered lies at most half its diagonal, 0.71 px, beyond; Qt
/// flattens curves and rounds arcs by less than 0.5 px.
constexpr double most_px = 3.2 + 0.71 + 0.5;

QByteArray bytes_of(const char* name) {
    QFile file(test::in_source("tests/core/svg/corpus/") + QString::fromUtf8(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// By Qt: white where nothing is drawn.
QImage drawn_by_qt(const QByteArray& svg) {
    QSvgRenderer renderer(svg);
    if (!renderer.isValid())
        return {};
    QImage image((renderer.viewBoxF().size() * px_per_unit).toSize(), QImage::Format_Grayscale8);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    renderer.render(&painter);
    return image;
}

bool is_ink(const QImage& image, int x, int y) { return image.valid(x, y) && qGray(image.pixel(x, y)) < 128; }

/// Points of our contours, a tenth of a pixel apart or so, in px of the image.
std::vector<Vec2> points_of(const ContourSheet& sheet, QSize size) {
    std::vector<Vec2> points;
    for (const Contour& contour : sheet.contours)
        for (const Piece& piece : contour.pieces)
            for (int i = 0; i <= 2'000; ++i) {
                const Vec2 at = point_at(piece, i / 2'000.0);
                points.push_back({at.x / sheet.width * size.width(), at.y / sheet.height * size.height()});
            }
    return points;
}

/// How far two drawings are apart: the share of our points that Qt has no ink at, and of Qt's ink that is
/// farther than `most_px` from our points.
struct Apart {
    double ours = 0.0, theirs = 0.0;
};

Apart apart(const std::vector<Vec2>& points, const QImage& image) {
    QImage near(image.size(), QImage::Format_Grayscale8);
    near.fill(Qt::white);
    std::size_t missed = 0;
    const int reach = static_cast<int>(std::ceil(most_px));
    int last_x = -1, last_y = -1;
    for (const Vec2 point : points) {
        const int x = static_cast<int>(std::floor(point.x)), y = static_cast<int>(std::floor(point.y));
        bool ink = false; // half a pixel of rounding either way
        for (int i = -1; i <= 1; ++i)
            for (int j = -1; j <= 1; ++j)
                ink = ink || is_ink(image, x + i, y + j);
        missed += ink ? 0 : 1;
        if (x == last_x && y == last_y)
            continue;
        last_x = x;
        last_y = y;
        for (int i = -reach; i <= reach; ++i)
            for (int j = -reach; j <= reach; ++j)
                if (near.valid(x + i, y + j) &&
                    std::hypot(x + i + 0.5 - point.x, y + j + 0.5 - point.y) <= most_px + 0.71)
                    near.scanLine(y + j)[x + i] = 0;
    }
    std::size_t ink = 0, far = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (is_ink(image, x, y)) {
                ++ink;
                far += near.constScanLine(y)[x] != 0 ? 1 : 0;
            }
    return {static_cast<double>(missed) / static_cast<double>(std::max<std::size_t>(points.size(), 1)),
            static_cast<double>(far) / static_cast<double>(std::max<std::size_t>(ink, 1))};
}

} // namespace

class QtAgreesTest : public QObject {
    Q_OBJECT

private slots:
    void drawings_of_inkscape_data() {
        QTest::addColumn<int>("contours");
        QTest::newRow("inkscape_nested_transforms.svg") << 5;
        QTest::newRow("inkscape_arcs.svg") << 10;
    }
    void drawings_of_inkscape() {
        QFETCH(int, contours);
        const QByteArray svg = bytes_of(QTest::currentDataTag());
        const QImage image = drawn_by_qt(svg);
        QVERIFY(!image.isNull());
        const auto sheet = sheet_from_svg(svg.toStdString());
        QVERIFY2(sheet.ok(), sheet.error().c_str());
        QCOMPARE(static_cast<int>(sheet->contours.size()), contours);
        const std::vector<Vec2> points = points_of(*sheet, image.size());
        const Apart found = apart(points, image);
        QVERIFY2(found.ours == 0.0 && found.theirs == 0.0,
                 qPrintable(QStringLiteral("%1 of ours, %2 of Qt's").arg(found.ours).arg(found.theirs)));

        // Half a unit off, one contour missing, or what we write back: the first two are seen, the last is
        // the same.
        std::vector<Vec2> moved = points;
        for (Vec2& point : moved)
            point.x += 0.5 * px_per_unit;
        QVERIFY(apart(moved, image).ours > 0.2 && apart(moved, image).theirs > 0.0);
        ContourSheet fewer = *sheet;
        fewer.contours.pop_back();
        QVERIFY(apart(points_of(fewer, image.size()), image).theirs > 0.01);
        const auto again = sheet_from_svg(sheet_to_svg(*sheet));
        QVERIFY(again.ok());
        const Apart written = apart(points_of(*again, image.size()), image);
        QVERIFY(written.ours == 0.0 && written.theirs == 0.0);
    }

    /// The README says so: `use` is not followed.
    void what_use_repeats_is_drawn_by_qt_only() {
        const QByteArray svg = bytes_of("inkscape_use.svg");
        const QImage image = drawn_by_qt(svg);
        const auto sheet = sheet_from_svg(svg.toStdString());
        QVERIFY(sheet.ok());
        QCOMPARE(sheet->contours.size(), std::size_t{1});
        const Apart found = apart(points_of(*sheet, image.size()), image);
        QCOMPARE(found.ours, 0.0);
        QVERIFY(std::abs(found.theirs - 0.5) < 0.01);
    }
};

} // namespace qt_agrees_test

TP_TEST(qt_agrees_test, QtAgreesTest, window)
#include "qt_agrees_test.moc"
