// SPDX-License-Identifier: Apache-2.0
// The picture of the force field by itself: coarse at once and then fine, of the newest scene at the newest scale.
#include "app/pages/lab/lab_field.hpp"
#include "app/pages/lab/lab_setup.hpp"
#include "app/pages/lab/sample_scenes.hpp"
#include "app/photo/picture/field_picture.hpp"
#include "test_program.hpp"

#include <QColor>
#include <QImage>
#include <QTest>

#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace lab_field_test {

using namespace tp;

namespace {

constexpr int patience_ms = 60000; ///< on a busy machine
const Rect surface{{-30.0, -20.0}, {30.0, 20.0}};
const QColor beside_the_field(12, 12, 18);

/// A shape in the middle of the surface, of a size that leaves some of it on it.
std::shared_ptr<const HapticScene> felt(LabShape shape) {
    return felt_scene(flatten(sample_scene(shape, surface.width(), surface.height())), {}).value();
}

struct Bench {
    std::vector<QImage> painted; ///< each picture as it was when it was told
    LabField field{surface, [this] { painted.push_back(field.image()); }};

    explicit Bench(double pixels_per_mm) { field.set_scale(pixels_per_mm); }
    /// Whether so many come and no more.
    bool comes_to(std::size_t pictures) {
        return QTest::qWaitFor([&] { return painted.size() >= pictures; }, patience_ms) && stays(pictures);
    }
    /// What was asked for is done, and nothing more comes of it.
    bool stays(std::size_t pictures) {
        QTest::qWait(50);
        return painted.size() == pictures;
    }
};

QSize size_at(double pixels_per_mm) {
    return {static_cast<int>(std::lround(60.0 * pixels_per_mm)),
            static_cast<int>(std::lround(40.0 * pixels_per_mm)) + LabField::legend_pixels};
}

/// Mean difference of a channel over the field, the legend left out; 0 … 255.
double difference(const QImage& one, const QImage& other) {
    double sum = 0.0;
    const int height = one.height() - LabField::legend_pixels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < one.width(); ++x) {
            const QColor a = one.pixelColor(x, y), b = other.pixelColor(x, y);
            sum +=
                std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue());
        }
    return sum / (3.0 * one.width() * height);
}

} // namespace

class LabFieldTest : public QObject {
    Q_OBJECT
private slots:
    void before_a_scene_is_shown_there_is_no_picture() {
        Bench bench(1.0);
        bench.field.set_scale(3.0);
        QVERIFY(bench.stays(0));
        QVERIFY(bench.field.image().isNull());
    }

    void a_small_one_is_fine_at_once() {
        Bench bench(1.5);
        const auto circle = felt(LabShape::circle);
        bench.field.show(circle);
        QVERIFY(bench.painted.empty()); // beside the page, which does not wait
        QVERIFY(bench.comes_to(1));
        QCOMPARE(bench.painted[0].size(), size_at(1.5));
        QVERIFY(bench.painted[0] == draw_force_field(*circle, surface, 1.5));
        QVERIFY(bench.field.image() == bench.painted[0]);
    }

    void of_a_large_one_a_coarse_picture_comes_first_in_the_same_place() {
        Bench bench(4.0);
        const auto circle = felt(LabShape::circle);
        bench.field.show(circle);
        QVERIFY(bench.comes_to(2));
        const QImage coarse = bench.painted[0], fine = bench.painted[1];
        QCOMPARE(coarse.size(), size_at(4.0));
        QVERIFY(fine == draw_force_field(*circle, surface, 4.0));
        QVERIFY(coarse != fine);
        QImage dark(fine.size(), fine.format());
        dark.fill(beside_the_field);
        const double rough = difference(coarse, fine) / difference(dark, fine);
        QVERIFY2(rough < 0.35, qPrintable(QString::number(rough)));
        for (int y = coarse.height() - LabField::legend_pixels + 2; y < coarse.height(); y += 6)
            for (int x = 0; x < coarse.width(); x += 10) // the legend's letters come with the fine one
                QCOMPARE(coarse.pixelColor(x, y), beside_the_field);
    }

    void the_same_scale_again_paints_nothing() {
        Bench bench(1.0);
        bench.field.show(felt(LabShape::circle));
        QVERIFY(bench.comes_to(1));
        bench.field.set_scale(1.0);
        QVERIFY(bench.stays(1));
        bench.field.set_scale(1.25);
        QVERIFY(bench.comes_to(2));
        QCOMPARE(bench.field.image().size(), size_at(1.25));
    }

    void a_scale_that_no_screen_has_is_brought_within_bounds() {
        Bench bench(0.001);
        bench.field.show(felt(LabShape::circle));
        QVERIFY(bench.comes_to(1));
        QCOMPARE(bench.field.image().size(), size_at(0.5));
        bench.field.set_scale(0.0);
        QVERIFY(bench.stays(1));
        bench.field.set_scale(1000.0);
        QVERIFY(bench.comes_to(3));
        QCOMPARE(bench.field.image().size(), size_at(16.0));
    }

    void of_many_wishes_only_the_newest_is_painted() {
        Bench bench(1.0);
        const auto triangle = felt(LabShape::triangle);
        bench.field.show(felt(LabShape::circle));
        bench.field.show(felt(LabShape::curve));
        bench.field.show(triangle);
        bench.field.set_scale(1.75);
        QVERIFY(bench.comes_to(1));
        QVERIFY(bench.painted[0] == draw_force_field(*triangle, surface, 1.75));
    }

    void a_scene_that_comes_between_coarse_and_fine_is_the_one_that_is_painted_finely() {
        const auto triangle = felt(LabShape::triangle);
        std::optional<LabField> field;
        std::vector<QImage> painted;
        field.emplace(surface, [&] {
            painted.push_back(field->image());
            if (painted.size() == 1)
                field->show(triangle);
        });
        field->show(felt(LabShape::circle));
        const QImage wanted = draw_force_field(*triangle, surface, 4.0); // the scale it begins with
        QTRY_VERIFY_WITH_TIMEOUT(!painted.empty() && painted.back() == wanted, patience_ms);
        QTest::qWait(50);
        QVERIFY(painted.back() == wanted);
    }

    void what_is_not_shown_any_more_is_told_to_nobody() {
        int told = 0;
        {
            LabField field(surface, [&] { ++told; });
            field.show(felt(LabShape::circle));
        }
        QTest::qWait(50);
        QCOMPARE(told, 0);
    }
};

} // namespace lab_field_test

TP_TEST(lab_field_test, LabFieldTest, window)
#include "lab_field_test.moc"
