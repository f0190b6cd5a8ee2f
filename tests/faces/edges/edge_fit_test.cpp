// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/polyline.hpp"
#include "faces/edges/edge_fit.hpp"

#include <QTest>

#include <opencv2/imgproc.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

using namespace tp;

namespace {

using Points = std::vector<Vec2>;
using Height = std::function<double(double)>; ///< y of the true edge at x, px

constexpr int oversampling = 8;
const Vec2 down(0.0, 1.0);

/// Bright below a line, dark above it.
constexpr EdgeLook step_look{{20.0, 0.0, 20.0, 0.0}, {}, 0.02, 2.0};
/// A dark line.
constexpr EdgeLook valley_look{{0.0, 20.0, 0.0, 20.0}, {}, 0.02, 2.0};

/// A picture whose colour depends on how far below the edge a place lies, each pixel the mean over its area.
cv::Mat painted(cv::Size size, const Height& edge, const std::function<double(double)>& grey,
                double blur = 0.0, double noise = 0.0) {
    cv::Mat picture(size, CV_32F), out;
    for (int x = 0; x < size.width; ++x) {
        std::array<double, oversampling> heights;
        for (int u = 0; u < oversampling; ++u)
            heights[static_cast<std::size_t>(u)] = edge(x + (u + 0.5) / oversampling);
        for (int y = 0; y < size.height; ++y) {
            double sum = 0.0;
            for (int v = 0; v < oversampling; ++v)
                for (const double height : heights)
                    sum += grey(y + (v + 0.5) / oversampling - height);
            picture.at<float>(y, x) = static_cast<float>(sum / (oversampling * oversampling));
        }
    }
    if (blur > 0.0)
        cv::GaussianBlur(picture, picture, {}, blur);
    if (noise > 0.0) {
        cv::RNG random(7);
        cv::Mat grain(size, CV_32F);
        random.fill(grain, cv::RNG::NORMAL, 0.0, noise);
        picture += grain;
    }
    picture.convertTo(out, CV_8U);
    cv::cvtColor(out, out, cv::COLOR_GRAY2BGR);
    return out;
}

double step(double below) { return below > 0.0 ? 150.0 : 110.0; }

Points along(const Height& edge, double from, double to, double offset) {
    Points points;
    for (std::size_t i = 0; i < edge_points; ++i) {
        const double x = from + (to - from) * static_cast<double>(i) / static_cast<double>(edge_points - 1);
        points.emplace_back(x, edge(x) + offset);
    }
    return points;
}

/// Mean and largest vertical distance to the edge, without the ends.
struct Miss {
    double mean = 0.0, most = 0.0;
};
Miss miss(const Points& line, const Height& edge) {
    Miss result;
    for (std::size_t i = 3; i + 3 < line.size(); ++i) {
        const double distance = std::abs(line[i].y - edge(line[i].x));
        result.mean += distance / static_cast<double>(line.size() - 6);
        result.most = std::max(result.most, distance);
    }
    return result;
}

/// A lid-like arch over `width` px, whose middle is `rise` px above its ends.
Height arch(double left, double width, double base, double rise) {
    return [=](double x) {
        const double t = std::clamp((x - left) / width, 0.0, 1.0);
        return base - 4.0 * rise * t * (1.0 - t);
    };
}

} // namespace

