// SPDX-License-Identifier: Apache-2.0
#include "device/calibration_file.hpp"
#include "device/hid_pid/joystick_scale_file.hpp"
#include "settings_bench.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>

namespace device_settings_test {

using namespace tp;
using tp::testing::DeviceSocket;

namespace {

struct Bench : SettingsBench {
    DeviceSettings& devices() { return *session.devices(); }
    Bench() {
        socket.hold_at({0.0, 100.0});
        session.enter();
        voice.clear();
    }
    bool has_device() { return devices().there(); }

    /// Touches a place of the screen (mm, y down) with the device, which lies turned by a quarter on it.
    void touch(double x, double y, Vec2 slip = Vec2(0.0)) {
        const Vec2 off = Vec2(x, -y) - Vec2(130.0, -80.0) + slip;
        socket.hold_at({off.y, 100.0 - off.x});
        QTest::qWait(20);
        devices().touched(x, y);
    }
    /// Until a mark was reached, or for so many polls.
    void hold(int polls = 100) {
        const int mark = devices().mark();
        for (int i = 0; i < polls && devices().calibrating() && devices().mark() == mark; ++i) {
            time += 0.06;
            QTest::qWait(17);
        }
        devices().lifted();
    }
};

constexpr double left = 70.0, right = 190.0, top = 30.0, bottom = 130.0;

} // namespace

class DeviceSettingsTest : public QObject {
    Q_OBJECT
private slots:
    void devices_are_listed_with_how_they_are_reached_and_come_and_go() {
        Bench bench;
        QCOMPARE(bench.devices().names(), QStringList("None: sound, and a drawn finger"));
        QCOMPARE(bench.devices().current(), 0);
        bench.socket.plug_in();
        QTRY_VERIFY(bench.has_device());
        QCOMPARE(bench.devices().names(),
                 QStringList({"None: sound, and a drawn finger", "force pad TPC-0042, over USB (HID)"}));
        QCOMPARE(bench.devices().current(), 1); // the first one found
        QVERIFY(bench.devices().calibration().startsWith("Not calibrated."));
        bench.session.feeling()->chooseDevice(0);
        QCOMPARE(bench.now().device, QString(no_device_key));
        QCOMPARE(bench.voice.said().back(), QString("Force device: None: sound, and a drawn finger."));
        QVERIFY(!bench.has_device());
        bench.session.steps()->undo();
        QCOMPARE(bench.now().device, QString());
        bench.session.feeling()->chooseDevice(1);
        QCOMPARE(bench.now().device, QString(DeviceSocket::serial_number));
        bench.socket.unplug();
        QTRY_VERIFY(!bench.has_device());
        QCOMPARE(bench.devices().names().back(), QString("TPC-0042, not plugged in"));
        bench.session.feeling()->chooseDevice(7);
        bench.session.feeling()->chooseDevice(-1);
        QCOMPARE(bench.now().device, QString(DeviceSocket::serial_number));
        bench.session.leave();
        bench.socket.plug_in();
        QTest::qWait(50);
        QVERIFY(!bench.has_device()); // nobody looks behind the page
    }

    void the_strongest_force_is_felt_to_the_right_and_to_the_left() {
        Bench bench;
        bench.session.feeling()->setMaxForce(0.6);
        bench.socket.plug_in();
        QTRY_VERIFY(bench.has_device());
        bench.devices().tryForce();
        QTRY_VERIFY(bench.said("The strongest force, 0.6 newtons"));
        QTRY_VERIFY(bench.socket.force().x > 0.59);
        bench.time += DeviceSettings::pull_s;
        QTRY_VERIFY(bench.socket.force().x < -0.59);
        QVERIFY(std::abs(bench.socket.force().y) < 1e-9);
        bench.time += DeviceSettings::pull_s;
        QTRY_VERIFY(bench.said("That was the strongest force."));
        QTRY_VERIFY(!bench.socket.in_use());
        QVERIFY(bench.socket.force() == Vec2(0.0));
        QVERIFY(bench.socket.strongest() < 0.6 + 1e-9);
    }

