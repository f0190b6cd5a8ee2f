// SPDX-License-Identifier: Apache-2.0
#include "faces/contours/second_opinion.hpp"
#include "faces/decode/picture.hpp"
#include "faces/detect/embedded_detector.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>

namespace second_opinion_test {

using namespace tp;

namespace {

using Points = std::vector<Vec2>;

/// A frontal face whose eyes' outer corners are 100 px apart, every feature moved to the right by `aside` px.
Landmarks face_moved(double aside) {
    Landmarks face;
    const auto ring = [aside](Vec2 centre, double width, double height, std::size_t count, double from) {
        Points points;
        for (std::size_t i = 0; i < count; ++i) {
            const double angle = from + 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(count);
            points.push_back(centre + Vec2(width * std::cos(angle) + aside, height * std::sin(angle)));
        }
        return points;
    };
    face.right_eye = ring({115.0, 100.0}, 15.0, 5.0, 16, M_PI);
    face.left_eye = ring({185.0, 100.0}, 15.0, 5.0, 16, 0.0);
    face.outer_lip = ring({150.0, 190.0}, 28.0, 9.0, 20, M_PI);
    face.inner_lip = ring({150.0, 190.0}, 24.0, 2.0, 20, M_PI);
    for (int i = 0; i <= 32; ++i)
        face.outline.emplace_back(150.0 - 80.0 * std::cos(M_PI * i / 32.0) + aside,
                                  110.0 + 130.0 * std::sin(M_PI * i / 32.0));
    face.confidence = 0.99;
    return face;
}

double apart(const Points& one, const Points& other) {
    double sum = 0.0;
    for (std::size_t i = 0; i < one.size(); ++i)
        sum += length(one[i] - other[i]) / static_cast<double>(one.size());
    return sum;
}

} // namespace

class SecondOpinionTest : public QObject {
    Q_OBJECT

private slots:
    void where_both_agree_the_truth_lies_between() {
        const Landmarks ours = face_moved(0.0), mesh = face_moved(2.0), close = face_moved(1.9);
        const Landmarks both = settled(&ours, mesh, ours);
        for (const auto line : {&Landmarks::right_eye, &Landmarks::left_eye, &Landmarks::outer_lip,
                                &Landmarks::inner_lip, &Landmarks::outline}) {
            QVERIFY(apart(both.*line, ours.*line) > 0.5 && apart(both.*line, mesh.*line) > 0.5);
            QVERIFY(std::abs(apart(both.*line, ours.*line) + apart(both.*line, mesh.*line) - 2.0) < 1e-9);
        }
        QVERIFY(both.has_second_opinion && !ours.has_second_opinion);
        QVERIFY(std::abs(both.between_models_px[at_left_eye] - 2.0) < 1e-9);
        QVERIFY(std::abs(settled(&ours, mesh, close).between_close_px[at_outline] - 0.1) < 1e-9);
        QCOMPARE(both.confidence, ours.confidence);
    }
    /// Our nets put a covered feature anywhere; the others stay ours.
    void what_lies_far_off_is_the_meshs() {
        Landmarks ours = face_moved(0.0);
        const Landmarks mesh = face_moved(0.0);
        ours.left_eye = face_moved(12.0).left_eye;
        ours.outer_lip = face_moved(12.0).outer_lip;
        const Landmarks both = settled(&ours, mesh, ours);
        QCOMPARE(apart(both.left_eye, mesh.left_eye), 0.0);
        QCOMPARE(apart(both.outer_lip, mesh.outer_lip), 0.0);
        QCOMPARE(apart(both.right_eye, ours.right_eye), 0.0);
    }
    void close_looks_that_bear_the_mesh_out_take_the_place_of_ours() {
        const Landmarks ours = face_moved(12.0), mesh = face_moved(0.0), close = face_moved(1.0);
        const Landmarks both = settled(&ours, mesh, close), without = settled(nullptr, mesh, close);
        QVERIFY(apart(both.left_eye, close.left_eye) < 0.5);
        QCOMPARE(apart(both.left_eye, without.left_eye), 0.0);
        QCOMPARE(both.between_models_px[at_left_eye], 12.0);
        QVERIFY(std::abs(without.between_models_px[at_left_eye] - 1.0) < 1e-9);
    }
    void the_more_they_differ_the_less_ours_count() {
        double before = 0.0;
        for (const double off : {1.0, 2.9, 3.5, 4.0, 4.5, 5.0}) {
            const Landmarks ours = face_moved(off), mesh = face_moved(0.0);
            const double share = 1.0 - apart(settled(&ours, mesh, ours).right_eye, mesh.right_eye) / off;
            QVERIFY(share >= before - 1e-12);
            before = share;
        }
        QVERIFY(std::abs(before - 1.0) < 1e-12);
    }
    /// A shut eye: the mesh sees it open, and the picture shows where its lids are.
    void lids_that_the_picture_shows_are_not_the_meshs() {
        const Landmarks ours = face_moved(0.0), mesh = face_moved(3.0);
        const Landmarks both = settled(&ours, mesh, ours, {0.0, 0.5});
        QCOMPARE(apart(both.left_eye, ours.left_eye), 0.0);
        QVERIFY(apart(both.right_eye, ours.right_eye) > 0.5);
        QCOMPARE(apart(settled(&ours, mesh, ours, {-0.5, 0.0}).right_eye, both.right_eye), 0.0);
    }
    void eyes_in_one_place_are_the_meshs() {
        Landmarks mesh = face_moved(0.0);
        mesh.left_eye = mesh.right_eye;
        const Landmarks ours = face_moved(1.0);
        QCOMPARE(apart(settled(&ours, mesh, ours).outline, mesh.outline), 0.0);
    }

    void a_drawn_face_has_a_second_opinion_near_the_first() {
        const auto picture = read_picture(tp::test::in_source("resources/samples/anna_smiling.jpg"));
        QVERIFY2(picture.ok(), picture.error().c_str());
        EmbeddedDetector detector;
        ContourNets nets;
        SecondOpinion second(nets);
        const auto places = detector.detect(*picture, Effort::usual);
        QVERIFY(!places.empty());
        const auto ours = nets.locate(*picture, places[0]);
        QVERIFY(ours.has_value());
        const auto both = second.about(*picture, places[0], &*ours);
        QVERIFY(both.has_value());
        const double unit = length(ours->left_eye[0] - ours->right_eye[0]);
        QVERIFY(apart(both->settled.left_eye, ours->left_eye) < 0.05 * unit);
        QVERIFY(apart(both->settled.outer_lip, both->mesh.outer_lip) < 0.05 * unit);
        const auto alone = second.about(*picture, places[0], nullptr);
        QVERIFY(alone && apart(alone->settled.left_eye, both->settled.left_eye) < 0.05 * unit);
    }
    void there_is_none_where_there_is_no_face() {
        cv::Mat noise(400, 400, CV_8UC3);
        cv::RNG(5).fill(noise, cv::RNG::UNIFORM, 0, 255);
        ContourNets nets;
        SecondOpinion second(nets);
        for (const double at : {100.0, 200.0, 1e9, double(NAN)})
            QVERIFY(!second.about(
                noise, {{Vec2(at), Vec2(at + 80.0)}, Vec2(at + 20.0), Vec2(at + 60.0, at + 20.0), 0.9},
                nullptr));
    }
};

} // namespace second_opinion_test

TP_TEST(second_opinion_test, SecondOpinionTest, event_loop)
#include "second_opinion_test.moc"
