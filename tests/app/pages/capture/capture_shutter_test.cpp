// SPDX-License-Identifier: Apache-2.0
// The shutter: what is kept, what is told of it, what is taken back, and that no file is written before.
#include "capture_bench.hpp"
#include "test_program.hpp"

#include <QDir>
#include <QFile>
#include <QSignalSpy>

namespace capture_shutter_test {

using namespace tp;

namespace {

const Vec2 middle{0.5, 0.45};
const Vec2 at_the_right{0.85, 0.45};

} // namespace

class CaptureShutterTest : public QObject {
    Q_OBJECT

private slots:
    void nothing_is_written_unless_the_shutter_acts() {
        CaptureBench bench;
        bench.enter();
        bench.see_for(3.0, {at_the_right});
        bench.session->leave();
        QVERIFY(!QDir(bench.album()).exists());
    }

    void a_photograph_is_kept_and_then_told() {
        CaptureBench bench;
        bench.enter();
        bench.see_for(0.5, {at_the_right});
        const QSignalSpy touched(bench.session.get(), &CaptureSession::touched);
        bench.voice.clear();
        bench.session->take();
        QVERIFY(bench.session->shutter()->taking());
        QTRY_VERIFY_WITH_TIMEOUT(!bench.session->shutter()->taking(), 60000);
        QCOMPARE(bench.photographs().size(), 1);
        QVERIFY(QFile::exists(bench.photographs().front() + ".xmp"));
        QCOMPARE(touched.size(), 1);
        QCOMPARE(bench.last_said(), bench.session->shutter()->taken());
        QVERIFY2(bench.last_said().startsWith("Taken"), qPrintable(bench.last_said()));
    }

    void it_is_taken_by_itself_once_where_all_is_well() {
        CaptureBench bench;
        bench.enter();
        bench.see_for(4.0, {middle});
        bench.settle();
        QCOMPARE(bench.photographs().size(), 1);
        bench.see_for(0.5, {at_the_right});
        bench.see_for(2.0, {middle});
        bench.settle();
        QCOMPARE(bench.photographs().size(), 2);
    }

    void whoever_comes_back_gets_no_second_one_of_the_same_scene() {
        CaptureBench bench;
        bench.enter();
        bench.see_for(2.0, {middle});
        bench.settle();
        QCOMPARE(bench.photographs().size(), 1);
        bench.session->setInSight(false); // another window for a moment
        bench.session->setInSight(true);
        QTRY_VERIFY(bench.camera->on);
        bench.see_for(3.0, {middle});
        bench.settle();
        QCOMPARE(bench.photographs().size(), 1);
        bench.session->leave();
        bench.enter();
        bench.see_for(3.0, {middle});
        bench.settle();
        QCOMPARE(bench.photographs().size(), 1);
        bench.session->take();
        bench.settle();
        QCOMPARE(bench.photographs().size(), 2);
    }

    void whoever_takes_it_alone_gets_no_second_one() {
        CaptureBench bench;
        bench.enter();
        bench.see_for(0.5, {middle});
        bench.session->take();
        bench.settle();
        bench.see_for(3.0, {middle});
        bench.settle();
        QCOMPARE(bench.photographs().size(), 1);
    }

    void not_by_itself_where_the_person_does_not_want_that() {
        Choices choices = CaptureBench::told();
        choices.shutter_by_itself = false;
        CaptureBench bench(choices);
        bench.enter();
        bench.see_for(3.0, {middle});
        bench.settle();
        QCOMPARE(bench.photographs().size(), 0);
    }

    void undo_deletes_it_again() {
        CaptureBench bench;
        bench.enter();
        bench.see_for(0.5, {at_the_right});
        bench.session->shutter()->undo();
        QCOMPARE(bench.last_said(), QString("There is nothing to undo."));
        bench.session->take();
        bench.settle();
        QVERIFY(bench.session->shutter()->can_undo());
        bench.session->shutter()->undo();
        QTRY_VERIFY_WITH_TIMEOUT(bench.photographs().isEmpty(), 60000);
        QTRY_VERIFY2(bench.last_said().startsWith("Undone: "), qPrintable(bench.last_said()));
        QVERIFY(bench.session->shutter()->photo().empty());
        QVERIFY(!bench.session->shutter()->can_undo());
    }

