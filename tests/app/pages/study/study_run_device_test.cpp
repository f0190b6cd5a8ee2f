// SPDX-License-Identifier: Apache-2.0
// A sitting with a force device, by itself: it brings the finger to the start, and goes with its force at every way out.
#include "device_socket.hpp"
#include "study_parts.hpp"
#include "test_program.hpp"

#include <QDir>

namespace study_run_device_test {

using namespace tp;
using tp::testing::DeviceSocket;
using State = StudyRun::State;

namespace {

/// On a surface that the device reaches; its middle is the device's (0, 100).
constexpr const char* small_shapes =
    "experiment: small\ntask: name\nfactor shape: circle, square\nset radius: 40 mm\n"
    "set stiffness: 0.5 N/mm\nset range: 10 mm\nanswer: shape\nsurface: 160 x 120 mm\n";

struct DeviceBench {
    DeviceSocket socket;
    StudyParts bench{socket.access()};
    Vec2 handle{0.0}; ///< surface, mm

    void hold(Vec2 place) {
        handle = place;
        socket.hold_at(place + Vec2(0.0, 100.0));
    }
    void begin(const char* text) {
        hold({-50.0, -40.0});
        socket.plug_in();
        bench.device = true;
        bench.finger.look(true);
        QTRY_VERIFY_WITH_TIMEOUT(found(), 60000);
        bench.begin(text);
    }
    bool found() const { return !bench.finger.found().isEmpty(); }
    /// The hand gives way to the force, for at most so long.
    void be_led(double seconds) {
        for (double t = 0.0; t < seconds && bench.run().state() == State::Coming; t += 0.005) {
            hold(handle + 0.6 * socket.force());
            bench.pass(0.005);
        }
    }
};

} // namespace

class StudyRunDeviceTest : public QObject {
    Q_OBJECT
private slots:
    void the_device_brings_the_finger_to_the_start_and_then_rests() {
        DeviceBench with;
        with.begin(small_shapes);
        QCOMPARE(with.bench.run().state(), State::Coming);
        QVERIFY2(with.bench.said().contains("brings your finger to the start"),
                 qPrintable(with.bench.said()));
        with.bench.run().goOn(); // too early
        QCOMPARE(with.bench.run().state(), State::Coming);
        with.be_led(20.0);
        QCOMPARE(with.bench.run().state(), State::Ready);
        QVERIFY(length(with.handle - with.bench.now().start) < 5.0);
        with.bench.pass(0.5);
        QVERIFY(with.socket.force() == Vec2(0.0));
    }

    void the_line_is_felt_with_the_handle_and_without_a_tone() {
        DeviceBench with;
        with.begin(small_shapes);
        with.be_led(20.0);
        const StudyTrial trial = with.bench.now();
        with.bench.run().goOn();
        QCOMPARE(with.bench.run().state(), State::Feeling);
        const Vec2 beside = with.bench.finger.felt().lines[0].points[0] * 0.85;
        with.hold(beside);
        with.bench.pass(1.0);
        QVERIFY(length(with.socket.force()) > 0.3);
        QVERIFY(!with.bench.guide.sounds());
        with.bench.run().goOn();
        with.bench.pass(0.03);                     // a ramp of 20 ms
        QVERIFY(with.socket.force() == Vec2(0.0)); // while one thinks
        with.bench.run().answer(0);
        with.bench.settle();
        QCOMPARE(with.bench.records().size(), std::size_t(1));
        const auto study = read_study(with.bench.study_folder());
        QVERIFY(study && study->sittings.size() == 1);
        QVERIFY(study->sittings[0].machine.device.starts_with("force pad, TPC-0042, at most 1.00 N"));
        QVERIFY(!study->sittings[0].machine.calibration.empty());
    }

    void a_pause_while_the_device_leads_takes_its_force() {
        DeviceBench with;
        with.begin(small_shapes);
        with.bench.pass(0.3);
        QVERIFY(length(with.socket.force()) > 0.1);
        with.bench.run().pause();
        QCOMPARE(with.bench.run().state(), State::Paused);
        with.bench.pass(0.03); // a ramp of 20 ms
        QVERIFY(with.socket.force() == Vec2(0.0));
        with.bench.pass(2.0);
        QVERIFY(with.socket.force() == Vec2(0.0));
        QCOMPARE(with.bench.records().size(), std::size_t(0));
        with.bench.run().goOn();
        QCOMPARE(with.bench.run().state(), State::Coming);
    }