    void a_device_is_homed_and_given_back() {
        Bench bench;
        bench.devices().home();
        QCOMPARE(bench.voice.said().back(),
                 QString("No force device is plugged in. Plug one in; it is found automatically."));
        bench.socket.plug_in();
        QTRY_VERIFY(bench.has_device());
        bench.devices().home();
        QTRY_VERIFY(bench.said("The device is homed: it knows where its handle is."));
        QVERIFY(bench.socket.homed() && !bench.socket.in_use());
        QVERIFY(bench.socket.strongest() == 0.0);
        bench.voice.clear();
        QTRY_VERIFY(bench.has_device());
        bench.socket.unplug(); // since the last look
        bench.devices().home();
        QTRY_VERIFY(!bench.voice.said().isEmpty());
        QTRY_VERIFY(bench.said("could not be homed") || bench.said("No force device is plugged in."));
        bench.voice.clear();
        bench.socket.plug_in();
        QTRY_VERIFY(bench.has_device());
        bench.socket.refuse("Another program uses the force pad.");
        bench.devices().home();
        QTRY_VERIFY(bench.said("Another program uses the force pad."));
    }

    void a_joystick_is_measured_with_a_scale_and_kept() {
        Bench bench;
        bench.socket.be_a_joystick(8.0, {1.0, -1.0});
        bench.socket.plug_in();
        QTRY_VERIFY(bench.devices().measurable());
        bench.devices().measure();
        QTRY_VERIFY(bench.said("Let it stand free, and keep your hands off it. Escape ends it."));
        bench.wait_in_time([&] { return bench.devices().weighing(); });
        QVERIFY(bench.devices().weighing());
        QVERIFY(bench.said("enter how many grams the scale shows."));
        bench.socket.hold();
        bench.devices().weighed("much");
        QVERIFY(bench.said("must be a number of grams"));
        for (int i = 0; i < 8 && bench.devices().weighing(); ++i) {
            bench.wait_in_time([] { return false; }, 1.0);
            bench.devices().weighed(QString::number(1e3 * bench.socket.force().y / 9.80665, 'f', 1));
        }
        QVERIFY(!bench.devices().measuring());
        QVERIFY2(bench.said("The stick is measured: 8.0 newtons at most."), qPrintable(bench.voice.said().join('\n')));
        const JoystickScale kept = kept_joystick_scale(bench.joystick_scales(), DeviceSocket::serial_number);
        QVERIFY(kept.measured && kept.sign == Vec2(1.0, -1.0));
        QVERIFY(std::abs(kept.newtons_at_full - 8.0) < 0.1);
        QTRY_VERIFY(!bench.socket.in_use());
        QVERIFY(bench.socket.force() == Vec2(0.0));
    }

    void a_measurement_that_is_ended_or_fails_changes_nothing() {
        Bench bench;
        bench.socket.be_a_joystick(8.0, {1.0, 1.0});
        bench.socket.plug_in();
        QTRY_VERIFY(bench.devices().measurable());
        bench.devices().measure();
        bench.wait_in_time([&] { return bench.devices().weighing(); });
        QVERIFY(bench.session.back());
        QCOMPARE(bench.voice.said().back(),
                 QString("Measurement cancelled. The force is off. Nothing was changed."));
        QTRY_VERIFY(!bench.socket.in_use());
        bench.socket.hold();
        QTRY_VERIFY(bench.devices().measurable());
        bench.devices().measure();
        bench.wait_in_time([&] { return !bench.voice.said().isEmpty() && bench.said("The stick did not move."); }, 30.0);
        QVERIFY(bench.said("The stick did not move."));
        QVERIFY(!bench.devices().measuring());
        QVERIFY(!std::filesystem::exists(bench.joystick_scales()));
        QTRY_VERIFY(!bench.socket.in_use());
    }

    void only_a_joystick_is_measured() {
        Bench bench;
        bench.socket.plug_in();
        QTRY_VERIFY(bench.has_device());
        QVERIFY(!bench.devices().measurable());
        bench.devices().measure();
        QVERIFY(bench.said("only force sticks need measuring"));
        QVERIFY(bench.socket.opened() == 0);
    }

