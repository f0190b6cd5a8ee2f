// SPDX-License-Identifier: Apache-2.0
// A real device under the Explore page: its handle is the finger, its force is the person's own, and it comes and goes.
#include "app/parts/controls/recording_announcer.hpp"
#include "app/parts/finger/fault_watch.hpp"
#include "device/calibration_file.hpp"
#include "device_socket.hpp"
#include "explore_bench.hpp"
#include "test_program.hpp"

#include <QLineF>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <filesystem>

namespace explore_device_test {

using namespace tp;
using tp::testing::DeviceSocket;

namespace {

constexpr int left_eye = 0;
constexpr int outline = 3;

struct Bench {
    QTemporaryDir folder;
    DeviceSocket socket;
    RecordingVoice voice;
    RecordingAnnouncer announcer;
    Narrator narrator{voice, announcer};
    ExploreSounds sounds;
    ExploreSession session;

    /// `time`: what the session's clock shows; null: the real one.
    explicit Bench(bool keeps_calibrations = false, const double* time = nullptr)
        : session(narrator, sounds.earcons, sounds.guide, sounds.preferences, settings(keeps_calibrations, time)) {
        hold_at({0.0, 0.0});
    }
    std::filesystem::path calibrations() const { return folder.filePath("calibrations.txt").toStdString(); }
    ExploreSettings settings(bool keeps_calibrations, const double* time) {
        ExploreSettings made = time != nullptr ? settings_at(*time) : patient_settings();
        made.devices = socket.access();
        if (keeps_calibrations)
            made.devices.calibrations = calibrations();
        return made;
    }
    /// As the program does: the page comes into sight, and a photograph is opened.
    void begin() {
        session.enter();
        session.show(drawn_photo());
    }
    bool with_device() { return !session.device()->name().isEmpty(); }
    bool begins_with_device() {
        socket.plug_in();
        begin();
        return QTest::qWaitFor([this] { return with_device(); });
    }
    /// The middle of the device's reach, (0, 100) mm, lies on the middle of the surface.
    void hold_at(Vec2 surface) { socket.hold_at(surface + Vec2(0.0, 100.0)); }
    /// Frame of the sheet.
    bool finger_is_at(QPointF place) { return QLineF(session.finger()->place(), place).length() < 1e-6; }
    /// A place left of the outline's left side by so much, surface frame.
    Vec2 left_of_outline(double away) const {
        const auto& points = session.view()->felt().lines.at(outline).points;
        return 0.5 * (points[0] + points[1]) - Vec2(away, 0.0);
    }
    bool said(const QString& part) const { return !voice.said().filter(part).isEmpty(); }
};

} // namespace

class ExploreDeviceTest : public QObject {
    Q_OBJECT
private slots:
    void what_the_handle_is_drawn_to_after_a_zoom_is_told_when_the_zoom_was() {
        double time = 100.0;
        Bench bench(false, &time);
        QVERIFY(bench.begins_with_device());
        bench.session.zoom()->zoomIn();
        const Vec2 eye = bench.session.view()->felt().lines.at(left_eye).points[0];
        bench.session.zoom()->zoomOut();
        bench.hold_at(eye - Vec2(1.5 * FeatureTracker::enter_mm, 0.0));
        QTest::qWait(100);
        time += 10.0;
        bench.session.zoom()->zoomIn();
        QVERIFY(bench.said("Zoomed to the eyes."));
        bench.voice.clear();
        time += 0.1;
        bench.hold_at(eye); // as the force draws it
        QTRY_COMPARE(bench.session.finger()->feature(), left_eye);
        time += 0.5;
        QTest::qWait(100); // it is looked at many times meanwhile
        QCOMPARE(bench.voice.said(), QStringList());
        time += 10.0;
        QTRY_VERIFY((time += 0.1, bench.said("left eye")));
    }