class EdgeFitTest : public QObject {
    Q_OBJECT

private slots:
    void edges_are_found_to_a_part_of_a_pixel_data() {
        QTest::addColumn<double>("unit_px");
        QTest::addColumn<double>("blur");
        QTest::addColumn<double>("noise");
        QTest::addColumn<double>("most_px");
        for (double unit : {60.0, 120.0, 300.0, 900.0})
            for (double blur : {0.0, 0.004})
                for (double noise : {0.0, 10.0})
                    QTest::addRow("unit %.0f px, blur %.1f %%, noise %.0f", unit, 100 * blur, noise)
                        << unit << blur * unit << noise
                        << (noise > 0.0 ? std::max(0.25, 0.0015 * unit) : std::max(0.2, 0.0008 * unit));
    }
    /// The edge lies at a known place between the pixels; the line starts up to 3 % away. Blur shifts a step
    /// of brightness towards its dark side, because brightness is judged by its logarithm.
    void edges_are_found_to_a_part_of_a_pixel() {
        QFETCH(double, unit_px);
        QFETCH(double, blur);
        QFETCH(double, noise);
        QFETCH(double, most_px);
        const int width = static_cast<int>(0.5 * unit_px), height = static_cast<int>(0.4 * unit_px);
        Miss worst;
        for (double shift : {0.0, 0.23, 0.5, 0.81}) {
            const Height edge = arch(0.1 * unit_px, 0.3 * unit_px, 0.25 * unit_px + shift, 0.05 * unit_px);
            const cv::Mat picture = painted({width, height}, edge, step, blur, noise);
            for (double start : {-0.03, 0.01, 0.025}) {
                const Points line = along(edge, 0.1 * unit_px, 0.4 * unit_px, start * unit_px);
                const Miss found = miss(on_edge(picture, line, down, unit_px, step_look), edge);
                worst = {std::max(worst.mean, found.mean), std::max(worst.most, found.most)};
            }
        }
        qInfo("mean %.3f px, most %.3f px", worst.mean, worst.most);
        QVERIFY2(worst.mean <= most_px, qPrintable(QString::number(worst.mean)));
    }

    /// Moving what is seen by a part of a pixel moves every kind of line by just that.
    void lines_move_with_the_picture_data() {
        QTest::addColumn<int>("which");
        const char* names[] = {"lower_lid", "upper_lid",      "outer_lower_lip", "outer_upper_lip",
                               "shut_lips", "open_lower_lip", "open_upper_lip"};
        for (int i = 0; i < 7; ++i)
            QTest::newRow(names[i]) << i;
    }
    void lines_move_with_the_picture() {
        QFETCH(int, which);
        const EdgeLook looks[] = {lower_lid,      upper_lid,      outer_lower_lip, outer_upper_lip,
                                  shut_lower_lip, open_lower_lip, open_upper_lip};
        EdgeLook look = looks[which];
        look.stray = 0.0; // the starting line stays where it was
        const auto lips = [](double below) {
            return 150.0 + 30.0 * std::tanh(below / 4.0) - 90.0 * std::exp(-0.5 * below * below / 4.0);
        };
        const double unit = 200.0;
        const auto found = [&](double shift) {
            const Height edge = arch(20.0, 60.0, 45.0 + shift, 8.0);
            return on_edge(painted({100, 80}, edge, lips),
                           along(arch(20.0, 60.0, 45.0, 8.0), 20.0, 80.0, 0.0), down, unit, look);
        };
        const Points still = found(0.0);
        for (double shift : {0.2, 0.5, 0.8}) {
            const Points moved = found(shift);
            double mean = 0.0;
            for (std::size_t i = 3; i + 3 < moved.size(); ++i)
                mean += (moved[i].y - still[i].y) / static_cast<double>(moved.size() - 6);
            QVERIFY2(std::abs(mean - shift) < 0.06, qPrintable(QString("%1 for %2").arg(mean).arg(shift)));
        }
    }

