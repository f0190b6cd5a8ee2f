// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/flatten.hpp"
#include "core/svg/contour_sheet.hpp"

#include <QTest>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace tp::testing {

using Unit = ContourSheet::Unit;
constexpr double pi = std::numbers::pi;
constexpr double arc_tolerance = 1e-6; ///< the contract's, in units of the sheet

/// `body` on a sheet of 100 × 100 units, one user unit each.
inline std::string on_sheet(const std::string& body) {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100\" height=\"100\">" + body + "</svg>";
}

inline ContourSheet read(const std::string& text, Unit unit = Unit::millimetre) {
    const auto sheet = sheet_from_svg(text, unit);
    if (!sheet) {
        QTest::qFail(sheet.error().c_str(), __FILE__, __LINE__);
        return {};
    }
    return *sheet;
}

inline std::vector<Contour> drawn(const std::string& body) { return read(on_sheet(body)).contours; }

inline Contour only(const std::string& body) {
    auto contours = drawn(body);
    if (contours.size() != 1) {
        QTest::qFail(("contours: " + std::to_string(contours.size())).c_str(), __FILE__, __LINE__);
        return {};
    }
    return contours.front();
}

inline Contour path(const std::string& data) { return only("<path d=\"" + data + "\"/>"); }

inline std::vector<Vec2> sampled(const Contour& contour, int a_piece = 200) {
    std::vector<Vec2> points;
    for (const Piece& piece : contour.pieces)
        for (int i = 0; i <= a_piece; ++i)
            points.push_back(point_at(piece, static_cast<double>(i) / a_piece));
    return points;
}

/// Largest distance of the curve t ↦ truth(t), 0 ≤ t ≤ 1, from the contour.
inline double deviation(const Contour& contour, const std::function<Vec2(double)>& truth) {
    FlattenTolerance fine;
    fine.chord = 1e-7;
    fine.facet_degrees = 1.0;
    const Polyline line = flatten(contour, fine);
    double worst = 0.0;
    for (int i = 0; i <= 60; ++i)
        worst = std::max(worst, distance_to(line, truth(i / 60.0)));
    return worst;
}

/// Largest distance of the contour's points from the ellipse about `centre`, of radii `r`, turned by `angle`;
/// by one step of Newton's, good where they are close.
inline double off_ellipse(const Contour& contour, Vec2 centre, Vec2 r, double angle = 0.0) {
    double worst = 0.0;
    for (const Vec2 p : sampled(contour)) {
        const Vec2 d = p - centre;
        const Vec2 q(std::cos(angle) * d.x + std::sin(angle) * d.y,
                     -std::sin(angle) * d.x + std::cos(angle) * d.y);
        const double f = q.x * q.x / (r.x * r.x) + q.y * q.y / (r.y * r.y) - 1.0;
        const Vec2 slope(2.0 * q.x / (r.x * r.x), 2.0 * q.y / (r.y * r.y));
        worst = std::max(worst, std::abs(f) / length(slope));
    }
    return worst;
}

inline double arc_length(const Contour& contour) {
    FlattenTolerance fine;
    fine.chord = 1e-7;
    fine.facet_degrees = 0.1;
    return length_of(flatten(contour, fine));
}

inline bool near(Vec2 a, Vec2 b, double tolerance = 1e-9) { return length(a - b) <= tolerance; }

/// The end points of every piece, the start first.
inline std::vector<Vec2> corners(const Contour& contour) {
    std::vector<Vec2> points{start_of(contour.pieces.front())};
    for (const Piece& piece : contour.pieces)
        points.push_back(end_of(piece));
    return points;
}

inline void compare_points(const std::vector<Vec2>& actual, const std::vector<Vec2>& expected,
                           double tolerance = 1e-9) {
    QCOMPARE(actual.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        QVERIFY2(near(actual[i], expected[i], tolerance),
                 qPrintable(QString("point %1: %2, %3 where %4, %5 is expected")
                                .arg(i)
                                .arg(actual[i].x, 0, 'g', 17)
                                .arg(actual[i].y, 0, 'g', 17)
                                .arg(expected[i].x, 0, 'g', 17)
                                .arg(expected[i].y, 0, 'g', 17)));
}

inline void expect_refusal(const std::string& text, const std::string& word) {
    const auto sheet = sheet_from_svg(text);
    QVERIFY2(!sheet.ok(), "was read");
    const std::string sentence = sheet.error();
    QVERIFY2(sentence.find(word) != std::string::npos, sentence.c_str());
    QVERIFY2(sentence.size() > 20 && sentence.ends_with('.') && sentence.find('\n') == std::string::npos,
             sentence.c_str());
}

} // namespace tp::testing
