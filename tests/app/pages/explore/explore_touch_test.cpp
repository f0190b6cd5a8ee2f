// SPDX-License-Identifier: Apache-2.0
// An output under a bare finger on the Explore page: it ticks where lines are, comes and goes, and contradicts no other guide.
#include "app/parts/controls/recording_announcer.hpp"
#include "device_socket.hpp"
#include "explore_bench.hpp"
#include "test_program.hpp"
#include "touch_socket.hpp"

#include <QLineF>
#include <QTest>

#include <algorithm>
#include <memory>
#include <string>

namespace explore_touch_test {

using namespace tp;
using tp::testing::DeviceSocket;
using tp::testing::TouchSocket;

namespace {

constexpr int outline = 3;

struct Bench {
    TouchSocket socket;
    DeviceSocket devices;
    RecordingVoice voice;
    RecordingAnnouncer announcer;
    Narrator narrator{voice, announcer};
    ExploreSounds sounds;
    std::unique_ptr<ExploreSession> session;

    explicit Bench(Choices::Guide guide = Choices::Guide::ticks_and_sonar, bool with_devices = false,
                   bool with_drawn = false) {
        sounds.preferences.change([guide](Choices& choices) { choices.guide = guide; });
        ExploreSettings settings = patient_settings();
        settings.touch = socket.access();
        if (with_drawn)
            add_drawn(settings.touch);
        if (with_devices)
            settings.devices = devices.access();
        session = std::make_unique<ExploreSession>(narrator, sounds.earcons, sounds.guide, sounds.preferences,
                                                   settings);
        devices.hold_at({0.0, 100.0});
    }
    static void add_drawn(TouchAccess& access) {
        access.list = [others = access.list] {
            auto all = others();
            all.push_back({drawn_touch_name, "drawn finger", {}, TouchMeans::friction, false});
            return all;
        };
        access.make = [others =
                           access.make](const std::string& name) -> Result<std::unique_ptr<TouchOutput>> {
            if (name == drawn_touch_name)
                return std::unique_ptr<TouchOutput>(std::make_unique<DrawnTouch>(200.0, 150.0, nullptr));
            return others(name);
        };
    }
    void begin() {
        session->enter();
        session->show(drawn_photo());
    }
    bool in_use() const { return session->touch()->state() == ExploreTouch::State::InUse; }
    bool said(const QString& part) const { return !voice.said().filter(part).isEmpty(); }
    /// A place left of the outline's left side by so much, sheet frame.
    QPointF left_of_outline(double away) const {
        const auto& points = session->view()->felt().lines.at(outline).points;
        return session->view()->frame().from_surface(0.5 * (points[0] + points[1]) - Vec2(away, 0.0));
    }
    /// The fingertip goes over the outline's left side.
    void cross() {
        ExploreHand& hand = *session->hand();
        const QPointF first = left_of_outline(6.0);
        hand.fingerDown(0, first.x(), first.y());
        for (double away = 6.0; away > -6.0; away -= 0.25) {
            const QPointF place = left_of_outline(away);
            hand.fingerMoved(0, place.x(), place.y());
            QTest::qWait(4);
        }
    }
};

} // namespace

class ExploreTouchTest : public QObject {
    Q_OBJECT
private slots:
    void a_line_that_a_fingertip_crosses_ticks() {
        Bench bench;
        bench.socket.plug_in();
        bench.begin();
        QTRY_VERIFY(bench.in_use());
        QVERIFY(bench.said("Ticks: test pad."));
        QCOMPARE(bench.session->touch()->name(), QString("test pad"));
        bench.cross();
        QTRY_VERIFY(!bench.socket.ticks().empty());
        QVERIFY(bench.socket.ticks()[0].amplitude() > 0.1);
    }

    void nobody_who_has_not_chosen_ticks_has_any() {
        Bench bench(Choices::Guide::both);
        bench.socket.plug_in();
        bench.begin();
        QTest::qWait(200);
        QVERIFY(!bench.in_use());
        QCOMPARE(bench.socket.open(), 0);
        bench.session->choices()->setGuide(static_cast<int>(Choices::Guide::ticks));
        QTRY_VERIFY(bench.in_use());
        bench.session->choices()->setGuide(static_cast<int>(Choices::Guide::none));
        QVERIFY(!bench.in_use());
        QTRY_COMPARE(bench.socket.open(), 0);
    }

    void a_lost_output_is_told_once_and_used_again_when_it_is_there_again() {
        Bench bench(Choices::Guide::ticks);
        bench.socket.plug_in();
        bench.begin();
        QTRY_VERIFY(bench.in_use());
        QVERIFY(!bench.session->choices()->beeps());
        bench.socket.unplug();
        QTRY_VERIFY(!bench.in_use());
        QCOMPARE(bench.voice.said().filter("Test pad is gone.").size(), 1);
        QVERIFY(bench.session->choices()->beeps()); // sound goes on
        QVERIFY(bench.session->device()->engaged());
        QTest::qWait(100);
        QCOMPARE(bench.voice.said().filter("gone").size(), 1);
        bench.voice.clear();
        bench.socket.plug_in();
        QTRY_VERIFY(bench.in_use());
        QVERIFY(bench.said("Ticks: test pad."));
        bench.cross();
        QTRY_VERIFY(!bench.socket.ticks().empty());
    }