    void dark_lines_are_found_in_their_middle() {
        const Height edge = arch(20.0, 60.0, 45.4, 3.0);
        const cv::Mat picture =
            painted({100, 80}, edge, [](double below) { return std::abs(below) < 1.5 ? 60.0 : 160.0; });
        const Miss found =
            miss(on_edge(picture, along(edge, 20.0, 80.0, 4.0), down, 200.0, valley_look), edge);
        QVERIFY2(found.mean < 0.08, qPrintable(QString::number(found.mean)));
    }
    void the_other_polarity_is_no_edge() {
        const Height edge = arch(20.0, 60.0, 45.0, 5.0);
        const cv::Mat picture = painted({100, 80}, edge, [](double below) { return step(-below); });
        const Miss found = miss(on_edge(picture, along(edge, 20.0, 80.0, 3.0), down, 200.0, step_look), edge);
        QVERIFY2(found.mean > 2.5, qPrintable(QString::number(found.mean)));
    }
    void red_counts_where_grey_does_not_change() {
        const Height edge = arch(20.0, 60.0, 45.3, 5.0);
        cv::Mat picture = painted({100, 80}, edge, step);
        picture.forEach<cv::Vec3b>([](cv::Vec3b& p, const int*) {
            const double t = (p[0] - 110.0) / 40.0; // 0 above, 1 below
            p = {120, cv::saturate_cast<uchar>(140.0 - 20.4 * t), cv::saturate_cast<uchar>(120.0 + 40.0 * t)};
        });
        const EdgeLook red{{}, {30.0, 0.0, 30.0, 0.0}, 0.02, 2.0};
        const Points start = along(edge, 20.0, 80.0, 3.0);
        const Miss by_red = miss(on_edge(picture, start, down, 200.0, red), edge);
        QVERIFY2(by_red.mean < 0.2, qPrintable(QString::number(by_red.mean)));
    }
    void calm_pictures_leave_the_line_where_it_is() {
        const Points line = along(arch(20.0, 60.0, 45.0, 8.0), 20.0, 80.0, 0.0);
        EdgeReport report;
        const Points found = on_edge(cv::Mat(80, 100, CV_8UC3, cv::Scalar(90, 120, 150)), line, down, 200.0,
                                     upper_lid, &report);
        for (std::size_t i = 0; i < line.size(); ++i)
            QVERIFY(length(found[i] - line[i]) < 1e-9);
        QVERIFY(report.moved_percent < 1e-9 && std::abs(report.clarity) < 1e-9);
    }
    void how_far_a_line_moved_is_told() {
        const Height edge = arch(20.0, 60.0, 45.0, 0.0);
        EdgeReport report;
        on_edge(painted({100, 80}, edge, step), along(edge, 20.0, 80.0, 6.0), down, 200.0, step_look,
                &report);
        QVERIFY2(std::abs(report.moved_percent - 3.0) < 0.1,
                 qPrintable(QString::number(report.moved_percent)));
        const EdgeReports::Pair lips{{0.0, 1.0}, {0.0, 3.0}};
        QCOMPARE(lips.clearest(), 3.0);
        QCOMPARE(lips.faintest(), 1.0);
    }
    void a_covered_part_is_bridged() {
        const Height edge = arch(20.0, 60.0, 45.4, 8.0);
        cv::Mat picture = painted({100, 80}, edge, step);
        picture.colRange(44, 56).setTo(cv::Scalar::all(120));
        const Miss found = miss(on_edge(picture, along(edge, 20.0, 80.0, 3.0), down, 200.0, step_look), edge);
        QVERIFY2(found.most < 1.0, qPrintable(QString::number(found.most)));
    }
    void mirrored_pictures_give_mirrored_lines() {
        const Height edge = [](double x) { return 40.0 + 6.0 * std::sin(0.07 * x); };
        const cv::Mat picture = painted({100, 80}, edge, step, 0.7, 6.0);
        cv::Mat mirrored;
        cv::flip(picture, mirrored, 1);
        const Points line = along(edge, 20.0, 80.0, 2.0);
        Points other = line;
        for (Vec2& p : other)
            p.x = 100.0 - p.x;
        const Points found = on_edge(picture, line, down, 200.0, upper_lid);
        const Points back = on_edge(mirrored, other, down, 200.0, upper_lid);
        for (std::size_t i = 0; i < line.size(); ++i)
            QVERIFY(length(Vec2(100.0 - back[i].x, back[i].y) - found[i]) < 1e-6);
    }
    /// Grain as strong as the step: what smooths it away finds the edge nearer, without moving a clear one.
    void grain_is_smoothed_away() {
        const double unit = 300.0;
        const Height edge = arch(30.0, 90.0, 75.3, 15.0);
        const Points line = along(edge, 30.0, 120.0, 4.0);
        const auto missed = [&](double noise, double grain_percent) {
            const cv::Mat picture = painted({150, 120}, edge, step, 0.0, noise);
            return miss(on_edge(picture, line, down, unit, step_look, nullptr, grain_percent), edge).mean;
        };
        qInfo("grain 40: %.2f px, smoothed %.2f; none: %.2f, smoothed %.2f", missed(40.0, 0.0),
              missed(40.0, 0.4), missed(0.0, 0.0), missed(0.0, 0.4));
        QVERIFY(missed(40.0, 0.4) < 0.8 * missed(40.0, 0.0));
        QVERIFY(missed(0.0, 0.4) < 0.2);
        for (double strange : {-1.0, 1e-9, 1e9, double(NAN), double(INFINITY)})
            QCOMPARE(missed(0.0, strange), missed(0.0, 0.0));
    }

