// SPDX-License-Identifier: Apache-2.0
#include "explore_parts.hpp"
#include "test_program.hpp"

#include <QRectF>
#include <QStringList>
#include <QTest>
#include <QVariant>
#include <QVariantMap>

#include <cmath>

namespace explore_zoom_test {

using namespace tp;

class ExploreZoomTest : public QObject {
    Q_OBJECT
private slots:
    void several_faces_are_felt_together_or_one_by_one() {
        ExploreParts bench(2);
        QCOMPARE(bench.words.sentence(), QString("Two faces. Eyes, mouth and outline of each can be felt."));
        QCOMPARE(bench.view.featureCount(), 8);
        bench.hand.goToFeature(5);
        QCOMPARE(bench.voice.said().back(), QString("right eye of face 2"));
        bench.zoom.nextFace();
        QCOMPARE(bench.voice.said().back(), QString("Zoomed to face 1."));
        QCOMPARE(bench.view.featureCount(), 4);
        QCOMPARE(bench.view.faces().size(), 2); // the other one can still be chosen
        bench.zoom.nextFace();
        bench.hand.goToFeature(0);
        QCOMPARE(bench.voice.said().back(), QString("left eye"));
        bench.zoom.nextFace();
        QCOMPARE(bench.view.featureCount(), 8);
    }

    void zoom_in_and_out_by_steps() {
        ExploreParts bench(2, {"Anna", "Tom"});
        bench.hand.goToFeature(4); // Tom's
        QCOMPARE(bench.said(), QString("left eye of Tom"));
        QTRY_COMPARE(bench.finger.feature(), 4);
        QVERIFY(!bench.zoom.zoomed());
        const QStringList wanted{"Zoomed to Tom.", "Zoomed to the eyes of Tom.",
                                 "Zoomed to the mouth of Tom.",
                                 "Zoomed out to all 2 face(s). Left eye of Tom."};
        for (const QString& sentence : wanted) {
            bench.zoom.zoomIn();
            QCOMPARE(bench.said(), sentence);
            QVERIFY(bench.servo.engaged());
        }
        bench.zoom.chooseFace(0);
        QCOMPARE(bench.said(), QString("Zoomed to Anna."));
        bench.zoom.zoomIn();
        bench.zoom.zoomOut();
        QCOMPARE(bench.said(), QString("Zoomed to Anna."));
        bench.zoom.zoomOut();
        QCOMPARE(bench.said(), QString("Zoomed out to all 2 face(s). Left eye of Tom."));
        bench.sounds.hears(Earcon::ready);
        bench.zoom.zoomOut();
        QCOMPARE(bench.said(), QString("This is the whole picture."));
        QVERIFY(bench.sounds.hears(Earcon::list_end));
    }

    void a_part_fills_the_surface_and_the_photograph_lies_under_it() {
        ExploreParts bench;
        const double before = bench.view.photoRect().width();
        bench.zoom.zoomIn();
        QCOMPARE(bench.said(), QString("Zoomed to the eyes."));
        QVERIFY(bench.view.photoRect().width() > before);
        for (const Polyline& line : bench.view.felt().lines)
            for (const Vec2 point : line.points)
                QVERIFY(std::abs(point.x) <= 92.001 && std::abs(point.y) <= 67.001);
        for (const QVariant& face : bench.view.faces()) { // what a screen reader finds stays on the surface
            const QRectF rect = face.toMap()["rect"].toRectF();
            QVERIFY(QRectF(0.0, 0.0, 200.0, 150.0).contains(rect));
        }
    }

    void by_a_place_to_what_lies_there_and_out_where_nothing_does() {
        ExploreParts bench(2);
        const QPointF eye = bench.by(4, 2.0);
        bench.zoom.zoomHere(eye.x(), eye.y());
        QCOMPARE(bench.said(), QString("Zoomed to face 2."));
        bench.zoom.zoomHere(1.0, 1.0);
        QCOMPARE(bench.said(), QString("Zoomed out to all 2 face(s)."));
        bench.zoom.zoomHere(1.0, 1.0);
        QCOMPARE(bench.said(), QString("This is the whole picture."));
    }

    void a_zoom_ends_a_tour_without_a_word_about_it() {
        ExploreParts bench;
        bench.tour.toggleFace();
        bench.voice.clear();
        bench.zoom.zoomIn();
        QVERIFY(!bench.tour.touring());
        QCOMPARE(bench.voice.said(), QStringList("Zoomed to the eyes."));
    }

    void it_is_being_told_until_the_hand_moves_or_it_has_been_spoken() {
        ExploreParts bench;
        QVERIFY(!bench.zoom.tells(bench.time));
        bench.zoom.zoomIn();
        QVERIFY(bench.zoom.tells(bench.time));
        QVERIFY(!bench.zoom.tells(bench.time + 10.0));
        bench.time += 0.1;
        bench.hand.nudge(1.0, 0.0);
        QVERIFY(!bench.zoom.tells(bench.time));
    }

    void without_a_photograph_it_says_what_can_be_done() {
        ExploreParts bench(0);
        bench.zoom.nextFace();
        QCOMPARE(bench.voice.said(), QStringList());
        for (const auto act : {&ExploreZoom::zoomIn, &ExploreZoom::zoomOut}) {
            bench.voice.clear();
            (bench.zoom.*act)();
            QVERIFY(bench.said().startsWith("There is no photograph yet."));
        }
    }
};

} // namespace explore_zoom_test

TP_TEST(explore_zoom_test, ExploreZoomTest, event_loop)
#include "explore_zoom_test.moc"