    void a_device_that_is_there_gets_the_force_when_the_person_comes() {
        Bench bench;
        QVERIFY(bench.begins_with_device());
        QCOMPARE(bench.session.device()->name(), QString("force pad"));
        QVERIFY(bench.session.device()->engaged());
        QTRY_VERIFY(bench.said("Device: force pad. Its force is on."));
        // Its handle is the finger, and the mouse is not.
        const Vec2 place = bench.left_of_outline(4.0);
        bench.hold_at(place);
        const QPointF finger = bench.session.view()->frame().from_surface(place);
        QTRY_VERIFY(bench.finger_is_at(finger));
        bench.session.hand()->touchDown(10.0, 10.0);
        bench.session.hand()->moveTo(12.0, 10.0);
        QTRY_VERIFY(bench.socket.force().x > 0.75); // 0.8 N at 4 mm, to the right, onto the line
        QVERIFY(std::abs(bench.socket.force().y) < 1e-9);
        QVERIFY(bench.finger_is_at(finger));
        bench.voice.clear();
        bench.session.finger()->whereAmI();
        QVERIFY(bench.voice.said().back().endsWith("Face outline at 3 o'clock, 4 millimetre(s)."));
    }

    void the_picture_lies_where_the_device_reaches() {
        Bench bench;
        bench.begin();
        const auto extent = [&] {
            Rect all{Vec2(1e9), Vec2(-1e9)};
            for (const Polyline& line : bench.session.view()->felt().lines) {
                const Rect one = bounds_of(line.points);
                all = {glm::min(all.min, one.min), glm::max(all.max, one.max)};
            }
            return all;
        };
        const Rect everywhere = extent();
        QVERIFY(everywhere.width() > 180.0 || everywhere.height() > 130.0);
        const QRectF drawn = bench.session.view()->photoRect();
        bench.socket.reach({60.0, 30.0});
        bench.socket.plug_in();
        QTRY_VERIFY(bench.with_device());
        QTRY_VERIFY(extent().height() < 53.0);
        QVERIFY(extent().min.x >= -56.0 && extent().max.x <= 56.0);
        QVERIFY(extent().width() > 111.0 || extent().height() > 51.0);
        QVERIFY(bench.session.view()->photoRect().height() < 0.5 * drawn.height());
        bench.session.zoom()->zoomIn();
        QVERIFY(extent().height() < 53.0 && extent().width() < 113.0);
        bench.session.zoom()->zoomOut();
        bench.socket.unplug();
        QTRY_VERIFY(!bench.with_device());
        QTRY_COMPARE(extent().width(), everywhere.width());
        QCOMPARE(bench.session.view()->photoRect(), drawn);
    }

    void never_more_than_the_persons_own_strongest_force() {
        Bench bench;
        bench.sounds.preferences.change([](Choices& choices) { choices.max_force_n = 0.3; });
        QVERIFY(bench.begins_with_device());
        bench.hold_at(bench.left_of_outline(4.0));
        QTRY_VERIFY(bench.socket.force().x > 0.299);
        QVERIFY(bench.socket.strongest() < 0.3 + 1e-9);
        bench.session.choices()->setMaxForce(0.5);
        QTRY_VERIFY(bench.socket.force().x > 0.499);
        QVERIFY(bench.socket.strongest() < 0.5 + 1e-9);
    }

    void escape_takes_the_force_and_return_gives_it_back() {
        Bench bench;
        QVERIFY(bench.begins_with_device());
        bench.hold_at(bench.left_of_outline(4.0));
        QTRY_VERIFY(bench.socket.force().x > 0.5);
        QVERIFY(bench.session.stop());
        QTRY_VERIFY(bench.socket.force() == Vec2(0.0));
        QVERIFY(bench.with_device());
        bench.session.device()->engage();
        QTRY_VERIFY(bench.socket.force().x > 0.5);
        QCOMPARE(bench.socket.opened(), 1);
    }

