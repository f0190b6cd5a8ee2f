// SPDX-License-Identifier: Apache-2.0
#include "explore_parts.hpp"
#include "test_program.hpp"

#include <QStringList>
#include <QTest>

#include <memory>
#include <vector>

namespace explore_tour_test {

using namespace tp;

class ExploreTourTest : public QObject {
    Q_OBJECT
private slots:
    void a_tour_goes_round_the_feature_and_lets_go() {
        ExploreParts bench;
        bench.hand.goToFeature(left_eye);
        bench.tour.toggle();
        QVERIFY(bench.tour.touring());
        QCOMPARE(bench.voice.said().back(), QString("Tour round the left eye."));
        QTRY_VERIFY_WITH_TIMEOUT(bench.tour.progress() > 0.5, 30000);
        QVERIFY(bench.distance_to(left_eye, bench.finger.place()) < 3.0);
        QTRY_VERIFY_WITH_TIMEOUT(!bench.tour.touring(), 60000);
        QCOMPARE(bench.voice.said().back(), QString("Tour finished."));
        QVERIFY(bench.distance_to(left_eye, bench.finger.pointer()) < 4.0); // no jump back
        QTRY_COMPARE(bench.finger.featureName(), QString("left eye"));
    }

    void there_is_no_tour_without_force() {
        ExploreParts bench;
        bench.servo.disengage();
        bench.tour.toggle();
        QVERIFY(!bench.tour.touring());
        QVERIFY(bench.voice.said().back().contains("The force is off"));
    }

    void a_tour_of_the_face_names_each_feature_before_it_goes_there() {
        ExploreParts bench;
        auto photo = std::make_shared<LoadedPhoto>(*drawn_photo());
        auto& contours = photo->extraction.faces[0].contours;
        std::erase_if(contours, [](const Contour& contour) { return contour.name == feature::outline; });
        std::erase_if(contours, [](const Contour& contour) { return contour.name == feature::right_eye; });
        bench.view.show(photo);
        bench.voice.clear();
        bench.tour.toggleFace();
        QVERIFY(bench.tour.touring());
        QCOMPARE(bench.voice.said(), QStringList("Tour of the face: 2 feature(s). Left eye."));
        QTest::qWait(60);
        QCOMPARE(bench.tour.progress(), 0.0); // the name has not been spoken yet
        bench.time += 10.0;
        QTRY_VERIFY(bench.tour.progress() > 0.0);
        QTRY_COMPARE_WITH_TIMEOUT(bench.said(), QString("Lips."), 60000);
        QVERIFY(bench.tour.touring());
        bench.time += 10.0;
        QTRY_COMPARE_WITH_TIMEOUT(bench.said(), QString("Tour finished."), 60000);
        QVERIFY(!bench.tour.touring());
        QCOMPARE(bench.voice.said().size(), 3);
    }

    void a_name_is_followed_by_the_tour_of_its_feature_and_either_can_be_ended() {
        using State = ExploreTour::State;
        ExploreParts bench;
        QCOMPARE(bench.tour.state(), State::None);
        bench.tour.toggleFace();
        QCOMPARE(bench.tour.state(), State::Naming);
        bench.tour.toggle();
        QCOMPARE(bench.tour.state(), State::None);
        QCOMPARE(bench.said(), QString("Tour ended."));
        bench.tour.toggleFace();
        bench.time += 10.0;
        bench.tour.follow(0.0, bench.time);
        QCOMPARE(bench.tour.state(), State::Leading);
        QVERIFY(bench.servo.leads());
        bench.tour.follow(0.25, bench.time);
        QCOMPARE(bench.tour.progress(), 0.25);
        bench.tour.toggleFace();
        QCOMPARE(bench.tour.state(), State::None);
        QVERIFY(!bench.servo.leads());
        QCOMPARE(bench.tour.progress(), 0.0);
    }

    void the_hand_takes_the_lead_once_it_has_moved_far_enough() {
        ExploreParts bench;
        QVERIFY(bench.tour.yields_to(Vec2(50.0, 0.0))); // there is none
        bench.tour.toggle();
        QVERIFY(!bench.tour.yields_to(Vec2(10.0, 0.0))); // where it was is not known
        QVERIFY(!bench.tour.yields_to(Vec2(14.9, 0.0)));
        QVERIFY(bench.tour.yields_to(Vec2(15.1, 0.0)));
        QCOMPARE(bench.said(), QString("Tour ended."));
    }

    void another_photograph_ends_it() {
        ExploreParts bench;
        bench.tour.toggleFace();
        bench.view.show(drawn_photo(2));
        QCOMPARE(bench.tour.state(), ExploreTour::State::None);
    }
};

} // namespace explore_tour_test

TP_TEST(explore_tour_test, ExploreTourTest, event_loop)
#include "explore_tour_test.moc"