    void the_others_of_the_burst_are_looked_through_and_kept_too() {
        CaptureBench bench;
        bench.enter();
        bench.see_for(0.6, {at_the_right});
        bench.session->take();
        bench.settle();
        CaptureShutter& shutter = *bench.session->shutter();
        QVERIFY(shutter.count() > 3);
        shutter.look(1);
        QCOMPARE(shutter.shown(), 1);
        QTRY_VERIFY_WITH_TIMEOUT(!shutter.picture().value<QImage>().isNull(), 60000);
        QTRY_VERIFY2(bench.last_said().startsWith("Frame 2 of "), qPrintable(bench.last_said()));
        shutter.keepShown();
        bench.settle();
        QCOMPARE(bench.photographs().size(), 2);
        QVERIFY(bench.session->stop()); // away from the burst
        QCOMPARE(shutter.shown(), -1);
        bench.session->leave();
        QCOMPARE(shutter.count(), 0);
    }

    void a_burst_that_comes_after_the_page_was_left_is_kept_on_disk_only() {
        CaptureBench bench;
        bench.enter();
        bench.see_for(0.6, {at_the_right});
        bench.session->take();
        bench.session->leave();
        bench.settle();
        QCOMPARE(bench.photographs().size(), 1);
        QCOMPARE(bench.session->shutter()->count(), 0);
    }

    void what_cannot_be_kept_is_told() {
        CaptureBench bench;
        QFile in_the_way(bench.album());
        QVERIFY(in_the_way.open(QIODevice::WriteOnly));
        bench.enter();
        bench.see_for(0.5, {at_the_right});
        bench.voice.clear();
        bench.session->take();
        bench.settle();
        QVERIFY2(bench.last_said().contains("cannot be added"), qPrintable(bench.last_said()));
        QVERIFY(bench.session->shutter()->photo().empty());
    }

    void a_memo_is_spoken_for_it() {
        CaptureBench bench;
        bench.enter();
        bench.see_for(0.5, {at_the_right});
        bench.session->recordMemo();
        QVERIFY2(bench.last_said().startsWith("Take a photograph first"), qPrintable(bench.last_said()));
        bench.session->take();
        bench.settle();
        bench.session->recordMemo();
        QVERIFY(bench.session->memo()->running());
        bench.hear(1.0);
        bench.session->take(); // Space ends it as M does
        QTRY_VERIFY_WITH_TIMEOUT(bench.last_said().contains("Saved"), 60000);
        const QDir tags(bench.photographs().front() + ".tags");
        QCOMPARE(tags.entryList({"*.flac"}).size(), 1);
        QCOMPARE(bench.photographs().size(), 1);
    }

    void the_sound_of_the_moment_is_kept_where_the_person_chose_it() {
        Choices choices = CaptureBench::told();
        choices.keep_moment = true;
        CaptureBench bench(choices);
        bench.enter();
        QVERIFY2(bench.voice.said().front().endsWith("The microphone is on."),
                 qPrintable(bench.voice.said().front()));
        bench.see_for(0.5, {at_the_right});
        bench.hear_moment(3.0);
        QTRY_VERIFY(bench.session->moment()->hears());
        bench.session->take();
        bench.settle();
        bench.hear_moment(6.0);
        const QDir tags(bench.photographs().front() + ".tags");
        QTRY_COMPARE_WITH_TIMEOUT(tags.entryList({"*.flac"}).size(), 1, 60000);
        bench.session->leave();
        QTRY_VERIFY(!bench.session->moment()->hears());
    }

    void without_that_choice_no_microphone_is_on() {
        CaptureBench bench;
        bench.enter();
        bench.see_for(0.5, {at_the_right});
        bench.session->take();
        bench.settle();
        QVERIFY(bench.moment_microphone.load() == nullptr);
        bench.session->choices()->setMoment(true);
        QTRY_VERIFY(bench.moment_microphone.load() != nullptr);
        bench.session->choices()->setMoment(false);
        QVERIFY2(bench.last_said().startsWith("The microphone is off."), qPrintable(bench.last_said()));
    }

    void who_escapes_again_while_a_memo_goes_to_the_disk_is_let_go() {
        CaptureBench bench;
        bench.enter();
        bench.see_for(0.5, {at_the_right});
        bench.session->take();
        bench.settle();
        bench.session->recordMemo();
        bench.hear(1.0);
        QVERIFY(bench.session->stop());
        QVERIFY(!bench.session->stop());
        QVERIFY(bench.session->memo()->running());
        QTRY_VERIFY_WITH_TIMEOUT(bench.last_said().contains("Saved"), 60000);
    }
};

} // namespace capture_shutter_test

TP_TEST(capture_shutter_test, CaptureShutterTest, window)
#include "capture_shutter_test.moc"