    void lines_beyond_the_picture_are_safe() {
        const cv::Mat picture = painted({40, 30}, arch(0.0, 40.0, 15.0, 3.0), step);
        for (Vec2 away : {Vec2(-500.0, 3.0), Vec2(35.0, -200.0), Vec2(1e6, 1e6)}) {
            Points line = along(arch(0.0, 60.0, 15.0, 3.0), 0.0, 60.0, 0.0);
            for (Vec2& p : line)
                p += away;
            for (Vec2 p : on_edge(picture, line, down, 100.0, upper_lid))
                QVERIFY(is_finite(p));
        }
        const Points one_place(edge_points, Vec2(10.0, 10.0));
        for (Vec2 p : on_edge(picture, one_place, down, 100.0, upper_lid))
            QVERIFY(is_finite(p));
    }

    /// A mouth that a net saw slightly open, on a picture of one dark line between two lips.
    void shut_lips_become_one_line() {
        FaceLines lines = plain_face();
        const Height slit = arch(70.0, 60.0, 100.3, 0.0);
        const cv::Mat picture = painted({200, 160}, slit, [](double below) {
            return 150.0 - 100.0 * std::exp(-0.5 * below * below / 2.0);
        });
        const FaceLines found = on_edges(picture, lines);
        for (const Points& lip : {found.inner_lip.lower, found.inner_lip.upper}) {
            const double far = miss(lip, slit).mean;
            QVERIFY2(far < 0.6, qPrintable(QString::number(far)));
        }
        QCOMPARE(found.inner_lip.lower.front(), found.inner_lip.upper.front());
        QCOMPARE(found.inner_lip.lower.back(), found.inner_lip.upper.back());
    }
    /// Neither the look of shut lips nor that of open ones fits, so the net knows better.
    void lips_a_little_apart_stay() {
        FaceLines lines = plain_face();
        for (Vec2& p : lines.inner_lip.lower)
            p.y += 5.0;
        const cv::Mat picture = painted({200, 160}, arch(70.0, 60.0, 100.3, 0.0), [](double below) {
            return 150.0 - 100.0 * std::exp(-0.5 * below * below / 2.0);
        });
        EdgeReports seen;
        const FaceLines found = on_edges(picture, lines, &seen);
        QVERIFY(found.inner_lip.lower == lines.inner_lip.lower);
        QVERIFY(found.inner_lip.upper == lines.inner_lip.upper);
        QVERIFY(seen.inner_lip.lower.clarity != 0.0); // what the picture shows is told all the same
    }
    void the_outline_and_tiny_faces_stay() {
        const FaceLines lines = plain_face();
        const cv::Mat picture = painted({200, 160}, arch(0.0, 200.0, 80.0, 9.0), step);
        QVERIFY(on_edges(picture, lines).outline == lines.outline);
        FaceLines tiny = lines;
        for (Opening* opening : {&tiny.right_eye, &tiny.left_eye, &tiny.outer_lip, &tiny.inner_lip})
            for (Points* edge : {&opening->lower, &opening->upper})
                for (Vec2& p : *edge)
                    p *= 0.1;
        QVERIFY(on_edges(picture, tiny).right_eye.lower == tiny.right_eye.lower);
    }

