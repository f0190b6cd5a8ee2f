// SPDX-License-Identifier: Apache-2.0
// The page's camera by itself: its states, what it shows and tells, why it fails, and that nothing of what it saw is left.
#include "app/capture/camera/camera_trouble.hpp"
#include "app/pages/capture/capture_camera.hpp"
#include "fake_camera.hpp"
#include "marked_sentences.hpp"
#include "test_program.hpp"

#include <QCoreApplication>
#include <QEvent>
#include <QImage>
#include <QSignalSpy>
#include <QTest>

#include <functional>
#include <memory>
#include <utility>

namespace capture_camera_test {

using namespace tp;
using State = CaptureCamera::State;

namespace {

struct Bench {
    FakeCamera* camera = new FakeCamera; ///< the page's
    CaptureCamera page{std::unique_ptr<Camera>(camera), camera->look()};
    QSignalSpy changed{&page, &CaptureCamera::changed};
    QSignalSpy pictures{&page, &CaptureCamera::pictureChanged};
    QSignalSpy began{&page, &CaptureCamera::began};
    QSignalSpy seen{&page, &CaptureCamera::seen};
    QSignalSpy failed{&page, &CaptureCamera::failed};
    double time_s = 0.0;

    /// It is open, and has given nothing yet.
    void open() {
        const int before = camera->opened;
        page.switch_on();
        QTRY_COMPARE(camera->opened, before + 1);
    }
    void see() {
        AimFrame frame;
        frame.time_s = time_s += 0.1;
        camera->show(page, frame);
    }
    void lead_to(State state) {
        if (state == CaptureCamera::Off)
            return;
        open();
        if (state == CaptureCamera::On)
            see();
        if (state == CaptureCamera::Failed) {
            camera->film->fail("The camera was unplugged.");
            QTRY_COMPARE(page.state(), CaptureCamera::Failed);
        }
        QCOMPARE(page.state(), state);
    }
    void forget_signals() {
        for (QSignalSpy* spy : {&changed, &pictures, &began, &seen, &failed})
            spy->clear();
    }
    bool shows() const { return !page.picture().value<QImage>().isNull(); }
};

/// Does something just before the next thing that was posted to an object is done.
class LastMoment final : public QObject {
public:
    LastMoment(QObject& object, std::function<void()> then) : then_(std::move(then)) {
        object.installEventFilter(this);
    }
    bool over() const { return then_ == nullptr; }

private:
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::MetaCall)
            if (const auto then = std::exchange(then_, nullptr))
                then();
        return false;
    }
    std::function<void()> then_;
};

} // namespace

class CaptureCameraTest : public QObject {
    Q_OBJECT
private slots:
    void the_table_of_its_states_holds() {
        const auto after = [](State from, const std::function<void(Bench&)>& what) {
            Bench bench;
            bench.lead_to(from);
            what(bench);
            return bench.page.state();
        };
        for (const State from :
             {CaptureCamera::Off, CaptureCamera::Begins, CaptureCamera::On, CaptureCamera::Failed}) {
            QCOMPARE(after(from, [](Bench& bench) { bench.page.switch_off(); }), CaptureCamera::Off);
            QCOMPARE(after(from, [](Bench& bench) { bench.page.switch_on(); }),
                     from == CaptureCamera::On ? CaptureCamera::On : CaptureCamera::Begins);
            if (from != CaptureCamera::Begins && from != CaptureCamera::On)
                continue;
            QCOMPARE(after(from, [](Bench& bench) { bench.see(); }), CaptureCamera::On);
            QCOMPARE(after(from,
                           [](Bench& bench) {
                               bench.camera->film->fail("The camera was unplugged.");
                               QTRY_COMPARE(bench.failed.size(), 1);
                           }),
                     CaptureCamera::Failed);
        }
    }

    void it_begins_soon_so_that_what_is_to_be_said_first_is_said_first() {
        Bench bench;
        bench.page.switch_on();
        QCOMPARE(bench.page.state(), CaptureCamera::Begins);
        QCOMPARE(bench.camera->opened, 0);
        QCOMPARE(bench.changed.size(), 1);
        bench.page.switch_on(); // it does already
        QTRY_COMPARE(bench.camera->opened, 1);
        QTest::qWait(0);
        QCOMPARE(bench.camera->opened, 1);
        QCOMPARE(bench.page.state(), CaptureCamera::Begins); // it has given nothing yet
        QVERIFY(bench.began.isEmpty());
        QCOMPARE(bench.changed.size(), 1);
    }