    void the_drawn_finger_takes_the_place_of_a_lost_output_in_one_sentence() {
        Bench bench(Choices::Guide::ticks, false, true);
        bench.socket.plug_in();
        bench.begin();
        QTRY_COMPARE(bench.session->touch()->name(), QString("test pad"));
        bench.voice.clear();
        bench.socket.unplug();
        QTRY_COMPARE(bench.session->touch()->name(), QString("drawn finger"));
        QTest::qWait(100);
        QCOMPARE(bench.voice.said(),
                 QStringList("Test pad is gone. Until it is there again, ticks come from: drawn finger."));
        QVERIFY(!bench.session->choices()->beeps());
        bench.voice.clear();
        bench.socket.plug_in();
        QTRY_COMPARE(bench.session->touch()->name(), QString("test pad"));
        QCOMPARE(bench.voice.said(), QStringList("Ticks: test pad."));
    }

    void a_refused_output_that_was_unplugged_is_asked_again_when_it_is_plugged_in() {
        Bench bench;
        bench.socket.plug_in(false, "It is held by another program.");
        bench.begin();
        QTRY_VERIFY(bench.said("It is held by another program."));
        bench.socket.unplug();
        QTest::qWait(100);
        bench.socket.plug_in();
        QTRY_VERIFY(bench.in_use());
    }

    void each_output_is_told_as_much_earlier_as_it_is_late() {
        Bench bench;
        bench.sounds.preferences.change([](Choices& choices) { choices.touch_latencies_s["A"] = 0.06; });
        const auto latency = [&](const ListedTouchOutput& output) {
            return bench.session->choices()->touch_settings(output).latency_s;
        };
        QCOMPARE(latency({"motor:A", "motor", "A", TouchMeans::rumble, false, 0.03}), 0.06);
        QCOMPARE(latency({"motor:B", "motor", "B", TouchMeans::rumble, false, 0.03}), 0.03);
    }

    void where_there_is_none_that_is_told_once_and_beeps_guide() {
        Bench bench(Choices::Guide::ticks);
        bench.begin();
        QTRY_VERIFY(bench.said("There is nothing here that ticks"));
        QVERIFY(bench.session->choices()->beeps());
        QTest::qWait(100);
        QCOMPARE(bench.voice.said().filter("nothing here that ticks").size(), 1);
    }

    void one_that_cannot_be_opened_is_told_once_and_asked_again_by_enter() {
        Bench bench;
        bench.socket.plug_in(false, "It is held by another program.");
        bench.begin();
        QTRY_VERIFY(bench.said("It is held by another program. Until then beeps and words guide."));
        QTest::qWait(100);
        QCOMPARE(bench.voice.said().filter("held by another").size(), 1);
        bench.socket.plug_in();
        bench.session->device()->engage();
        QTRY_VERIFY(bench.in_use());
    }

    void a_force_device_ends_the_ticks_and_its_loss_brings_them_back() {
        Bench bench(Choices::Guide::ticks, true);
        bench.socket.plug_in();
        bench.begin();
        QTRY_VERIFY(bench.in_use());
        bench.devices.plug_in();
        QTRY_VERIFY(bench.session->device()->in_use());
        QVERIFY(!bench.in_use());
        QTRY_COMPARE(bench.socket.open(), 0);
        bench.devices.unplug();
        QTRY_VERIFY(bench.in_use());
        QVERIFY(!bench.session->device()->in_use());
    }

    void no_force_is_drawn_beside_ticks() {
        Bench bench;
        bench.socket.plug_in();
        bench.begin();
        QTRY_VERIFY(bench.in_use());
        const QPointF place = bench.left_of_outline(3.0);
        bench.session->hand()->touchDown(place.x(), place.y());
        QTest::qWait(100);
        QCOMPARE(bench.session->finger()->newtons(), 0.0);
        QVERIFY(QLineF(bench.session->finger()->place(), place).length() < 0.01);
    }

    void on_the_line_ticks_speak_and_the_tone_is_silent() {
        Bench bench;
        bench.socket.plug_in();
        bench.begin();
        QTRY_VERIFY(bench.in_use());
        const QPointF beside = bench.left_of_outline(10.0);
        bench.session->hand()->fingerDown(0, beside.x(), beside.y());
        QTRY_VERIFY(bench.sounds.guide.sounds());
        const QPointF on_it = bench.left_of_outline(0.0);
        bench.session->hand()->fingerMoved(0, on_it.x(), on_it.y());
        QTRY_VERIFY(!bench.sounds.guide.sounds());
    }

