// SPDX-License-Identifier: Apache-2.0
#include "explore_parts.hpp"
#include "test_program.hpp"

#include <QPointF>
#include <QStringList>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace explore_ear_test {

using namespace tp;

namespace {

/// Hertz of the first beep's two halves, from rising zero crossings.
std::pair<double, double> halves_of_first_beep(const std::vector<float>& heard) {
    const auto begin = std::ranges::find_if(heard, [](float x) { return std::abs(x) > 1e-5F; });
    const auto hertz = [&](int from_ms, int to_ms) {
        int periods = -1;
        std::ptrdiff_t first = 0;
        std::ptrdiff_t last = 0;
        for (auto i = begin + from_ms * 48 + 1; i < begin + to_ms * 48; ++i)
            if (*(i - 1) < 0.0F && *i >= 0.0F) {
                last = i - begin;
                first = periods++ < 0 ? last : first;
            }
        return periods > 0 ? 48000.0 * periods / static_cast<double>(last - first) : 0.0;
    };
    return {hertz(0, 22), hertz(28, 50)};
}

} // namespace

class ExploreEarTest : public QObject {
    Q_OBJECT
private slots:
    void a_feature_is_told_with_its_person_once_the_finger_stays() {
        ExploreParts bench(1, {"Anna"});
        bench.down(bench.by(left_eye));
        bench.move(bench.by(left_eye), 0.140);
        QCOMPARE(bench.voice.said(), QStringList());
        bench.move(bench.by(left_eye), 0.011);
        QCOMPARE(bench.voice.said(), QStringList("left eye of Anna"));
        bench.stay(bench.by(left_eye), 2.0);
        QCOMPARE(bench.voice.said(), QStringList("left eye of Anna"));
        bench.hand.fingerUp(0);
        bench.down(bench.by(left_eye)); // set down anew, it is told anew
        bench.stay(bench.by(left_eye), 0.2);
        QCOMPARE(bench.voice.said().size(), 2);
    }

    void a_finger_that_passes_over_features_hears_no_names() {
        ExploreParts bench(1, {"Anna"});
        bench.sounds.preferences.change([](Choices& choices) { choices.guide = Choices::Guide::sonar; });
        bench.down(bench.left_of_outline(30.0));
        for (double away = 30.0; away > -30.0; away -= 3.0)
            bench.move(bench.left_of_outline(away));
        QCOMPARE(bench.voice.said(), QStringList());
    }

    void the_sonar_begins_with_the_touch_and_ends_with_it() {
        ExploreParts bench;
        QVERIFY(!bench.sounds.guide.sounds());
        bench.down(bench.left_of_outline(10.0));
        QVERIFY(bench.sounds.guide.sounds()); // in the same call: no poll was waited for
        QVERIFY(bench.sounds.guide_peak() > 0.03);
        bench.hand.fingerUp(0);
        QVERIFY(!bench.sounds.guide.sounds());
        bench.sounds.guide_peak(0.02);
        QCOMPARE(bench.sounds.guide_peak(1.0), 0.0);
    }

    void the_nearer_the_faster_and_on_the_line_one_tone() {
        const auto beeps_in_two_seconds = [](double away) {
            ExploreParts bench;
            bench.down(bench.left_of_outline(away));
            bench.sounds.guide_output.play(2.0);
            int beeps = 0;
            int quiet = 1000;
            for (const float sample : bench.sounds.guide_output.heard) {
                beeps += std::abs(sample) > 1e-5F && quiet > 200 ? 1 : 0;
                quiet = std::abs(sample) > 1e-5F ? 0 : quiet + 1;
            }
            return beeps;
        };
        const int far = beeps_in_two_seconds(20.0);
        const int near = beeps_in_two_seconds(5.0);
        QVERIFY2(far >= 4 && near > 2 * far, qPrintable(QString("%1, %2").arg(far).arg(near)));
        QCOMPARE(beeps_in_two_seconds(0.5), 1);
    }

    void a_line_above_rises_and_one_below_falls() {
        for (const double up : {-12.0, 12.0}) {
            ExploreParts bench;
            const auto& points = bench.view.felt().lines[outline].points; // its second piece is level
            const QPointF place =
                bench.view.frame().from_surface(0.5 * (points[1] + points[2]) + Vec2(0.0, up));
            bench.down(place);
            bench.sounds.guide_output.play(0.2);
            const auto [first, second] = halves_of_first_beep(bench.sounds.guide_output.heard);
            QVERIFY2(up < 0.0 ? second > 1.15 * first : second < first / 1.15,
                     qPrintable(QString("%1 Hz, %2 Hz").arg(first).arg(second)));
        }
    }

    void the_guide_is_what_the_person_has_chosen() {
        ExploreParts bench;
        const auto choose = [&](Choices::Guide guide) {
            bench.sounds.preferences.change([&](Choices& choices) { choices.guide = guide; });
        };
        choose(Choices::Guide::none);
        bench.down(bench.left_of_outline(12.0));
        bench.stay(bench.left_of_outline(12.0), 3.0);
        QVERIFY(!bench.sounds.guide.sounds());
        QCOMPARE(bench.voice.said(), QStringList());
        choose(Choices::Guide::clock_voice);
        bench.stay(bench.left_of_outline(12.0), 3.0);
        QVERIFY(!bench.sounds.guide.sounds());
        QCOMPARE(bench.voice.said(), QStringList("3 o'clock, 12 millimetre(s)"));
        choose(Choices::Guide::both);
        bench.move(bench.left_of_outline(12.0));
        QVERIFY(bench.sounds.guide.sounds());
        choose(Choices::Guide::none); // at once, though the finger does not move
        QVERIFY(!bench.sounds.guide.sounds());
    }