    void motors_that_switch_off_pause_with_the_device_s_own_words() {
        DeviceBench with;
        with.begin(small_shapes);
        with.be_led(20.0);
        with.bench.run().goOn();
        with.bench.pass(0.5);
        with.socket.switch_motors_off("The force pad is too hot. Let it cool down.");
        with.bench.pass(1.0);
        with.bench.settle();
        QCOMPARE(with.bench.run().state(), State::Paused);
        QVERIFY2(with.bench.said().startsWith("The force pad is too hot."), qPrintable(with.bench.said()));
        QVERIFY(with.bench.finger.here()); // it may be used again
    }

    void a_finger_that_has_gone_away_is_brought_again() {
        DeviceBench with;
        with.begin(small_shapes);
        with.be_led(20.0);
        with.hold(with.bench.now().start + Vec2(30.0, 0.0));
        with.bench.pass(0.1);
        with.bench.run().goOn();
        QCOMPARE(with.bench.run().state(), State::Coming);
        with.be_led(20.0);
        QCOMPARE(with.bench.run().state(), State::Ready);
        with.bench.run().goOn();
        QCOMPARE(with.bench.run().state(), State::Feeling);
    }

    void one_pulled_out_before_the_trial_begins_pauses_at_once() {
        for (const State state : {State::Coming, State::Ready}) {
            DeviceBench with;
            with.begin(small_shapes);
            if (state == State::Ready)
                with.be_led(20.0);
            QCOMPARE(with.bench.run().state(), state);
            QVERIFY(!with.bench.sounded(Earcon::fault));
            with.socket.unplug();
            with.bench.pass(0.5);
            QCOMPARE(with.bench.run().state(), State::Paused);
            QVERIFY2(with.bench.said().endsWith(" Paused. Press Space to go on."),
                     qPrintable(with.bench.said()));
            QVERIFY(with.bench.sounded(Earcon::fault));
            QVERIFY(!with.bench.finger.here()); // it is opened again, or said to be missing
            QVERIFY(with.bench.records().empty());
        }
    }

    void escape_while_it_leads_asks_without_force() {
        DeviceBench with;
        with.begin(small_shapes);
        with.bench.pass(0.3);
        QVERIFY(length(with.socket.force()) > 0.1);
        QVERIFY(with.bench.run().stop());
        QCOMPARE(with.bench.run().state(), State::Stopping);
        with.bench.pass(0.03); // a ramp of 20 ms
        QVERIFY(with.socket.force() == Vec2(0.0));
        QVERIFY(with.bench.run().stop());
        QTRY_VERIFY_WITH_TIMEOUT(!with.socket.in_use(), 60000);
    }

    void a_device_pulled_out_pauses_and_is_opened_again() {
        DeviceBench with;
        with.begin(small_shapes);
        with.be_led(20.0);
        with.bench.run().goOn();
        with.bench.pass(0.5);
        with.socket.unplug();
        with.bench.pass(1.0);
        with.bench.settle();
        QCOMPARE(with.bench.run().state(), State::Paused);
        QVERIFY2(with.bench.said().contains("Press Space to go on."), qPrintable(with.bench.said()));
        QCOMPARE(with.bench.records().size(), std::size_t(1));
        QVERIFY(with.bench.records()[0].repeated);
        QTRY_VERIFY_WITH_TIMEOUT(!with.found(), 60000);
        with.bench.run().goOn();
        QCOMPARE(with.bench.run().state(), State::Paused); // never by the mouse instead
        QVERIFY2(with.bench.said().startsWith("The force device is not there. Connect it."),
                 qPrintable(with.bench.said()));
        with.socket.plug_in();
        QTRY_VERIFY_WITH_TIMEOUT(with.found(), 60000);
        with.bench.run().goOn();
        QTRY_COMPARE_WITH_TIMEOUT(with.bench.run().state(), State::Coming, 60000);
    }

    void the_page_gives_the_device_back_when_it_is_left() {
        DeviceBench with;
        with.begin(small_shapes);
        with.be_led(20.0);
        with.bench.run().goOn();
        with.bench.pass(0.2);
        QVERIFY(with.socket.in_use());
        with.bench.run().leave();
        QTRY_VERIFY_WITH_TIMEOUT(!with.socket.in_use(), 60000);
        QVERIFY(with.socket.force() == Vec2(0.0));
    }

    void a_device_that_refuses_is_said_and_nothing_is_written() {
        DeviceBench with;
        with.socket.refuse("The force pad does not answer. Plug it in again.");
        with.begin(small_shapes);
        QCOMPARE(with.bench.run().state(), State::SetUp);
        QVERIFY2(with.bench.has_said("The force pad does not answer."), qPrintable(with.bench.said()));
        QVERIFY(!QDir(with.bench.documents()).exists());
    }
};

} // namespace study_run_device_test

TP_TEST(study_run_device_test, StudyRunDeviceTest, event_loop)
#include "study_run_device_test.moc"