    void unplugged_in_mid_touch_it_is_said_and_the_page_goes_on() {
        Bench bench;
        QVERIFY(bench.begins_with_device());
        bench.hold_at(bench.left_of_outline(4.0));
        QTRY_VERIFY(bench.socket.force().x > 0.5);
        bench.sounds.hears(Earcon::ready);
        bench.voice.clear();
        bench.socket.unplug();
        QTRY_VERIFY(bench.said("it no longer answers. Check its cable"));
        QCOMPARE(bench.voice.last_priority(), Priority::fault);
        QVERIFY(bench.socket.force() == Vec2(0.0));
        QTRY_VERIFY(!bench.with_device());
        QVERIFY(!bench.session.device()->engaged());
        QTRY_VERIFY(!bench.socket.in_use());
        // Without it: sound and a drawn finger.
        const QPointF beside = bench.session.view()->frame().from_surface(bench.left_of_outline(12.0));
        bench.session.hand()->fingerDown(0, beside.x(), beside.y());
        bench.session.finger()->whereAmI();
        QVERIFY(bench.said("Face outline at 3 o'clock, 12 millimetre(s)."));
        bench.session.hand()->fingerUp(0);
        // It is found again, and gives nothing before the person wants it.
        bench.voice.clear();
        bench.socket.plug_in();
        QTRY_VERIFY(bench.with_device());
        QTRY_VERIFY(bench.said("Its force is off. Press Enter to switch it on."));
        QVERIFY(!bench.session.device()->engaged());
        QTest::qWait(50);
        QVERIFY(bench.socket.force() == Vec2(0.0));
        bench.session.device()->engage();
        QTRY_VERIFY(bench.socket.force().x > 0.5);
        QCOMPARE(bench.socket.opened(), 2);
        // A second time is said as the first was.
        bench.voice.clear();
        bench.socket.unplug();
        QTRY_VERIFY(bench.said("it no longer answers. Check its cable"));
    }

    void plugged_in_later_it_waits_for_the_person_though_the_drawn_force_is_on() {
        Bench bench;
        bench.begin();
        QVERIFY(bench.session.device()->engaged());
        QTRY_VERIFY(bench.socket.looks() > 1); // the first has found nothing
        bench.socket.plug_in();
        QTRY_VERIFY(bench.with_device());
        QVERIFY(!bench.session.device()->engaged());
        QVERIFY(bench.said("Its force is off. Press Enter"));
        QCOMPARE(bench.socket.strongest(), 0.0);
    }

    void one_that_cannot_be_opened_is_told_once_and_asked_again_by_return() {
        Bench bench;
        bench.socket.refuse("Another program uses the force pad. Close that program and try again.");
        bench.socket.plug_in();
        bench.begin();
        QTRY_VERIFY(bench.said("Close that program and try again. Until then the force is only drawn."));
        QVERIFY(bench.session.device()->engaged());
        QTest::qWait(50);
        QCOMPARE(bench.socket.tried(), 1);
        bench.socket.refuse({});
        bench.session.device()->engage();
        QTRY_VERIFY(bench.with_device());
        QVERIFY(bench.session.device()->engaged());
    }

    void one_that_was_refused_is_tried_again_when_it_is_plugged_in_again() {
        Bench bench;
        bench.socket.refuse("The force pad could not be opened. Unplug it, plug it in again and try once more.");
        bench.socket.plug_in();
        bench.begin();
        QTRY_COMPARE(bench.socket.tried(), 1);
        QTRY_VERIFY(bench.said("plug it in again"));
        bench.socket.unplug();
        bench.socket.refuse({});
        const int looks = bench.socket.looks();
        QTRY_VERIFY(bench.socket.looks() > looks + 2); // one of them has found nothing
        bench.socket.plug_in();
        QTRY_VERIFY(bench.with_device());
        QVERIFY(!bench.session.device()->engaged());
    }

    void out_of_sight_it_is_given_back_and_taken_again() {
        Bench bench;
        QVERIFY(bench.begins_with_device());
        bench.hold_at(bench.left_of_outline(4.0));
        QTRY_VERIFY(bench.socket.force().x > 0.5);
        bench.session.leave();
        QTRY_VERIFY(!bench.socket.in_use());
        QVERIFY(bench.socket.force() == Vec2(0.0));
        QTest::qWait(30);
        QVERIFY(!bench.socket.in_use());
        bench.session.enter();
        QTRY_VERIFY(bench.with_device());
        QVERIFY(bench.session.device()->engaged());
        bench.session.stop();
        bench.session.leave();
        bench.session.enter(); // who switched the force off finds it off
        QTRY_VERIFY(bench.with_device());
        QVERIFY(!bench.session.device()->engaged());
    }

