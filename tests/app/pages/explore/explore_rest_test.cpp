// SPDX-License-Identifier: Apache-2.0
// Explore at rest: with the finger up for two seconds nothing ticks, and it is back at a touch.
#include "app/pages/explore/rest_watch.hpp"
#include "app/parts/controls/recording_announcer.hpp"
#include "explore_bench.hpp"

#include <QTest>

using namespace tp;

namespace {

struct Bench {
    double time = 100.0;
    RecordingVoice voice;
    RecordingAnnouncer announcer;
    Narrator narrator{voice, announcer};
    ExploreSounds sounds;
    ExploreSession session{narrator, sounds.earcons, sounds.guide, sounds.preferences, settings_at(time)};

    Bench() {
        session.show(drawn_photo());
        session.enter();
        QTest::qWait(40); // it has looked
    }
    /// So many millimetres left of the outline's left side.
    QPointF beside_the_outline(double away = 2.0) const {
        const auto& points = session.view()->felt().lines.at(3).points;
        return session.view()->frame().from_surface(0.5 * (points[0] + points[1]) - Vec2(away, 0.0));
    }
    void touch(QPointF place) { session.hand()->fingerDown(0, place.x(), place.y()); }
    /// The page's time passes, and it looks at what there is.
    void pass(double seconds) {
        for (double t = 0.0; t < seconds; t += 0.5) {
            time += 0.5;
            QTest::qWait(40);
        }
    }
    bool comes_to_rest() {
        pass(RestWatch::after_s + 0.5);
        return QTest::qWaitFor([this] { return session.at_rest(); }, 20'000);
    }
};

} // namespace

class ExploreRestTest : public QObject {
    Q_OBJECT
private slots:
    void it_is_due_after_two_quiet_seconds_in_one() {
        RestWatch watch;
        QVERIFY(!watch.due(true, 10.0));
        QVERIFY(!watch.due(true, 11.9));
        QVERIFY(!watch.due(false, 11.95));
        QVERIFY(!watch.due(true, 12.5));
        QVERIFY(!watch.due(true, 14.4));
        QVERIFY(watch.due(true, 14.5));
        watch.stir();
        QVERIFY(!watch.due(true, 20.0));
        QVERIFY(watch.due(true, 22.0));
    }

    void where_nobody_comes_it_rests_with_the_force_still_wanted() {
        Bench bench;
        bench.pass(1.5);
        QVERIFY(!bench.session.at_rest());
        QVERIFY(bench.comes_to_rest());
        QVERIFY(bench.session.device()->engaged());
    }

    void two_seconds_after_the_finger_was_lifted_it_rests_and_a_touch_wakes_it() {
        Bench bench;
        bench.touch(bench.beside_the_outline());
        QTRY_VERIFY(bench.session.finger()->newtons() > 0.1);
        bench.pass(5.0);
        QVERIFY(!bench.session.at_rest()); // a finger that lies still feels
        bench.session.hand()->fingerUp(0);
        bench.pass(1.5);
        QVERIFY(!bench.session.at_rest());
        QVERIFY(bench.comes_to_rest());
        bench.voice.clear();
        bench.touch(bench.beside_the_outline());
        QVERIFY(!bench.session.at_rest());
        QTRY_VERIFY(bench.session.finger()->newtons() > 0.1); // the force is there again
        const QPointF on_it = bench.beside_the_outline(0.0);
        bench.session.hand()->fingerMoved(0, on_it.x(), on_it.y());
        bench.pass(1.0);
        QVERIFY(!bench.voice.said().filter("outline").isEmpty()); // and it is told
    }

    void a_mouse_that_rests_on_the_picture_is_felt_and_one_that_has_gone_is_not() {
        Bench bench;
        const QPointF place = bench.beside_the_outline();
        bench.session.hand()->touchDown(place.x(), place.y());
        bench.pass(5.0);
        QVERIFY(!bench.session.at_rest());
        bench.session.hand()->handGone();
        QVERIFY(bench.comes_to_rest());
        bench.session.hand()->moveTo(place.x() + 1.0, place.y());
        QVERIFY(!bench.session.at_rest());
        bench.session.hand()->handGone();
        QVERIFY(bench.comes_to_rest());
        bench.session.hand()->nudge(2.0, 0.0); // the keys stay where they are
        bench.pass(5.0);
        QVERIFY(!bench.session.at_rest());
    }

    void a_tour_goes_on_and_begins_from_rest() {
        Bench bench;
        QVERIFY(bench.comes_to_rest());
        bench.session.tour()->toggleFace();
        QVERIFY(bench.session.tour()->touring());
        QVERIFY(!bench.session.at_rest());
        bench.pass(5.0);
        QVERIFY(!bench.session.at_rest());
        QTRY_COMPARE(bench.session.tour()->state(), ExploreTour::State::Leading); // its names are told, too
        bench.session.tour()->toggleFace();
        QVERIFY(bench.comes_to_rest());
        bench.session.tour()->toggle();
        QTRY_VERIFY(bench.session.tour()->progress() > 0.0);
    }

    void escape_and_enter_act_at_rest_as_they_do_awake() {
        Bench bench;
        QVERIFY(bench.comes_to_rest());
        QVERIFY(bench.session.stop());
        QVERIFY(!bench.session.device()->engaged());
        QVERIFY(bench.comes_to_rest());
        bench.session.stopOrStart();
        QVERIFY(bench.session.device()->engaged());
        bench.touch(bench.beside_the_outline());
        QTRY_VERIFY(bench.session.finger()->newtons() > 0.1);
    }

    void a_page_that_is_left_at_rest_is_felt_when_one_comes_back() {
        Bench bench;
        QVERIFY(bench.comes_to_rest());
        bench.session.leave();
        QVERIFY(!bench.session.device()->engaged());
        bench.pass(3.0);
        bench.session.enter();
        QVERIFY(bench.session.device()->engaged());
        QVERIFY(!bench.session.at_rest());
        bench.pass(1.0);
        QVERIFY(!bench.session.at_rest()); // one may just have come
        bench.touch(bench.beside_the_outline());
        QTRY_VERIFY(bench.session.finger()->newtons() > 0.1);
    }

    void another_photograph_is_felt_for_a_while_before_it_rests() {
        Bench bench;
        QVERIFY(bench.comes_to_rest());
        bench.session.show(drawn_photo(2));
        QVERIFY(!bench.session.at_rest());
        bench.pass(1.0);
        QVERIFY(!bench.session.at_rest());
        QVERIFY(bench.comes_to_rest());
    }
};

QTEST_GUILESS_MAIN(ExploreRestTest)
#include "explore_rest_test.moc"
