// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/flatten.hpp"
#include "core/geometry/polyline.hpp"
#include "faces/base/face.hpp"
#include "faces/evaluation/contour_error.hpp"
#include "faces/pieces/extra_features.hpp"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace tp;

namespace {

constexpr double tolerance = 0.2; ///< px

/// Lids as arcs `open` px apart in the middle, between corners 100 px apart, the outer one first.
std::vector<Vec2> eye_points(Vec2 outer, double towards, double open) {
    std::vector<Vec2> points;
    for (int i = 0; i < 16; ++i) {
        const double way = i <= 8 ? i / 8.0 : (16.0 - i) / 8.0;
        const double height = 2.0 * open * way * (1.0 - way);
        points.push_back(outer + Vec2(towards * 100.0 * way, i <= 8 ? height : -height));
    }
    return points;
}

Landmarks face(double open) {
    Landmarks points;
    points.right_eye = eye_points({100, 200}, 1.0, open);
    points.left_eye = eye_points({400, 200}, -1.0, open);
    points.outer_lip = points.inner_lip = points.outline = points.right_eye;
    points.outer_lip.resize(20, Vec2(120, 300));
    points.inner_lip.resize(20, Vec2(120, 300));
    points.right_iris = {{150, 200}, 20.0};
    points.left_iris = {{350, 200}, 20.0};
    points.nose = {{230, 240}, {225, 260}, {235, 275}, {250, 280}, {265, 275}, {275, 260}, {270, 240}};
    points.right_brow = {{95, 160}, {120, 150}, {150, 148}, {150, 140}, {120, 141}, {95, 152}};
    return points;
}

std::vector<Contour> extras(const Landmarks& points) {
    return extra_contours(points, lines_through(points), tolerance);
}

Rect extent(const std::vector<Contour>& contours, const char* name) {
    return bounds_of(flatten(*contour_named(contours, name)).points);
}

} // namespace

class ExtraFeaturesTest : public QObject {
    Q_OBJECT
private slots:
    void an_iris_in_a_wide_eye_is_a_circle() {
        const std::vector<Contour> found = extras(face(100.0));
        const Contour* iris = contour_named(found, feature::right_iris);
        QVERIFY(iris && iris->closed);
        for (const Vec2 p : flatten(*iris).points)
            QVERIFY(std::abs(length(p - Vec2(150, 200)) - 20.0) < 1.5 * tolerance);
    }

    void lids_hide_a_part_of_an_iris() {
        const std::vector<Contour> found = extras(face(30.0));
        for (const char* name : {feature::right_iris, feature::left_iris}) {
            const Rect box = extent(found, name);
            QVERIFY(std::abs(box.width() - 40.0) < 1.0);
            QVERIFY2(std::abs(box.height() - 30.0) < 1.5, qPrintable(QString::number(box.height())));
        }
    }

    void a_shut_eye_has_no_iris() {
        const std::vector<Contour> found = extras(face(4.0));
        QVERIFY(!contour_named(found, feature::right_iris));
        QVERIFY(!contour_named(found, feature::left_iris));
        QVERIFY(contour_named(found, feature::nose));
    }

    void only_what_is_known_is_there() {
        const std::vector<Contour> found = extras(face(100.0));
        QVERIFY(contour_named(found, feature::right_brow)->closed);
        QVERIFY(!contour_named(found, feature::left_brow)); // this model did not say
        QVERIFY(!contour_named(found, feature::nose)->closed);
        Landmarks nothing = face(100.0);
        nothing.right_brow = nothing.nose = {};
        nothing.right_iris = nothing.left_iris = {};
        QVERIFY(extras(nothing).empty());
    }

    void degenerate_eyes_are_safe() {
        Landmarks points = face(100.0);
        points.right_eye.assign(16, Vec2(150, 200));
        for (const Contour& contour : extras(points))
            for (const Piece& piece : contour.pieces)
                QVERIFY(is_finite(piece));
    }
};

QTEST_APPLESS_MAIN(ExtraFeaturesTest)
#include "extra_features_test.moc"
