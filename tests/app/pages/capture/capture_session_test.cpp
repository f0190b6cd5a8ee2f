// SPDX-License-Identifier: Apache-2.0
// Taking a photograph by ear, in the time of the frames: one thing is said at a time, the camera is on only while the page is
// seen, and whoever has no camera hears why.
#include "capture_bench.hpp"

#include <QLocale>
#include <QRegularExpression>
#include <QSignalSpy>

using namespace tp;

namespace {

const Vec2 at_the_right{0.85, 0.45};
const Vec2 at_the_left{0.15, 0.45};
const Vec2 middle{0.5, 0.45};

} // namespace

class CaptureSessionTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English)); }

    void at_the_first_start_it_is_told_how_it_works() {
        CaptureBench bench{Choices()};
        bench.enter();
        QVERIFY2(bench.voice.said().front().contains("taken automatically"),
                 qPrintable(bench.voice.said().front()));
        bench.session->leave();
        bench.voice.clear();
        bench.enter();
        QCOMPARE(bench.voice.said().front(), QString("Take a photograph. One face in the middle."));
    }

    void the_hand_is_told_where_to_go_whole_first_and_short_then() {
        CaptureBench bench;
        bench.enter();
        bench.voice.clear();
        bench.see_for(0.5, {at_the_right});
        QVERIFY2(bench.last_said().startsWith("1 face") &&
                     bench.last_said().endsWith("Move the tablet: far right."),
                 qPrintable(bench.last_said()));
        bench.see_for(3.0, {at_the_left});
        QCOMPARE(bench.last_said(), QString("Far left."));
    }

    void the_front_camera_sees_the_persons_left_at_the_right() {
        CaptureBench bench;
        bench.camera->both = true;
        bench.enter();
        bench.see_for(0.3, {middle});
        bench.session->turnRound();
        QTRY_COMPARE(bench.camera->opened, 2);
        QVERIFY(bench.session->camera()->front());
        bench.voice.clear();
        bench.see_for(0.5, {at_the_right});
        QVERIFY2(bench.last_said().contains("far left"), qPrintable(bench.last_said()));
    }

    void one_thing_is_said_at_a_time() {
        CaptureBench bench;
        bench.enter();
        bench.voice.clear();
        bench.speak_slowly();
        bench.see_for(0.5, {at_the_right});
        bench.see_for(3.0, {at_the_left});
        QCOMPARE(bench.voice.said().size(), 1);
        bench.voice.set_busy(false);
        bench.see_for(0.5, {at_the_left});
        QCOMPARE(bench.voice.said().size(), 2);
        QCOMPARE(bench.last_said(), QString("Far left."));
    }

    void advice_waits_for_other_words_and_comes_after_them() {
        CaptureBench bench;
        bench.enter();
        bench.see_for(0.2, {middle});
        bench.voice.clear();
        bench.speak_slowly();
        bench.session->choices()->setByItself(false);
        bench.see_for(4.0, {at_the_right});
        QCOMPARE(bench.voice.said().size(), 1);
        bench.voice.set_busy(false);
        bench.see_for(0.3, {at_the_right});
        QVERIFY2(bench.last_said().contains("far right"), qPrintable(bench.last_said()));
    }

    void the_aim_is_chosen_and_told() {
        CaptureBench bench;
        bench.enter();
        bench.voice.clear();
        bench.session->choices()->chooseAim(3);
        QCOMPARE(bench.last_said(), QString("Everybody in view."));
        bench.see_for(0.5, {{0.2, 0.45}, {0.4, 0.45}});
        QVERIFY2(bench.last_said().contains("left"), qPrintable(bench.last_said()));
        bench.session->choices()->chooseAim(17);
        QCOMPARE(bench.session->choices()->aim(), Aim::everybody);
    }

    void after_it_was_taken_nobody_is_told_to_hold_still() {
        CaptureBench bench;
        bench.enter();
        bench.see_for(4.0, {middle});
        bench.settle();
        QCOMPARE(bench.photographs().size(), 1);
        QVERIFY(!bench.voice.said().filter("Hold still").isEmpty());
        bench.voice.clear();
        bench.see_for(15.0, {middle});
        QVERIFY2(bench.voice.said().filter("Hold still").isEmpty(), qPrintable(bench.voice.said().join('|')));
        bench.see_for(1.0, {at_the_right});
        QVERIFY(!bench.voice.said().filter("right").isEmpty());
        bench.voice.clear();
        bench.see_for(3.0, {middle});
        QVERIFY(!bench.voice.said().filter("Hold still").isEmpty());
    }

    void whose_face_it_is_is_told_as_soon_as_it_is_known() {
        CaptureBench bench;
        bench.enter();
        bench.voice.clear();
        bench.see_for(0.5, {at_the_right});
        QVERIFY2(bench.last_said().startsWith("1 face"), qPrintable(bench.last_said()));
        bench.names = {"Anna"};
        bench.see_for(3.0, {middle});
        QVERIFY2(bench.voice.said().filter(QRegularExpression("^Anna\\. ")).size() == 1,
                 qPrintable(bench.voice.said().join('|')));
    }

    void two_are_named_as_far_as_they_are_known_and_only_when_that_is_news() {
        CaptureBench bench;
        bench.session->choices()->chooseAim(static_cast<int>(Aim::everybody));
        bench.enter();
        bench.voice.clear();
        const std::vector<Vec2> side_by_side{{0.1, 0.45}, {0.3, 0.45}};
        bench.see_for(0.5, side_by_side);
        QVERIFY2(bench.last_said().startsWith("2 face"), qPrintable(bench.last_said()));
        bench.names = {"Anna"};
        bench.see_for(3.0, side_by_side);
        bench.names = {"Anna", "Ben"};
        bench.see_for(8.0, side_by_side);
        const QStringList said = bench.voice.said();
        const auto count = [&](const QString& begin) {
            return said.filter(QRegularExpression('^' + begin)).size();
        };
        QVERIFY2(count("Anna and 1 more face") == 1 && count("Anna and Ben\\. ") == 1 && count("2 face") == 1,
                 qPrintable(said.join('|')));
        QVERIFY2(said.size() > 3 && !said.back().contains("Anna"), qPrintable(said.join('|')));
        bench.voice.clear();
        bench.session->tellAll();
        QVERIFY2(bench.last_said().startsWith("Anna and Ben. "), qPrintable(bench.last_said()));
    }

    void who_asks_hears_who_is_seen_and_what_to_do() {
        CaptureBench bench;
        bench.enter();
        bench.see_for(0.5, {{0.98, 0.45}});
        bench.voice.clear();
        bench.session->tellAll();
        QVERIFY2(bench.last_said().endsWith("Cut off at the right edge. Move the tablet: far right."),
                 qPrintable(bench.last_said()));
    }

    void a_tone_leads_and_falls_silent_with_escape() {
        CaptureBench bench;
        bench.enter();
        bench.see_for(0.3, {at_the_right});
        QVERIFY(bench.guide.sounds());
        QVERIFY(bench.session->stop());
        QVERIFY(!bench.guide.sounds());
        bench.voice.clear();
        bench.see_for(3.0, {at_the_left});
        QVERIFY(!bench.guide.sounds());
        QVERIFY2(bench.voice.said().isEmpty(), qPrintable(bench.last_said()));
        QVERIFY(!bench.session->stop()); // the next Escape leads home
        bench.session->listen();
        bench.see_for(0.3, {at_the_left});
        QVERIFY(bench.guide.sounds());
        QVERIFY(!bench.voice.said().isEmpty());
    }

    void whoever_wants_no_beeps_hears_none() {
        Choices choices = CaptureBench::told();
        choices.guide = Choices::Guide::none;
        CaptureBench bench(choices);
        bench.enter();
        bench.see_for(0.5, {at_the_right});
        QVERIFY(!bench.guide.sounds());
        QVERIFY(!bench.voice.said().isEmpty());
    }

    void the_camera_is_off_and_nothing_is_kept_when_the_page_is_left() {
        CaptureBench bench;
        bench.enter();
        bench.see_for(0.5, {at_the_right});
        QVERIFY(!bench.session->camera()->picture().value<QImage>().isNull());
        QVERIFY(!bench.session->camera()->last_frames().empty());
        bench.session->leave();
        QVERIFY(!bench.camera->on);
        QVERIFY(bench.session->camera()->picture().value<QImage>().isNull());
        QVERIFY(bench.session->camera()->last_frames().empty());
        QVERIFY(!bench.guide.sounds());
        QCOMPARE(bench.session->camera()->state(), CaptureCamera::Off);
    }

    void a_page_that_is_left_at_once_never_switches_it_on() {
        CaptureBench bench;
        bench.session->enter();
        bench.session->leave();
        QTest::qWait(0);
        QCOMPARE(bench.camera->opened, 0);
    }

    void it_is_off_while_the_window_is_not_to_be_seen() {
        CaptureBench bench;
        bench.enter();
        bench.see_for(0.3, {middle});
        bench.session->setInSight(false);
        QVERIFY(!bench.camera->on);
        bench.session->setInSight(true);
        QTRY_VERIFY(bench.camera->on);
        bench.session->leave();
        bench.session->setInSight(false);
        bench.session->setInSight(true);
        QTest::qWait(0);
        QVERIFY(!bench.camera->on);
    }

    void without_a_camera_one_sentence_says_why_and_leads_to_import() {
        CaptureBench bench;
        bench.camera->why_not = "No camera was found on this computer.";
        bench.session->enter();
        QTRY_COMPARE(bench.session->camera()->state(), CaptureCamera::Failed);
        QCOMPARE(bench.last_said(),
                 QString("No camera was found on this computer. Press I to import photographs of "
                         "another camera."));
        const QSignalSpy asked(bench.session.get(), &CaptureSession::importAsked);
        bench.session->importInstead();
        QCOMPARE(asked.size(), 1);
        bench.camera->why_not.clear();
        bench.session->tryAgain();
        QTRY_VERIFY(bench.camera->on);
        bench.see(std::vector<Vec2>{middle});
        QCOMPARE(bench.session->camera()->state(), CaptureCamera::On);
    }

    void a_camera_that_is_unplugged_is_told_and_switched_off() {
        CaptureBench bench;
        bench.enter();
        bench.see_for(0.5, {at_the_right});
        bench.voice.clear();
        bench.camera->film->fail("The camera was unplugged.");
        QTRY_COMPARE(bench.session->camera()->state(), CaptureCamera::Failed);
        QVERIFY2(bench.last_said().startsWith("The camera was unplugged."), qPrintable(bench.last_said()));
        QVERIFY(!bench.camera->on);
        QVERIFY(!bench.guide.sounds());
    }

    void the_light_is_switched_where_there_is_one() {
        CaptureBench bench;
        bench.enter();
        bench.see_for(0.2, {middle});
        bench.session->setLight(true);
        QCOMPARE(bench.last_said(), QString("This camera has no light."));
        bench.session->leave();
        bench.camera->torch = true;
        bench.enter();
        bench.see_for(0.2, {middle});
        bench.session->setLight(true);
        QVERIFY(bench.camera->lit);
        QCOMPARE(bench.last_said(), QString("Light on."));
    }

    void keys_move_the_camera_at_a_desk() {
        CaptureBench bench;
        bench.camera->movable = true;
        bench.enter();
        bench.session->moveCamera(-1, 2, 0, 1);
        QVERIFY(bench.camera->moved.pan_deg < 0.0 && bench.camera->moved.tilt_deg > 0.0);
        QVERIFY(bench.camera->moved.forward_m > 0.0);
    }
};

QTEST_MAIN(CaptureSessionTest)
#include "capture_session_test.moc"