    void who_wants_no_device_gets_none_and_a_page_without_a_photograph_opens_none() {
        Bench bench;
        bench.socket.plug_in();
        bench.session.enter();
        QTest::qWait(50);
        QCOMPARE(bench.socket.tried(), 0);
        bench.sounds.preferences.change([](Choices& choices) { choices.device = no_device_key; });
        bench.session.show(drawn_photo());
        QTest::qWait(50);
        QCOMPARE(bench.socket.tried(), 0);
        QVERIFY(bench.session.device()->engaged());
    }

    void the_motors_own_reason_is_told() {
        Bench bench;
        QVERIFY(bench.begins_with_device());
        bench.socket.switch_motors_off("The force pad's motors are too hot. It goes on by itself when they have cooled.");
        QTRY_VERIFY(bench.said("motors are too hot"));
        QVERIFY(bench.session.device()->faultSentence().contains("too hot"));
        bench.socket.switch_motors_off({});
        QTRY_VERIFY(bench.session.device()->faultSentence().isEmpty());
        QTRY_VERIFY(bench.said("The device is ready. Its force is on."));
    }

    void a_handle_to_be_homed_is_asked_for_again_and_its_force_comes_when_it_is() {
        double time = 100.0;
        Bench bench(false, &time);
        bench.socket.plug_in();
        bench.socket.switch_motors_off("Home it.");
        bench.begin();
        QTRY_VERIFY(bench.with_device());
        bench.hold_at(bench.left_of_outline(2.0));
        bench.session.device()->engage();
        const auto asked = [&] { return bench.voice.said().filter("Home it.").size(); };
        const auto wait_until = [&](auto holds) { // the session's clock runs on meanwhile
            return QTest::qWaitFor([&] { return time += 0.1, holds(); }, 60000);
        };
        QVERIFY(wait_until([&] { return asked() == 1; }));
        const double first = time;
        QVERIFY(wait_until([&] { return asked() == 2; }));
        QVERIFY(time - first >= FaultWatch::remind_s);
        QCOMPARE(bench.socket.strongest(), 0.0);
        bench.socket.switch_motors_off({});
        QVERIFY(wait_until([&] { return bench.said("The device is ready. Its force is on."); }));
        QTRY_VERIFY_WITH_TIMEOUT(length(bench.socket.force()) > 0.1, 60000);
    }

    void keys_that_would_move_the_finger_tell_the_way_instead() {
        Bench bench;
        QVERIFY(bench.begins_with_device());
        const Vec2 above = bench.session.view()->felt().lines[left_eye].points[0] + Vec2(0.0, 9.0);
        bench.hold_at(above);
        const QPointF finger = bench.session.view()->frame().from_surface(above);
        QTRY_VERIFY(bench.finger_is_at(finger));
        bench.session.hand()->goToFeature(left_eye);
        QCOMPARE(bench.voice.said().back(), QString("Left eye: 6 o'clock, 9 millimetre(s)."));
        bench.session.hand()->nudge(2.0, 0.0);
        QCOMPARE(bench.voice.said().back(), QString("Move the finger with the device."));
        QTest::qWait(30);
        QVERIFY(bench.finger_is_at(finger));
    }

    void beside_its_force_the_guide_is_quieter_and_silent_in_its_reach() {
        Bench drawn;
        drawn.begin();
        const QPointF far = drawn.session.view()->frame().from_surface(drawn.left_of_outline(15.0));
        drawn.session.hand()->fingerDown(0, far.x(), far.y());
        const double loud = drawn.sounds.guide_peak(1.0);
        Bench felt;
        felt.socket.plug_in();
        felt.begin();
        QTRY_VERIFY(felt.with_device());
        felt.hold_at(felt.left_of_outline(15.0));
        QTRY_VERIFY(felt.sounds.guide.sounds());
        const double soft = felt.sounds.guide_peak(1.0);
        QVERIFY2(soft > 0.0 && soft < 0.5 * loud, qPrintable(QString("%1, %2").arg(soft).arg(loud)));
        felt.hold_at(felt.left_of_outline(3.0));
        QTRY_VERIFY(!felt.sounds.guide.sounds());
    }

