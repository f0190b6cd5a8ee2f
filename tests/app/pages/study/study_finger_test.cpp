// SPDX-License-Identifier: Apache-2.0
// The participant's finger by itself: drawn or a device's, led, felt, without force, given back.
#include "app/pages/study/study_finger.hpp"
#include "core/geometry/contour.hpp"
#include "core/guidance/haptic_scene.hpp"
#include "core/guidance/scene.hpp"
#include "device_socket.hpp"
#include "test_program.hpp"

#include <QSignalSpy>
#include <QTest>

#include <cmath>
#include <utility>

namespace study_finger_test {

using namespace tp;

namespace {

const Vec2 surface{160.0, 120.0}; ///< mm; the device's middle is its (0, 100)

/// A line along x through the middle.
Scene line() { return {surface.x, surface.y, {contour_through("line", {{-60.0, 0.0}, {60.0, 0.0}}, false)}}; }

struct Bench {
    testing::DeviceSocket socket;
    VirtualClock time;
    Preferences preferences;
    StudySettings settings = in(time);
    StudyFinger finger{settings, preferences};
    QSignalSpy taken{&finger, &StudyFinger::taken};
    QSignalSpy refused{&finger, &StudyFinger::refused};
    QSignalSpy troubled{&finger, &StudyFinger::troubled};
    double now = 100.0;

    StudySettings in(VirtualClock& clock) const {
        StudySettings settings;
        settings.devices = socket.access();
        settings.time = &clock;
        return settings;
    }
    QString last_refusal() const { return refused.isEmpty() ? QString() : refused.last().at(0).toString(); }
    std::string lay() {
        return finger.lay([] { return make_haptic_scene(line()); });
    }
    void pass(double seconds) {
        for (double left = seconds; left > 0.0025; left -= 0.005) {
            finger.pass(0.005);
            finger.watch(now += 0.005);
        }
    }
    double felt() const { return length(finger.seen().force()); }
    void find_device() {
        hold({0.0, 0.0});
        socket.plug_in();
        finger.look(true);
        QTRY_VERIFY_WITH_TIMEOUT(!finger.found().isEmpty(), 60000);
    }
    void take_device() {
        find_device();
        finger.take({surface, true});
        QTRY_COMPARE_WITH_TIMEOUT(taken.size(), 1, 60000);
        lay();
    }
    /// Its handle is there, mm of the surface.
    void hold(Vec2 place) { socket.hold_at(place + Vec2(0.0, 100.0)); }
};

} // namespace

class StudyFingerTest : public QObject {
    Q_OBJECT
private slots:
    void the_drawn_one_is_taken_at_once_and_set_down_where_a_trial_begins() {
        Bench bench;
        QVERIFY(!bench.finger.here());
        bench.finger.take({surface, false});
        QCOMPARE(bench.taken.size(), 1);
        QVERIFY(bench.finger.here() && !bench.finger.real());
        QCOMPARE(bench.finger.about(),
                 std::string("drawn finger, mouse or touchscreen or keys, tone, at most 1.00 N"));
        QCOMPARE(bench.finger.calibration(), std::string());
        QCOMPARE(bench.lay(), std::string());
        bench.finger.bring({-40.0, 5.0});
        QVERIFY(bench.finger.brought()); // it is set down there
        bench.finger.feel({-40.0, 5.0});
        bench.pass(0.1);
        QVERIFY(length(bench.finger.place() - Vec2(-40.0, 5.0)) < 5.0);
        bench.finger.move_by({20.0, 0.0});
        bench.pass(0.5);
        QVERIFY(length(bench.finger.place() - Vec2(-20.0, 5.0)) < 5.0);
    }

    void force_is_there_only_between_feel_and_stop() {
        Bench bench;
        bench.finger.take({surface, false});
        bench.lay();
        bench.pass(0.2);
        QCOMPARE(bench.felt(), 0.0);
        bench.finger.feel({-40.0, 3.0});
        bench.pass(0.2);
        QVERIFY(bench.felt() > 0.05);
        bench.finger.stop();
        bench.pass(0.03); // a ramp of 20 ms
        QCOMPARE(bench.felt(), 0.0);
        bench.finger.feel({-40.0, 3.0});
        bench.pass(0.2);
        QVERIFY(bench.felt() > 0.05);
        bench.lay(); // what comes next is laid without force
        bench.pass(0.03);
        QCOMPARE(bench.felt(), 0.0);
    }

    void no_more_than_was_chosen_and_the_experiment_allows_is_written_down() {
        Bench bench;
        bench.preferences.change([](Choices& choices) { choices.max_force_n = 0.4; });
        bench.finger.take({surface, false});
        QVERIFY(bench.finger.about().ends_with("at most 0.40 N"));
    }

    void a_study_is_cut_at_the_person_s_limit_unless_the_researcher_consents() {
        Bench bench;
        bench.finger.take({surface, false, 5.0, false});
        QVERIFY(bench.finger.is_cut());
        QCOMPARE(bench.finger.limit_n(), 1.0);
        QVERIFY2(bench.finger.about().ends_with("at most 1.00 N, cut: the study asks for 5.00 N"),
                 bench.finger.about().c_str());
        bench.finger.take({surface, false, 5.0, true});
        QVERIFY(!bench.finger.is_cut());
        QCOMPARE(bench.finger.limit_n(), 5.0);
        QVERIFY2(bench.finger.about().ends_with("at most 5.00 N, raised with the researcher's consent"),
                 bench.finger.about().c_str());
        bench.finger.take(
            {surface, false, 0.8, true}); // no more than the study asks for, no less than the person allows
        QCOMPARE(bench.finger.limit_n(), 1.0);
        QVERIFY(bench.finger.about().ends_with("tone, at most 1.00 N"));
        bench.finger.take({surface, false, 0.8, false}); // the consent was for one study
        QCOMPARE(bench.finger.limit_n(), 1.0);
    }