    /// Below 24 px between the eyes a percent is a quarter of a pixel.
    void a_face_is_looked_at_from_24_px_on() {
        const cv::Mat picture = painted({60, 60}, arch(0.0, 60.0, 10.0, 3.0), step, 0.0, 30.0);
        for (const double unit : {23.7, 24.3}) {
            FaceLines face = plain_face();
            for (Opening* opening : {&face.right_eye, &face.left_eye, &face.outer_lip, &face.inner_lip})
                for (Points* edge : {&opening->lower, &opening->upper})
                    for (Vec2& p : *edge)
                        p *= unit / 150.0;
            EdgeReports seen;
            on_edges(picture, face, &seen);
            QCOMPARE(seen.right_eye.lower.clarity != 0.0, unit > 24.0);
        }
    }
    /// Shut lips are moved onto their line, those far apart onto their two edges, and those between stay.
    void lips_move_by_how_far_they_are_apart_data() {
        QTest::addColumn<double>("gap_percent");
        QTest::addColumn<bool>("moved");
        QTest::newRow("as good as shut") << 1.45 << true;
        QTest::newRow("hardly open") << 1.55 << false;
        QTest::newRow("not yet open") << 3.9 << false;
        QTest::newRow("open") << 4.1 << true;
        QTest::newRow("wide open") << 8.5 << true;
    }
    void lips_move_by_how_far_they_are_apart() {
        QFETCH(double, gap_percent);
        QFETCH(bool, moved);
        const cv::Mat picture = painted({200, 160}, arch(0.0, 200.0, 80.0, 9.0), step, 0.0, 20.0);
        FaceLines lines = plain_face();
        lines.inner_lip = plain_opening(70.0, 130.0, 100.0, 3.0);
        const double open_px = 3.0 * gap_percent / (100.0 * lines.inner_lip.mean_gap() / 150.0);
        lines.inner_lip = plain_opening(70.0, 130.0, 100.0, open_px);
        EdgeReports seen;
        const FaceLines found = on_edges(picture, lines, &seen);
        QCOMPARE(found.inner_lip.lower != lines.inner_lip.lower, moved);
        QCOMPARE(found.inner_lip.upper != lines.inner_lip.upper, moved);
        QVERIFY(seen.inner_lip.lower.clarity != 0.0 && seen.inner_lip.upper.clarity != 0.0);
        for (const Opening* opening :
             {&found.right_eye, &found.left_eye, &found.outer_lip, &found.inner_lip}) {
            QCOMPARE(opening->lower.front(), opening->upper.front()); // corners are of both edges
            QCOMPARE(opening->lower.back(), opening->upper.back());
        }
    }

private:
    static Opening plain_opening(double from, double to, double middle, double open) {
        const Height flat = [=](double) { return middle; };
        Opening result{along(flat, from, to, 0.0), along(flat, from, to, 0.0)};
        for (std::size_t i = 0; i < edge_points; ++i) {
            const double t = static_cast<double>(i) / static_cast<double>(edge_points - 1);
            const double gap = open * std::sin(std::numbers::pi * t);
            result.lower[i].y += 0.5 * gap;
            result.upper[i].y -= 0.5 * gap;
        }
        return result;
    }
    /// Eyes 150 px apart, a mouth between them that is about 3 px open.
    static FaceLines plain_face() {
        FaceLines lines;
        lines.right_eye = plain_opening(25.0, 70.0, 40.0, 12.0);
        lines.left_eye = plain_opening(175.0, 130.0, 40.0, 12.0);
        lines.outer_lip = plain_opening(65.0, 135.0, 100.0, 24.0);
        lines.inner_lip = plain_opening(70.0, 130.0, 100.0, 3.0);
        lines.outline = {{10, 40}, {30, 120}, {100, 155}, {170, 120}, {190, 40}};
        return lines;
    }
};

QTEST_GUILESS_MAIN(EdgeFitTest)
#include "edge_fit_test.moc"