    void one_that_is_switched_off_and_on_at_once_is_opened_once() {
        Bench bench;
        bench.page.switch_on();
        bench.page.switch_off();
        QTest::qWait(0);
        QCOMPARE(bench.camera->opened, 0);
        bench.page.switch_on();
        bench.page.switch_off();
        bench.page.switch_on();
        QTRY_COMPARE(bench.camera->opened, 1);
        QTest::qWait(0);
        QCOMPARE(bench.camera->opened, 1);
    }

    void that_it_is_on_is_told_once_and_each_picture_as_it_comes() {
        Bench bench;
        bench.camera->both = bench.camera->torch = true;
        bench.open();
        bench.forget_signals();
        QStringList order;
        QObject::connect(&bench.page, &CaptureCamera::began, [&] {
            order << (bench.page.state() == CaptureCamera::On && bench.shows() ? "began" : "too early");
        });
        QObject::connect(&bench.page, &CaptureCamera::seen, [&] { order << "seen"; });
        bench.see();
        QCOMPARE(order, QStringList({"began", "seen"}));
        QVERIFY(bench.page.both() && bench.page.torch());
        QCOMPARE(bench.page.picture().value<QImage>().size(), QSize(64, 36));
        bench.see();
        bench.see();
        QCOMPARE(bench.began.size(), 1);
        QCOMPARE(bench.seen.size(), 3);
        QCOMPARE(bench.seen.last().at(0).value<AimFrame>().time_s, bench.time_s);
        QCOMPARE(bench.pictures.size(), 3);
        QCOMPARE(bench.changed.size(), 1); // it is on; a picture changes nothing else
        const auto frames = bench.page.last_frames();
        QCOMPARE(frames.size(), std::size_t(3));
        QVERIFY(frames.front().time_s < frames.back().time_s);
    }

    void nothing_of_what_it_saw_is_left_when_it_is_off() {
        Bench bench;
        bench.camera->torch = true;
        bench.lead_to(CaptureCamera::On);
        bench.page.light(true);
        bench.forget_signals();
        bench.page.switch_off();
        QVERIFY(!bench.camera->on);
        QVERIFY(!bench.shows() && bench.page.last_frames().empty() && !bench.page.lit());
        QCOMPARE(bench.changed.size(), 1);
        QCOMPARE(bench.pictures.size(), 1);
        QVERIFY(bench.failed.isEmpty());
        bench.page.switch_off(); // it is
        QCOMPARE(bench.changed.size(), 1);
        QCOMPARE(bench.pictures.size(), 1);
    }

    void what_was_on_its_way_when_it_was_switched_off_is_not_heard() {
        Bench bench;
        bench.lead_to(CaptureCamera::On);
        const LastMoment frame(bench.page, [&] { bench.page.switch_off(); });
        bench.forget_signals();
        bench.camera->film->show({});
        QTRY_VERIFY(frame.over());
        QTest::qWait(0);
        QVERIFY(bench.seen.isEmpty() && !bench.shows());
        QCOMPARE(bench.page.state(), CaptureCamera::Off);
        bench.lead_to(CaptureCamera::On);
        const LastMoment end(bench.page, [&] { bench.page.switch_off(); });
        bench.camera->film->fail("The camera was unplugged.");
        QTRY_VERIFY(end.over());
        QTest::qWait(0);
        QVERIFY(bench.failed.isEmpty());
        QCOMPARE(bench.page.state(), CaptureCamera::Off);
        QCOMPARE(bench.page.problem(), QString());
    }

    void one_that_the_system_keeps_back_says_why_and_is_tried_again() {
        testing::Brackets translator;
        QCoreApplication::installTranslator(&translator);
        Bench bench;
        bench.camera->why_not = sentence_of(CameraTrouble::denied);
        bench.page.switch_on();
        QTRY_COMPARE(bench.failed.size(), 1);
        QCOMPARE(bench.page.state(), CaptureCamera::Failed);
        QCOMPARE(bench.page.problem(), QString("⟦The system does not let TouchPhoto use the camera.⟧"));
        QVERIFY(bench.began.isEmpty());
        bench.page.switch_on();
        QCOMPARE(bench.page.state(), CaptureCamera::Begins);
        QCOMPARE(bench.page.problem(), QString()); // it is not known whether it is so still
        QTRY_COMPARE(bench.failed.size(), 2);
        bench.camera->why_not.clear();
        bench.lead_to(CaptureCamera::On);
        QCOMPARE(bench.failed.size(), 2);
        QCOMPARE(bench.began.size(), 1);
    }

