// SPDX-License-Identifier: Apache-2.0
#include "core/experiment/experiment_file.hpp"
#include "core/files/whole_file.hpp"
#include "core/trials/study_shapes.hpp"
#include "core/trials/study_trial.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <set>

namespace study_trial_test {

using namespace tp;
using namespace tp::test;

namespace {

/// A square face far from any surface, y down, with a line at its foot.
class SquareFaces final : public StudyFaces {
public:
    Result<std::vector<Contour>> contours(std::string_view expression, std::string_view face) const override {
        if (face == "4")
            return Error{"There is no fourth person."};
        return std::vector{
            contour_through(std::string(expression), {{100, 50}, {500, 50}, {500, 450}, {100, 450}}, true),
            contour_through("foot", {{200, 440}, {400, 440}}, false)};
    }
};

Experiment experiment_of(const std::string& lines) {
    const auto experiment = read_experiment("experiment: a\n" + lines);
    if (!experiment)
        qFatal("%s", experiment.error().c_str());
    return *experiment;
}

Experiment shipped(const char* name) {
    const auto text = read_whole(in_source((std::string("resources/studies/") + name + ".study").c_str()),
                                 most_experiment_bytes);
    return read_experiment(text.value()).value();
}

const Experiment paths = experiment_of("task: follow\nfactor path: circle, triangle, curve\n");

StudyTrial path_trial(std::size_t condition, std::uint64_t seed) {
    return trial_of(paths, {condition, 0, false, seed}).value();
}

} // namespace

class StudyTrialTest : public QObject {
    Q_OBJECT
private slots:
    void every_trial_of_every_shipped_experiment_lies_on_its_surface_and_can_be_felt() {
        for (const char* const name :
             {"tracking", "laws-tracking", "primitives", "expressions", "laws-expressions"}) {
            const Experiment experiment = shipped(name);
            const SquareFaces faces;
            for (int person = 1; person <= 4; ++person)
                for (const PlannedTrial& planned : trials_of(experiment, person, 3)) {
                    const auto trial = trial_of(experiment, planned, &faces);
                    const Experiment from = planned.training ? experiment.in_training() : experiment;
                    if (from.value_of(StudyParameter::face, planned.condition) == "4") {
                        QCOMPARE(trial.error(), std::string("There is no fourth person."));
                        continue;
                    }
                    QVERIFY2(trial, trial.error().c_str());
                    Rect surface = trial->scene.surface();
                    QVERIFY(surface.contains(trial->start));
                    surface.min -= 1e-6;
                    surface.max += 1e-6;
                    for (const Contour& contour : trial->scene.contours)
                        for (const Vec2 place : flatten(contour).points)
                            QVERIFY(surface.contains(place));
                }
        }
    }
    void a_path_has_the_published_size() {
        const Rect circle = bounds_of(path_trial(0, 1).path.points);
        QVERIFY(std::abs(circle.width() - 80.0) < 0.05);
        const Rect triangle = bounds_of(path_trial(1, 1).path.points);
        QVERIFY(std::abs(triangle.height() - 50.0) < 1e-9);
        QVERIFY(std::abs(length_of(path_trial(1, 1).path) - 3.0 * 50.0 * 2.0 / std::sqrt(3.0)) < 1e-9);
        QVERIFY(std::abs(bounds_of(path_trial(2, 1).path.points).width() - 200.0) < 1e-9);
    }
    void a_circle_is_round_and_a_polygon_is_regular() {
        for (const Vec2 place : flatten(study_shape(StudyShape::circle, {3, 4}, 50.0, 0.3)).points)
            QVERIFY(std::abs(length(place - Vec2(3, 4)) - 50.0) < 0.03);
        for (const StudyShape shape :
             {StudyShape::triangle, StudyShape::square, StudyShape::pentagon, StudyShape::hexagon}) {
            const Polyline line = flatten(study_shape(shape, {3, 4}, 50.0, 1.0));
            QCOMPARE(line.points.size(), std::size_t{2} + static_cast<std::size_t>(shape));
            const double side = length(line.segment_end(0) - line.segment_start(0));
            for (std::size_t i = 0; i < line.points.size(); ++i) {
                QVERIFY(std::abs(length(line.points[i] - Vec2(3, 4)) - 50.0) < 1e-9);
                QVERIFY(std::abs(length(line.segment_end(i) - line.segment_start(i)) - side) < 1e-9);
            }
            const double foot = bounds_of(line.points).min.y; // level
            QCOMPARE(std::ranges::count_if(line.points,
                                           [&](Vec2 place) { return std::abs(place.y - foot) < 1e-9; }),
                     std::ptrdiff_t{2});
        }
    }
    void a_closed_path_lies_anywhere_and_begins_where_it_may() {
        for (const std::size_t condition : {0U, 1U}) {
            std::vector<Vec2> middles;
            std::set<int> starts;
            for (std::uint64_t seed = 0; seed < 400; ++seed) {
                const StudyTrial trial = path_trial(condition, seed);
                const Rect box = bounds_of(trial.path.points);
                middles.push_back(box.centre());
                const Vec2 from = trial.start - box.centre();
                starts.insert(static_cast<int>(std::floor(std::atan2(from.y, from.x))));
            }
            const Rect reached = bounds_of(middles);
            const Rect box = bounds_of(path_trial(condition, 1).path.points);
            QVERIFY(reached.width() > 0.95 * (200.0 - 2.0 * study_margin_mm - box.width()));
            QVERIFY(reached.height() > 0.95 * (200.0 - 2.0 * study_margin_mm - box.height()));
            QVERIFY(reached.width() <= 200.0 - 2.0 * study_margin_mm - box.width() + 0.1);
            QCOMPARE(starts.size(), condition == 0 ? std::size_t{8} : std::size_t{3});
        }
    }
    void a_curve_begins_at_either_end() {
        std::set<double> starts;
        for (std::uint64_t seed = 0; seed < 40; ++seed) {
            const StudyTrial trial = path_trial(2, seed);
            starts.insert(trial.start.x);
            QVERIFY(std::abs(trial.path.points.back().x + trial.start.x) < 1e-9);
        }
        QCOMPARE(starts.size(), std::size_t{2});
    }
    /// What was recorded with a study must lead to the same trial on another computer and in years.
    void a_trial_that_was_given_stays() {
        const StudyTrial trial = path_trial(1, 16444145387650486336U);
        QCOMPARE(QString::asprintf("%.6f %.6f", trial.start.x, trial.start.y),
                 QString("4.486939 -50.494213"));
        QVERIFY(path_trial(0, 5).start == path_trial(0, 5).start);
        QVERIFY(path_trial(0, 5).start != path_trial(0, 6).start);
    }
    void knots_lie_on_the_path_and_a_triangles_corners_are_among_them() {
        for (std::size_t condition = 0; condition < 3; ++condition) {
            const StudyTrial trial = path_trial(condition, 7);
            QCOMPARE(trial.knots.size(), std::size_t{5});
            QCOMPARE(trial.reach_mm, 10.0);
            for (const Vec2 knot : trial.knots) {
                QVERIFY(distance_to(trial.path, knot) < 1e-9);
                QVERIFY(length(knot - trial.start) > 2.0 * trial.reach_mm);
            }
        }
        const StudyTrial triangle = path_trial(1, 7);
        for (const std::size_t i : {1U, 2U})
            QVERIFY(length(triangle.path.points[i] - triangle.knots[2 * i - 1]) < 1e-9);
    }
    void a_short_path_is_judged_more_narrowly() {
        const auto trial = trial_of(
            experiment_of("task: follow\nset path: circle\nfactor radius: 5, 10 mm\n"), {0, 0, false, 1});
        QVERIFY(trial->reach_mm < 2.7);
        for (const Vec2 knot : trial->knots)
            QVERIFY(length(knot - trial->start) > trial->reach_mm);
    }
    void what_the_experiment_says_of_the_guidance_is_felt() {
        const Experiment experiment = experiment_of("task: follow\nfactor law: exact, published\nfactor "
                                                    "stiffness: 0.1, 0.5 N/mm\nfactor range: 2, 10 "
                                                    "mm\nset path: circle\nlongest trial: 40 s\n");
        for (std::size_t condition = 0; condition < 8; ++condition) {
            const auto trial = trial_of(experiment, {condition, 0, false, 1});
            const double stiffness = condition % 4 < 2 ? 0.1 : 0.5;
            const double range = condition % 2 == 0 ? 2.0 : 10.0;
            QCOMPARE(trial->longest_s, std::optional(40.0));
            const auto haptic = haptic_scene_of(*trial);
            QVERIFY(haptic);
            const Vec2 beside = trial->start + 0.05 * (bounds_of(trial->path.points).centre() - trial->start);
            const double force = length((*haptic)->law->at(beside).force);
            QVERIFY(std::abs(force - stiffness * (range < 2.5 ? 2.0 : 2.0)) <
                    0.05 * stiffness * range + 1e-3);
            QCOMPARE(std::isnan((*haptic)->law->at(beside).energy),
                     condition >= 4); // the published law has none
        }
    }
    void a_shape_to_be_named_surrounds_the_finger() {
        const Experiment experiment = shipped("primitives");
        for (const PlannedTrial& planned : trials_of(experiment, 1, 1)) {
            if (planned.training)
                continue;
            const auto trial = trial_of(experiment, planned);
            QVERIFY(trial->start == Vec2(0.0) && trial->path.points.empty() && trial->knots.empty());
            const Polyline line = flatten(trial->scene.contours.front());
            double round = 0.0;
            for (std::size_t i = 0; i < line.segment_count(); ++i)
                round += std::atan2(cross(line.segment_start(i), line.segment_end(i)),
                                    glm::dot(line.segment_start(i), line.segment_end(i)));
            QVERIFY(std::abs(std::abs(round) - 6.283185307179586) < 1e-6);
        }
    }
    /// Lim, Yoo and Choi (2019), Experiment II: primitives at the centre of the workspace, of a circumscribed radius of 2, 5 or 8 cm.
    void a_shape_to_be_named_has_the_published_place_and_size() {
        const Experiment experiment = shipped("primitives");
        std::multiset<long> radii;
        for (std::size_t condition = 0; condition < experiment.conditions(); ++condition)
            for (std::uint64_t seed = 1; seed <= 4; ++seed) {
                const auto trial = trial_of(experiment, {condition, 0, false, seed});
                double farthest = 0.0;
                for (const Vec2 place : flatten(trial->scene.contours.front()).points)
                    farthest = std::max(farthest, length(place)); // from the centre of the workspace
                radii.insert(std::lround(10.0 * farthest));
                QVERIFY(trial->asks && trial->law == LawKind::exact);
                QCOMPARE(trial->profile.stiffness, 0.2);
                QCOMPARE(trial->profile.range, 4.0);
            }
        for (const long tenths : {200L, 500L, 800L})
            QCOMPARE(radii.count(tenths), std::size_t{5 * 4});
        QCOMPARE(radii.size(), std::size_t{3 * 5 * 4});
    }
    void the_lines_of_training_are_straight_broken_once_and_curved() {
        const Experiment experiment = shipped("primitives");
        std::set<std::string> names;
        for (const PlannedTrial& planned : trials_of(experiment, 1, 1)) {
            if (!planned.training)
                continue;
            const auto trial = trial_of(experiment, planned);
            const Contour& contour = trial->scene.contours.front();
            names.insert(contour.name);
            QVERIFY(!trial->asks && !contour.closed);
            QCOMPARE(trial->longest_s, std::optional(20.0));
            const Polyline line = flatten(contour);
            for (const Vec2 place : line.points)
                QVERIFY(length(place) <= 80.0 + 1e-9);
            if (contour.name == "line")
                QCOMPARE(length_of(line), 160.0);
            if (contour.name == "broken-line") {
                QCOMPARE(line.points.size(), std::size_t{3});
                QVERIFY(std::abs(glm::dot(line.points[1] - line.points[0], line.points[2] - line.points[1])) <
                        1e-9);
            }
        }
        QCOMPARE(names.size(), std::size_t{3});
        const auto straight = trial_of(shipped("tracking"), trials_of(shipped("tracking"), 1, 1).front());
        QCOMPARE(straight->scene.contours.front().name, std::string("line"));
        QCOMPARE(length_of(straight->path), 200.0);
    }
    /// K = 0.5 N/mm and d = 10 mm ask for 5 N; above 1.5 N are 13 of the 25 pairs, each with three paths.
    void the_strongest_pull_of_an_experiment_is_its_largest_peak() {
        QCOMPARE(strongest_pull_n(shipped("tracking")), 5.0);
        QCOMPARE(conditions_cut_at(shipped("tracking"), 1.5), std::size_t{13 * 3});
        QCOMPARE(conditions_cut_at(shipped("tracking"), 5.0), std::size_t{0});
        QCOMPARE(strongest_pull_n(shipped("primitives")), 0.2 * 4.0);
        QCOMPARE(strongest_pull_n(paths), 0.2 * 4.0); // the program's own K and d
        QCOMPARE(strongest_pull_n(experiment_of("task: follow\nset path: line\nfactor range: 2, 4 mm\n"
                                                "training range: 30 mm\n")),
                 0.2 * 30.0);
    }
    void a_face_fills_the_surface_and_stands_upright() {
        const SquareFaces faces;
        const auto trial = trial_of(shipped("expressions"), {0, 0, false, 1}, &faces);
        const Rect face = bounds_of(flatten(trial->scene.contours[0]).points);
        QVERIFY(std::abs(face.width() - 180.0) < 1e-9 && length(face.centre()) < 1e-9);
        QCOMPARE(trial->scene.contours[0].name, std::string("smiling"));
        QVERIFY(bounds_of(flatten(trial->scene.contours[1]).points).max.y < -80.0);
    }
    void what_cannot_be_is_said() {
        const auto problem = [](const std::string& lines) {
            return trial_of(experiment_of(lines), {0, 0, false, 1}).error();
        };
        QVERIFY(problem("task: follow\nfactor range: 2, 4 mm\n").find("either a path, a shape or a face") !=
                std::string::npos);
        QVERIFY(problem("task: follow\nfactor path: circle, curve\nset shape: circle\n").find("either") !=
                std::string::npos);
        QVERIFY(problem("task: follow\nfactor path: circle, curve\nsurface: 60 x 200 mm\n")
                    .find("80 mm wide and 80 mm high does not fit on a surface of 60 x 200 mm") !=
                std::string::npos);
        QVERIFY(problem("task: follow\nfactor expression: sad, angry\n").find("task: name") !=
                std::string::npos);
        QVERIFY(
            problem("task: name\nfactor expression: sad, angry\nanswer: expression\n").find("needs faces") !=
            std::string::npos);
    }
};

} // namespace study_trial_test

TP_TEST(study_trial_test, StudyTrialTest, nothing)
#include "study_trial_test.moc"