    void a_calibrated_one_is_felt_where_the_picture_lies_on_the_screen() {
        Bench bench(true);
        // It lies turned by a quarter on the screen, and the picture is drawn there at 0.8 of its millimetres.
        const Calibration calibration{{glm::dmat2(0.0, 1.0, -1.0, 0.0), {150.0, -100.0}}, 0.4, 60};
        QCOMPARE(keep_calibration(bench.calibrations(), DeviceSocket::serial_number, calibration), std::string());
        bench.session.device()->sheetLies(20.0, 10.0, 0.8);
        QVERIFY(bench.begins_with_device());
        const Vec2 place = bench.left_of_outline(4.0);
        // Surface → millimetres on the screen, y up → device.
        const Vec2 on_screen = Vec2(20.0, -10.0) + 0.8 * (place + Vec2(100.0, -75.0));
        const Vec2 off = on_screen - calibration.device_to_surface.offset;
        bench.socket.hold_at({off.y, -off.x});
        const QPointF finger = bench.session.view()->frame().from_surface(place);
        QTRY_VERIFY(bench.finger_is_at(finger));
        // 0.8 N to the right on the surface, whose millimetre is 0.8 of the device's: 1 N does the same work there.
        QTRY_VERIFY(bench.socket.force().y < -0.99);
        QVERIFY(std::abs(bench.socket.force().x) < 1e-9);
        QVERIFY(bench.socket.strongest() < 1.0 + 1e-9);
        QTRY_VERIFY(std::abs(bench.session.finger()->force().x() - 0.8) < 0.01);
        // The window is moved by 5 mm to the right: what lies under the handle lies 6.25 mm further left on the sheet.
        bench.session.device()->sheetLies(25.0, 10.0, 0.8);
        QTRY_VERIFY(std::abs(bench.session.finger()->place().x() - (finger.x() - 6.25)) < 1e-6);
        QVERIFY(std::abs(bench.session.finger()->place().y() - finger.y()) < 1e-6);
        QVERIFY(bench.session.device()->engaged());
        QCOMPARE(bench.socket.opened(), 2);
    }

    void a_picture_too_small_on_the_screen_is_felt_in_its_true_size() {
        Bench bench(true);
        QCOMPARE(keep_calibration(bench.calibrations(), DeviceSocket::serial_number, {{}, 0.4, 60}), std::string());
        bench.session.device()->sheetLies(20.0, 10.0, 0.6);
        QVERIFY(bench.begins_with_device());
        QTRY_VERIFY(bench.said("too small or too large on the screen"));
        bench.hold_at({7.0, 3.0});
        const QPointF finger = bench.session.view()->frame().from_surface(Vec2(7.0, 3.0));
        QTRY_VERIFY(bench.finger_is_at(finger));
    }

    void it_leads_the_finger_round_a_feature() {
        Bench bench;
        QVERIFY(bench.begins_with_device());
        const Vec2 start = bench.session.view()->felt().lines[left_eye].points[0];
        bench.hold_at(start);
        QTRY_COMPARE(bench.session.finger()->featureName(), QString("left eye"));
        bench.session.tour()->toggle();
        bench.session.hand()->moveTo(5.0, 5.0); // neither mouse nor screen ends it
        bench.session.hand()->moveTo(90.0, 90.0);
        QVERIFY(bench.session.tour()->touring());
        QTRY_VERIFY(length(bench.socket.force()) > 0.05);
        QVERIFY(bench.session.stop());
        QTRY_VERIFY(bench.socket.force() == Vec2(0.0));
    }
};

} // namespace explore_device_test

TP_TEST(explore_device_test, ExploreDeviceTest, event_loop)
#include "explore_device_test.moc"
