// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/contour_error.hpp"
#include "test_program.hpp"

#include <QTest>

namespace contour_error_test {

using namespace tp;

namespace {

/// Two eyes 100 apart at their outer corners, a square mouth, an open outline.
std::vector<Contour> plain_face(Vec2 shift = Vec2(0.0)) {
    const auto box = [&](double left, double top, double right, double bottom) {
        return std::vector<Vec2>{Vec2(left, top) + shift, Vec2(right, top) + shift,
                                 Vec2(right, bottom) + shift, Vec2(left, bottom) + shift};
    };
    return {contour_through(feature::right_eye, box(0, 0, 30, 10), true),
            contour_through(feature::left_eye, box(70, 0, 100, 10), true),
            contour_through(feature::outer_lip, box(30, 60, 70, 80), true),
            contour_through(feature::outline,
                            {Vec2(-20, 0) + shift, Vec2(50, 130) + shift, Vec2(120, 0) + shift}, false)};
}

} // namespace

class ContourErrorTest : public QObject {
    Q_OBJECT

private slots:
    void outer_corners_give_the_scale() { QCOMPARE(outer_inter_ocular_distance(plain_face()), 100.0); }
    void same_contours_have_no_error() {
        for (const char* name : {feature::right_eye, feature::outer_lip, feature::outline})
            QVERIFY(*contour_error_percent(plain_face(), plain_face(), name) < 1e-9);
    }
    void a_shift_is_at_most_its_length() {
        const auto error =
            contour_error_percent(plain_face(), plain_face(Vec2(0.0, 2.0)), feature::outer_lip);
        QVERIFY(*error > 0.5 && *error < 2.0); // horizontal edges move by 2 %, vertical ones along themselves
    }
    void outline_may_be_longer_than_the_truth() {
        auto found = plain_face();
        found.back() =
            contour_through(feature::outline, {{-60, -74}, {-20, 0}, {50, 130}, {120, 0}, {160, -74}}, false);
        QVERIFY(*contour_error_percent(plain_face(), found, feature::outline) < 1e-9);
    }
    void missing_contours_give_no_figure() {
        QVERIFY(!contour_error_percent(plain_face(), plain_face(), feature::inner_lip));
        QVERIFY(!contour_error_percent({}, plain_face(), feature::outline));
        QVERIFY(!contour_error_percent(plain_face(), {}, feature::outline));
    }
};

} // namespace contour_error_test

TP_TEST(contour_error_test, ContourErrorTest, event_loop)
#include "contour_error_test.moc"