    void one_that_is_unplugged_or_not_to_be_read_says_so_and_lets_go_of_everything() {
        testing::Brackets translator;
        QCoreApplication::installTranslator(&translator);
        for (const CameraTrouble trouble : {CameraTrouble::unplugged, CameraTrouble::unreadable}) {
            Bench bench;
            bench.camera->torch = true;
            bench.lead_to(CaptureCamera::On);
            bench.page.light(true);
            QString told;
            QObject::connect(&bench.page, &CaptureCamera::failed, [&] { told = bench.page.problem(); });
            bench.camera->film->fail(sentence_of(trouble));
            QTRY_COMPARE(bench.failed.size(), 1);
            QCOMPARE(told, QString("⟦%1⟧").arg(QString::fromStdString(sentence_of(trouble))));
            QCOMPARE(bench.page.state(), CaptureCamera::Failed);
            QVERIFY(!bench.camera->on);
            QVERIFY(!bench.shows() && bench.page.last_frames().empty() && !bench.page.lit());
            bench.page.switch_off();
            QCOMPARE(bench.page.problem(), QString());
        }
    }

    void one_that_ends_without_a_word_has_stopped() {
        Bench bench;
        bench.lead_to(CaptureCamera::On);
        bench.camera->film->end();
        QTRY_COMPARE(bench.failed.size(), 1);
        QCOMPARE(bench.page.problem(), QString("The camera has stopped."));
    }

    void the_other_one_is_turned_to_where_there_are_two() {
        Bench bench;
        bench.lead_to(CaptureCamera::On);
        bench.page.turn_round(); // there is no other
        QCOMPARE(bench.page.state(), CaptureCamera::On);
        QVERIFY(!bench.page.front());
        bench.page.switch_off();
        bench.camera->both = true;
        bench.lead_to(CaptureCamera::On);
        const auto turn = [&](int opened) {
            bench.page.turn_round();
            QCOMPARE(bench.page.state(), CaptureCamera::Begins);
            QVERIFY(!bench.shows()); // nothing of the other one's view
            QTRY_COMPARE(bench.camera->opened, opened);
            bench.see();
        };
        turn(3);
        QVERIFY(bench.page.front() && bench.page.held().front);
        bench.page.switch_off();
        QVERIFY(bench.page.front() && !bench.page.held().front); // it comes back as it was left
        bench.lead_to(CaptureCamera::On);
        QVERIFY(bench.page.held().front);
        turn(5);
        QVERIFY(!bench.page.front() && !bench.page.held().front);
        bench.camera->only_back = true; // it was pulled out
        turn(6);
        QVERIFY(!bench.page.front());
    }

    void the_light_is_that_of_the_camera_that_is_on() {
        Bench bench;
        bench.lead_to(CaptureCamera::On);
        bench.page.light(true);
        QVERIFY(!bench.page.lit() && !bench.camera->lit); // it has none
        bench.page.switch_off();
        bench.camera->torch = true;
        bench.lead_to(CaptureCamera::On);
        bench.forget_signals();
        bench.page.light(true);
        bench.page.light(true);
        QVERIFY(bench.page.lit() && bench.camera->lit);
        QCOMPARE(bench.changed.size(), 1);
        bench.page.light(false);
        QVERIFY(!bench.page.lit() && !bench.camera->lit);
        QCOMPARE(bench.changed.size(), 2);
        bench.page.switch_off();
        bench.page.light(true);
        QVERIFY(!bench.page.lit() && !bench.camera->lit);
    }

    void at_a_desk_keys_are_its_hand() {
        Bench bench;
        QVERIFY(!bench.page.moved_by_keys());
        bench.camera->movable = true;
        QVERIFY(bench.page.moved_by_keys());
        HeldPose way;
        way.pan_deg = 2.0;
        bench.page.move_by(way);
        QCOMPARE(bench.camera->moved.pan_deg, 2.0);
    }
};

} // namespace capture_camera_test

TP_TEST(capture_camera_test, CaptureCameraTest, event_loop)
#include "capture_camera_test.moc"