    void the_clock_voice_speaks_when_the_finger_rests_and_never_over_itself() {
        ExploreParts bench;
        bench.down(bench.left_of_outline(30.0));
        double last = 0.0;
        double shortest = 1e9;
        qsizetype count = 0;
        for (int i = 0; i < 2000; ++i) { // 20 s of drifting to and fro
            bench.move(bench.left_of_outline(25.0 + 15.0 * std::sin(0.002 * i * i / 40.0)), 0.01);
            if (bench.voice.said().size() == count)
                continue;
            if (count > 0)
                shortest = std::min(shortest, bench.time - last);
            count = bench.voice.said().size();
            last = bench.time;
        }
        QVERIFY(count >= 3);
        QVERIFY2(shortest >= speech_seconds("3 o'clock, 12 millimetres"),
                 qPrintable(QString::number(shortest)));
        QCOMPARE(bench.voice.last_priority(), Priority::touch);
    }

    void entering_a_face_leaving_it_and_crossing_a_line_are_heard() {
        ExploreParts bench;
        bench.sounds.hears(Earcon::ready);
        bench.down(bench.left_of_outline(10.0));
        QVERIFY(!bench.sounds.hears(Earcon::face_entered));
        bench.move(bench.left_of_outline(-10.0), 1.0);
        QVERIFY(bench.sounds.hears(Earcon::face_entered));
        bench.move(bench.left_of_outline(10.0), 1.0);
        QVERIFY(bench.sounds.hears(Earcon::face_left));
        bench.down(bench.by(left_eye, 5.0, 3.0));
        bench.hand.fingerUp(0);
        bench.time += 1.0;
        bench.down(bench.by(left_eye, 5.0, 3.0));
        bench.sounds.hears(Earcon::face_entered);
        bench.move(bench.by(left_eye, 5.0, -3.0), 1.0);
        QVERIFY(bench.sounds.hears(Earcon::contour_crossed));
    }

    void a_mouse_that_leaves_the_surface_is_silent_until_it_comes_back() {
        ExploreParts bench;
        bench.sounds.hears(Earcon::ready);
        const QPointF eye = bench.by(left_eye, 5.0, 3.0);
        bench.hand.touchDown(eye.x(), eye.y());
        bench.time += 1.0;
        const auto enters = [&] { return bench.sounds.hears(Earcon::face_entered); };
        QVERIFY(QTest::qWaitFor(enters));
        bench.hand.handGone();
        bench.voice.clear();
        for (int i = 0; i < 5; ++i) {
            bench.time += 1.0;
            QTest::qWait(50); // some polls
            QVERIFY(!enters());
        }
        QCOMPARE(bench.voice.said(), QStringList());
        bench.hand.moveTo(eye.x(), eye.y() - 0.5);
        bench.time += 1.0;
        QVERIFY(QTest::qWaitFor(enters));
    }

    void what_the_hand_is_drawn_to_after_a_zoom_is_told_when_the_zoom_was() {
        QPointF beside_the_eye;
        {
            ExploreParts before;
            before.zoom.zoomIn();
            beside_the_eye = before.by(left_eye, -1.5 * FeatureTracker::enter_mm);
        }
        ExploreParts bench;
        bench.hand.moveTo(beside_the_eye.x(), beside_the_eye.y());
        bench.time += 2.0;
        QTest::qWait(100); // the servo comes to rest where nothing pulls
        bench.zoom.zoomIn();
        QCOMPARE(bench.said(), QString("Zoomed to the eyes."));
        QTRY_COMPARE(bench.finger.feature(), left_eye);
        bench.time += 0.5;
        QTest::qWait(100); // it is looked at many times meanwhile
        QCOMPARE(bench.said(), QString("Zoomed to the eyes."));
        bench.time += 10.0;
        QTRY_VERIFY((bench.time += 0.1, bench.said() == "left eye"));
    }

    void a_tour_is_heard_where_it_is_not_felt() {
        ExploreParts bench;
        bench.hand.goToFeature(left_eye);
        bench.tour.toggle();
        QTRY_VERIFY(bench.sounds.guide.sounds());
        QVERIFY(bench.sounds.guide_peak() > 0.02);
        bench.tour.toggle();
        QVERIFY(!bench.sounds.guide.sounds());
        QCOMPARE(bench.said(), QString("Tour ended."));
    }

    void a_page_out_of_sight_hears_nothing_and_one_that_was_hushed_waits_for_the_next_touch() {
        using State = ExploreEar::State;
        ExploreParts bench;
        bench.down(bench.left_of_outline(10.0));
        QVERIFY(bench.ear.sounds());
        bench.ear.hush();
        QVERIFY(!bench.ear.sounds());
        bench.move(bench.left_of_outline(11.0));
        QVERIFY(!bench.ear.sounds());
        bench.ear.listen();
        bench.move(bench.left_of_outline(12.0));
        QVERIFY(bench.ear.sounds());
        bench.ear.leave();
        QVERIFY(!bench.ear.sounds());
        for (const auto act : {&ExploreEar::listen, &ExploreEar::hush}) {
            (bench.ear.*act)();
            QCOMPARE(bench.ear.state(), State::away);
        }
        bench.move(bench.left_of_outline(11.0));
        QVERIFY(!bench.ear.sounds());
        bench.ear.enter();
        QCOMPARE(bench.ear.state(), State::open);
    }
};

} // namespace explore_ear_test

TP_TEST(explore_ear_test, ExploreEarTest, event_loop)
#include "explore_ear_test.moc"