    void escape_and_enter_switch_ticks_off_and_on() {
        Bench bench;
        bench.socket.plug_in();
        bench.begin();
        QTRY_VERIFY(bench.in_use());
        QVERIFY(bench.session->stop());
        QVERIFY(bench.said("Stopped. Ticks are off. Press Enter to switch them on."));
        bench.cross();
        QTest::qWait(50);
        QVERIFY(bench.socket.ticks().empty());
        bench.session->device()->engage();
        QVERIFY(bench.said("Ticks are on."));
        bench.cross();
        QTRY_VERIFY(!bench.socket.ticks().empty());
    }

    void a_tour_leads_a_hand_that_follows_its_ticks() {
        Bench bench;
        bench.socket.plug_in();
        bench.begin();
        QTRY_VERIFY(bench.in_use());
        bench.session->hand()->goToFeature(0);
        QTest::qWait(50);
        bench.session->tour()->toggle();
        QVERIFY(bench.said("Follow the ticks: they grow toward the line."));
        QTRY_VERIFY(!bench.socket.ticks().empty() && bench.session->finger()->led());
        const auto leader = [&] { return bench.session->finger()->leader(); };
        for (int i = 0; i < 4000 && bench.session->tour()->touring(); ++i) {
            const QPointF place = leader();
            bench.session->hand()->moveTo(place.x(), place.y());
            QTest::qWait(5);
        }
        QVERIFY(bench.said("Tour finished."));
        QTRY_VERIFY(!bench.session->finger()->led());
        QVERIFY(bench.socket.ticks().size() > 3);
    }

    void a_pad_moves_the_finger_and_mouse_and_keys_do_not() {
        Bench bench;
        bench.socket.plug_in(true);
        bench.begin();
        QTRY_VERIFY(bench.in_use());
        QTest::qWait(50);
        QVERIFY(bench.session->finger()->lifted());
        bench.socket.finger_at({10.0, 0.0});
        const double scale = bench.session->view()->surfaceHeight() / 40.0;
        const QPointF right(0.5 * bench.session->view()->surfaceWidth() + 10.0 * scale,
                            0.5 * bench.session->view()->surfaceHeight());
        QTRY_VERIFY(QLineF(bench.session->finger()->place(), right).length() < 0.01);
        QVERIFY(!bench.session->finger()->lifted());
        bench.session->hand()->moveTo(5.0, 5.0);
        bench.session->hand()->nudge(5.0, 0.0);
        QTest::qWait(50);
        QVERIFY(QLineF(bench.session->finger()->place(), right).length() < 0.01);
        bench.socket.lift();
        QTRY_VERIFY(bench.session->finger()->lifted());
    }

    void the_drawn_output_stands_in_until_another_comes_and_after_it_has_gone() {
        Bench bench(Choices::Guide::ticks, false, true);
        bench.begin();
        QTRY_COMPARE(bench.session->touch()->name(), QString("drawn finger"));
        QVERIFY(!bench.said("gone"));
        bench.socket.plug_in();
        QTRY_COMPARE(bench.session->touch()->name(), QString("test pad"));
        QVERIFY(bench.session->device()->engaged());
        bench.cross();
        QTRY_VERIFY(!bench.socket.ticks().empty());
        bench.socket.unplug();
        QTRY_COMPARE(bench.session->touch()->name(), QString("drawn finger"));
        QVERIFY(bench.said("Test pad is gone."));
        bench.socket.plug_in();
        QTRY_COMPARE(bench.session->touch()->name(), QString("test pad"));
        QVERIFY(bench.session->device()->engaged());
    }

    void a_drawn_finger_lags_behind_the_hand_on_a_line() {
        Bench bench(Choices::Guide::ticks, false, true);
        bench.begin();
        QTRY_VERIFY(bench.in_use());
        const QPointF beside = bench.left_of_outline(10.0);
        bench.session->hand()->touchDown(beside.x(), beside.y());
        QTRY_VERIFY(QLineF(bench.session->finger()->place(), beside).length() < 0.01);
        double most = 0.0;
        for (double away = 10.0; away > -5.0; away -= 0.4) {
            const QPointF place = bench.left_of_outline(away);
            bench.session->hand()->moveTo(place.x(), place.y());
            QTest::qWait(4);
            most = std::max(most, QLineF(bench.session->finger()->place(), place).length());
        }
        QVERIFY(most > 1.5);
    }

    void out_of_sight_it_is_given_back() {
        Bench bench;
        bench.socket.plug_in();
        bench.begin();
        QTRY_VERIFY(bench.in_use());
        bench.session->leave();
        QTRY_COMPARE(bench.socket.open(), 0);
        bench.session->enter();
        QTRY_VERIFY(bench.in_use());
    }
};

} // namespace explore_touch_test

TP_TEST(explore_touch_test, ExploreTouchTest, window)
#include "explore_touch_test.moc"