    void escape_ends_it() {
        Bench bench;
        bench.socket.plug_in();
        QTRY_VERIFY(bench.has_device());
        bench.devices().tryForce();
        QTRY_VERIFY(bench.socket.force().x > 0.3);
        QVERIFY(bench.session.back());
        QCOMPARE(bench.voice.said().back(), QString("Stopped. The force is off."));
        QTRY_VERIFY(!bench.socket.in_use());
        QVERIFY(bench.socket.force() == Vec2(0.0));
        QVERIFY(!bench.session.back());
        bench.devices().tryForce(); // while it is opened, before anything is pulled
        QVERIFY(bench.session.back());
        QTest::qWait(50);
        QVERIFY(!bench.socket.in_use());
    }

    void nothing_is_pulled_while_it_is_announced_and_who_ends_it_then_feels_nothing() {
        Bench bench;
        bench.socket.plug_in();
        QTRY_VERIFY(bench.has_device());
        bench.voice.set_busy(true);
        bench.devices().tryForce();
        QTRY_VERIFY(bench.said("The strongest force"));
        bench.time += 2.0 * DeviceSettings::pull_s;
        QTest::qWait(60);
        QVERIFY(bench.socket.in_use());
        QCOMPARE(bench.socket.strongest(), 0.0);
        bench.session.leave(); // the sentence goes on
        bench.voice.set_busy(false);
        QTest::qWait(60);
        QTRY_VERIFY(!bench.socket.in_use());
        QCOMPARE(bench.socket.strongest(), 0.0);
    }

    void a_joystick_stays_still_while_its_measuring_is_announced() {
        Bench bench;
        bench.socket.be_a_joystick(8.0, {1.0, 1.0});
        bench.socket.plug_in();
        QTRY_VERIFY(bench.devices().measurable());
        bench.voice.set_busy(true);
        bench.devices().measure();
        QTRY_VERIFY(bench.devices().measuring());
        bench.wait_in_time([] { return false; }, 2.0);
        QCOMPARE(bench.socket.strongest(), 0.0);
        QVERIFY(bench.session.back());
        QCOMPARE(bench.voice.said().back(),
                 QString("Measurement cancelled. The force is off. Nothing was changed."));
        bench.voice.set_busy(false);
        QTest::qWait(60);
        QTRY_VERIFY(!bench.socket.in_use());
        QCOMPARE(bench.socket.strongest(), 0.0);
    }

    void the_page_that_is_left_leaves_no_force() {
        Bench bench;
        bench.socket.plug_in();
        QTRY_VERIFY(bench.has_device());
        bench.devices().tryForce();
        QTRY_VERIFY(bench.socket.force().x > 0.3);
        bench.voice.clear();
        bench.session.leave();
        QTRY_VERIFY(!bench.socket.in_use());
        QVERIFY(bench.socket.force() == Vec2(0.0));
        QCOMPARE(bench.voice.said(), QStringList());
    }

    void unplugged_or_refused_it_is_told() {
        Bench bench;
        bench.devices().tryForce();
        QCOMPARE(bench.voice.said().back(),
                 QString("No force device is plugged in. Plug one in; it is found automatically."));
        bench.socket.plug_in();
        QTRY_VERIFY(bench.has_device());
        bench.devices().tryForce();
        QTRY_VERIFY(bench.socket.force().x > 0.3);
        bench.socket.unplug();
        QTRY_VERIFY(bench.said("it no longer answers"));
        QTRY_VERIFY(!bench.socket.in_use());
        bench.socket.refuse("Another program uses the force pad. Close that program and try again.");
        bench.socket.plug_in();
        QTRY_VERIFY(bench.has_device());
        bench.devices().tryForce();
        QTRY_VERIFY(bench.said("Close that program"));
        bench.session.feeling()->chooseDevice(0);
        bench.devices().calibrate();
        QCOMPARE(bench.voice.said().back(), QString("No force device is chosen. Choose one above."));
    }