    void a_device_gives_what_it_can_of_a_pull_that_was_consented_to() {
        for (const bool allowed : {false, true}) {
            Bench bench;
            bench.find_device(); // gives 3 N
            bench.finger.take({surface, true, 5.0, allowed});
            QTRY_COMPARE_WITH_TIMEOUT(bench.taken.size(), 1, 60000);
            QCOMPARE(bench.finger.limit_n(), allowed ? 3.0 : 1.0);
            QVERIFY(bench.finger.is_cut());
            bench.finger.lay([] { return make_haptic_scene(line(), {0.5, 10.0}); });
            bench.hold({-40.0, 10.0});
            bench.finger.feel({-40.0, 10.0});
            bench.pass(1.0);
            const double pulled = length(bench.socket.force());
            QVERIFY2(std::abs(pulled - (allowed ? 3.0 : 1.0)) < 0.01, qPrintable(QString::number(pulled)));
        }
    }

    void a_scene_that_cannot_be_made_is_a_sentence() {
        Bench bench;
        bench.finger.take({surface, false});
        const std::string why = "There is nothing to feel.";
        QCOMPARE(bench.finger.lay([&]() -> Result<std::unique_ptr<HapticScene>> { return Error{why}; }), why);
    }

    void a_device_is_found_taken_and_given_back() {
        Bench bench;
        QCOMPARE(bench.finger.found(), QString());
        bench.find_device();
        QCOMPARE(bench.finger.found(), QString("force pad"));
        bench.finger.take({surface, true});
        QVERIFY(!bench.finger.here()); // it is being opened
        QTRY_COMPARE_WITH_TIMEOUT(bench.taken.size(), 1, 60000);
        QVERIFY(bench.finger.here() && bench.finger.real() && bench.socket.in_use());
        QCOMPARE(bench.finger.about(), std::string("force pad, TPC-0042, at most 1.00 N"));
        QVERIFY(!bench.finger.calibration().empty());
        bench.finger.give_back();
        QVERIFY(!bench.finger.has_servo());
        QTRY_VERIFY_WITH_TIMEOUT(!bench.socket.in_use(), 60000);
        QVERIFY(bench.socket.force() == Vec2(0.0));
    }

    void the_device_leads_to_the_start_and_is_then_without_force() {
        Bench bench;
        bench.take_device();
        const Vec2 start(-50.0, -30.0);
        bench.finger.bring(start);
        QVERIFY(!bench.finger.brought());
        Vec2 handle(0.0);
        bool came = false;
        for (int i = 0; i < 4000 && !came; ++i) {
            bench.hold(handle += 0.6 * bench.socket.force());
            bench.pass(0.005);
            came = bench.finger.brought();
        }
        QVERIFY(came);
        QVERIFY2(length(handle - start) < 5.0, qPrintable(QString::number(length(handle - start))));
        bench.pass(0.03); // a ramp of 20 ms
        QVERIFY(bench.socket.force() == Vec2(0.0));
    }

    void a_hand_moves_no_device() {
        Bench bench;
        bench.take_device();
        bench.hold({-40.0, 3.0});
        bench.finger.feel({10.0, 10.0});
        bench.pass(0.3);
        QVERIFY(length(bench.socket.force()) > 0.1);
        const Vec2 before = bench.finger.place();
        bench.finger.move_by({30.0, 0.0});
        bench.pass(0.1);
        QVERIFY(length(bench.finger.place() - before) < 0.5);
    }

    void one_that_is_not_there_does_not_reach_or_cannot_be_opened_is_a_sentence() {
        Bench bench;
        bench.finger.take({surface, true});
        QVERIFY(bench.last_refusal().startsWith("The force device is not there."));
        QVERIFY(!bench.finger.has_servo());
        bench.find_device();
        bench.finger.take({{400.0, 120.0}, true});
        QTRY_VERIFY_WITH_TIMEOUT(
            bench.last_refusal().startsWith("The device does not reach all of the experiment's "
                                            "surface, 400 by 120 millimetres: force pad."),
            60000);
        QVERIFY(!bench.finger.has_servo());
        QTRY_VERIFY_WITH_TIMEOUT(!bench.socket.in_use(), 60000);
        bench.finger.take({{160.0, 400.0}, true});
        QTRY_COMPARE_WITH_TIMEOUT(bench.refused.size(), 3, 60000);
        bench.socket.refuse("The force pad does not answer. Plug it in again.");
        bench.finger.take({surface, true});
        QTRY_COMPARE_WITH_TIMEOUT(bench.last_refusal(),
                                  QString("The force pad does not answer. Plug it in again."), 60000);
        QVERIFY(!bench.finger.here() && bench.taken.isEmpty());
    }

    void what_is_wrong_is_told_once_and_whether_the_force_has_gone_for_good() {
        Bench bench;
        bench.take_device();
        bench.finger.feel({0.0, 0.0});
        bench.pass(0.2);
        QVERIFY(bench.troubled.isEmpty());
        bench.socket.switch_motors_off("The force pad is too hot. Let it cool down.");
        bench.pass(2.0);
        QCOMPARE(bench.troubled.size(), 1);
        QCOMPARE(bench.troubled.last().at(0).toString(),
                 QString("The force pad is too hot. Let it cool down."));
        bench.socket.unplug();
        bench.pass(2.0);
        QCOMPARE(bench.troubled.size(), 2);
        QVERIFY(bench.troubled.last().at(1).toBool());
        QVERIFY(bench.socket.force() == Vec2(0.0));
    }
};

} // namespace study_finger_test

TP_TEST(study_finger_test, StudyFingerTest, event_loop)
#include "study_finger_test.moc"
