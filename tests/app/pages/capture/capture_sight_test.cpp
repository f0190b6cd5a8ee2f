// SPDX-License-Identifier: Apache-2.0
// The camera, and what leads the hand, are on only while the page is seen, and are silent for a memo.
#include "app/pages/capture/capture_camera.hpp"
#include "app/pages/capture/capture_moment.hpp"
#include "app/pages/capture/capture_shutter.hpp"
#include "app/pages/capture/capture_sight.hpp"
#include "capture_ground.hpp"
#include "fake_camera.hpp"
#include "test_program.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QImage>
#include <QLocale>

#include <functional>
#include <memory>
#include <vector>

namespace capture_sight_test {

using namespace tp;
using State = CaptureSight::State;

namespace {

const Vec2 at_the_right{0.85, 0.45};

struct Bench : CaptureParts {
    FakeCamera* camera = new FakeCamera; ///< the page's
    CaptureCamera page_camera{std::unique_ptr<Camera>(camera), camera->look()};
    CaptureShutter shutter{keeping, std::make_shared<KnownPeople>(), teller};
    CaptureMoment moment{keeping, choices, moment_recorder, teller};
    CaptureSight sight{page_camera, pulses, aiming, shutter, memo, moment, teller};

    explicit Bench(const Choices& choices = told()) : CaptureParts(choices) {}
    void enter() {
        sight.enter();
        QTRY_VERIFY(camera->on);
    }
    void see_for(double seconds, const std::vector<Vec2>& faces = {at_the_right}) {
        for (double end = time_s + seconds - 1e-6; time_s < end;)
            camera->show(page_camera, frame(faces));
    }
    /// The microphone of the moment is on, and hears.
    bool moment_heard() {
        return QTest::qWaitFor([this] { return (hear_moment(0.1), moment.hears()); }, 60000);
    }
    void take() {
        shutter.take({page_camera.last_frames(), page_camera.held(), page_camera.name()});
        QTRY_VERIFY_WITH_TIMEOUT(!shutter.taking(), 60000);
    }
};

Choices with_moment() {
    Choices choices = CaptureGround::told();
    choices.keep_moment = true;
    return choices;
}

} // namespace

class CaptureSightTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English)); }

    void the_table_of_its_states_holds() {
        const auto lead_to = [](CaptureSight& sight, State state) {
            if (state == State::Away || state == State::Hidden)
                sight.show_window(false);
            if (state == State::Hidden || state == State::Seen)
                sight.enter();
            QVERIFY(sight.state() == state);
        };
        const auto after = [&](State from, const std::function<void(CaptureSight&)>& what) {
            Bench bench;
            lead_to(bench.sight, from);
            what(bench.sight);
            return bench.sight.state();
        };
        const auto opened = [&](State from) {
            return after(from, [](CaptureSight& sight) { sight.enter(); });
        };
        const auto left = [&](State from) { return after(from, [](CaptureSight& sight) { sight.leave(); }); };
        const auto hidden = [&](State from) {
            return after(from, [](CaptureSight& sight) { sight.show_window(false); });
        };
        const auto shown = [&](State from) {
            return after(from, [](CaptureSight& sight) { sight.show_window(true); });
        };
        QVERIFY(opened(State::Left) == State::Seen && opened(State::Away) == State::Hidden);
        QVERIFY(opened(State::Hidden) == State::Hidden && opened(State::Seen) == State::Seen);
        QVERIFY(left(State::Left) == State::Left && left(State::Away) == State::Away);
        QVERIFY(left(State::Hidden) == State::Away && left(State::Seen) == State::Left);
        QVERIFY(hidden(State::Left) == State::Away && hidden(State::Away) == State::Away);
        QVERIFY(hidden(State::Hidden) == State::Hidden && hidden(State::Seen) == State::Hidden);
        QVERIFY(shown(State::Left) == State::Left && shown(State::Away) == State::Left);
        QVERIFY(shown(State::Hidden) == State::Seen && shown(State::Seen) == State::Seen);
    }

    void the_camera_is_off_and_nothing_is_kept_when_the_page_is_left() {
        Bench bench;
        bench.enter();
        bench.see_for(0.5);
        bench.take();
        QVERIFY(bench.guide.sounds());
        QVERIFY(!bench.page_camera.picture().value<QImage>().isNull());
        QVERIFY(!bench.page_camera.last_frames().empty());
        QVERIFY(bench.shutter.count() > 0);
        bench.sight.leave();
        QVERIFY(!bench.camera->on);
        QVERIFY(bench.page_camera.picture().value<QImage>().isNull());
        QVERIFY(bench.page_camera.last_frames().empty());
        QCOMPARE(bench.shutter.count(), 0);
        QVERIFY(!bench.guide.sounds());
        QCOMPARE(bench.aiming.advice(), QString());
        QCOMPARE(bench.page_camera.state(), CaptureCamera::Off);
    }

    void it_is_off_while_the_window_is_not_to_be_seen() {
        Bench bench;
        bench.enter();
        bench.see_for(0.3);
        bench.sight.show_window(false);
        QVERIFY(!bench.camera->on);
        QVERIFY(!bench.guide.sounds());
        bench.sight.show_window(true);
        QTRY_VERIFY(bench.camera->on);
        bench.sight.leave();
        bench.sight.show_window(false);
        bench.sight.show_window(true);
        QTest::qWait(0);
        QVERIFY(!bench.camera->on);
    }

    void a_page_that_opens_in_a_hidden_window_waits_for_it() {
        Bench bench;
        bench.sight.show_window(false);
        bench.sight.enter();
        QTest::qWait(0);
        QCOMPARE(bench.camera->opened, 0);
        bench.teller.tell("A greeting.");
        const int stops = bench.voice.stops();
        bench.sight.leave();
        QVERIFY(bench.voice.stops() > stops);
        bench.sight.enter();
        bench.sight.show_window(true);
        QTRY_VERIFY(bench.camera->on);
    }

    void a_camera_that_begins_is_heard_and_one_that_fails_leads_nobody_any_more() {
        Bench bench(with_moment());
        bench.enter();
        bench.see_for(0.5);
        QVERIFY(bench.sounded(Earcon::ready));
        QVERIFY(bench.guide.sounds());
        QVERIFY(bench.moment_heard());
        bench.camera->film->fail("The camera was unplugged.");
        QTRY_COMPARE(bench.page_camera.state(), CaptureCamera::Failed);
        QVERIFY(!bench.guide.sounds());
        QTRY_VERIFY_WITH_TIMEOUT(!bench.moment.hears(), 60000);
        bench.sight.try_again();
        QTRY_VERIFY(bench.camera->on);
        bench.camera->film->fail("The camera was unplugged.");
        QTRY_COMPARE(bench.page_camera.state(), CaptureCamera::Failed);
        bench.sight.show_window(false);
        bench.sight.try_again();
        QTest::qWait(0);
        QVERIFY(!bench.camera->on);
    }

    void the_hand_is_not_led_while_a_memo_is_spoken_and_is_led_again_after_it() {
        Bench bench(with_moment());
        bench.enter();
        bench.see_for(0.5);
        bench.take();
        QVERIFY(bench.moment_heard());
        bench.memo.start(bench.shutter.photo(), "en");
        QTRY_VERIFY_WITH_TIMEOUT(!bench.moment.hears(), 60000); // the memo has the microphone
        bench.voice.clear();
        bench.see_for(3.0);
        QVERIFY2(bench.voice.said().isEmpty(), qPrintable(bench.last_said()));
        QVERIFY(!bench.guide.sounds());
        bench.hear(1.0);
        bench.memo.finish();
        QTRY_VERIFY_WITH_TIMEOUT(!bench.memo.running(), 60000);
        bench.see_for(0.3);
        QVERIFY(bench.guide.sounds());
        QVERIFY(bench.moment_heard());
        QTRY_VERIFY_WITH_TIMEOUT(!bench.voice.said().filter("Saved").isEmpty(), 60000);
    }

    void a_memo_that_is_over_after_the_page_was_left_switches_no_microphone_on() {
        Bench bench(with_moment());
        bench.enter();
        bench.see_for(0.5);
        bench.take();
        bench.memo.start(bench.shutter.photo(), "en");
        bench.hear(1.0);
        bench.sight.leave();
        QTRY_VERIFY_WITH_TIMEOUT(bench.last_said().contains("Saved"), 60000);
        QVERIFY(!bench.memo.running());
        bench.hear_moment(0.5); // nobody listens
        QCoreApplication::processEvents();
        QVERIFY(!bench.moment.hears());
        QCOMPARE(QDir(bench.photographs().front() + ".tags").entryList({"*.flac"}).size(), 1);
    }
};

} // namespace capture_sight_test

TP_TEST(capture_sight_test, CaptureSightTest, window)
#include "capture_sight_test.moc"