    void motors_that_stay_off_tell_why() {
        Bench bench;
        bench.socket.switch_motors_off("The force pad's motors are too hot. It goes on by itself when they have cooled.");
        bench.socket.plug_in();
        QTRY_VERIFY(bench.has_device());
        bench.devices().tryForce();
        QTRY_VERIFY(bench.said("The strongest force"));
        QTest::qWait(50);
        bench.time += 0.6;
        QTRY_VERIFY(bench.said("motors are too hot"));
        QCOMPARE(bench.socket.strongest(), 0.0);
    }

    void a_person_is_led_round_the_corners_and_the_map_is_kept() {
        Bench bench;
        bench.socket.plug_in();
        QTRY_VERIFY(bench.has_device());
        bench.devices().calibrate();
        QTRY_VERIFY(bench.devices().calibrating());
        QVERIFY(bench.said("Calibration. The device lies on the screen"));
        bench.devices().areaLies(50.0, 10.0, 160.0, 140.0);
        bench.touch(left, top);
        bench.hold();
        QCOMPARE(bench.voice.said().back(), QString("Now the top right corner."));
        bench.touch(left, top); // again the same: it waits
        bench.hold(20);
        QCOMPARE(bench.devices().mark(), int(CalibrationSteps::top_right));
        bench.touch(right, top);
        bench.hold();
        bench.touch(right, bottom);
        bench.hold();
        QCOMPARE(bench.voice.said().back(), QString("Now the bottom left corner."));
        bench.touch(left, bottom);
        bench.hold();
        QVERIFY(!bench.devices().calibrating());
        QCOMPARE(
            bench.voice.said().back(),
            QString("Calibrated. It misses by 0.0 millimetres on average, and is saved for this device."));
        QCOMPARE(bench.socket.strongest(), 0.0);
        QTRY_VERIFY(!bench.socket.in_use());
        const auto kept = kept_calibration(bench.calibrations(), DeviceSocket::serial_number);
        QVERIFY(kept.has_value());
        QVERIFY(length(kept->device_to_surface({10.0, 20.0}) - Vec2(210.0, -70.0)) < 1e-6);
        QTRY_COMPARE(bench.devices().calibration(), QString("Calibrated: misses by 0.0 millimetres on average."));
    }

    void a_device_that_slips_is_refused_with_what_to_do() {
        Bench bench;
        bench.socket.plug_in();
        QTRY_VERIFY(bench.has_device());
        bench.devices().calibrate();
        QTRY_VERIFY(bench.devices().calibrating());
        bench.devices().areaLies(50.0, 10.0, 160.0, 140.0);
        const Vec2 slip(8.0, 0.0);
        bench.touch(left, top);
        bench.hold();
        bench.touch(right, top);
        bench.hold();
        bench.touch(right, bottom, slip);
        bench.hold();
        bench.touch(left, bottom);
        bench.hold();
        QVERIFY(!bench.devices().calibrating());
        QVERIFY2(bench.voice.said().back().endsWith("Nothing was changed."), qPrintable(bench.voice.said().back()));
        QVERIFY(!kept_calibration(bench.calibrations(), DeviceSocket::serial_number).has_value());
    }

    void escape_ends_the_calibration_and_changes_nothing() {
        Bench bench;
        bench.socket.plug_in();
        QTRY_VERIFY(bench.has_device());
        bench.devices().calibrate();
        QTRY_VERIFY(bench.devices().calibrating());
        bench.devices().areaLies(50.0, 10.0, 160.0, 140.0);
        bench.touch(left, top);
        bench.hold();
        QVERIFY(bench.session.back());
        QCOMPARE(bench.voice.said().back(), QString("Calibration cancelled. Nothing was changed."));
        QTRY_VERIFY(!bench.socket.in_use());
        QVERIFY(!std::filesystem::exists(bench.calibrations()));
    }
};

} // namespace device_settings_test

TP_TEST(device_settings_test, DeviceSettingsTest, event_loop)
#include "device_settings_test.moc"
