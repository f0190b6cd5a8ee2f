// SPDX-License-Identifier: Apache-2.0
// Taking a photograph by ear, in the time of the frames: one thing is said at a time, the camera is on only while the page is
// seen, and whoever has no camera hears why.
#include "capture_bench.hpp"
#include "test_program.hpp"

#include <QLocale>
#include <QSignalSpy>

namespace capture_session_test {

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

    void of_a_camera_that_is_not_on_nothing_is_said_that_nobody_knows() {
        CaptureBench bench;
        bench.camera->both = bench.camera->torch = true;
        bench.enter();
        bench.session->turnRound();
        QCOMPARE(bench.last_said(), QString("The camera is starting."));
        bench.session->setLight(true);
        QCOMPARE(bench.last_said(), QString("The camera is starting."));
        bench.see_for(0.2, {middle});
        bench.camera->film->fail("The camera was unplugged.");
        QTRY_COMPARE(bench.session->camera()->state(), CaptureCamera::Failed);
        bench.voice.clear();
        bench.session->setLight(true);
        QCOMPARE(bench.last_said(), QString("The camera was unplugged."));
        QVERIFY(!bench.camera->lit);
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

} // namespace capture_session_test

TP_TEST(capture_session_test, CaptureSessionTest, window)
#include "capture_session_test.moc"
