// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/trimming.hpp"
#include "care_bench.hpp"
#include "full_disk.hpp"
#include "test_program.hpp"

#include <QSignalSpy>

#include <cmath>
#include <filesystem>

namespace trimming_test {

using namespace tp;
namespace fs = std::filesystem;

namespace {

struct Bench : TwoRecordings {
    Trimming trimming{cared, recordings, listening, teller};

    Bench() { open("a.jpg"); } // as the page does it, with the part there
    void mark(double begin, double end) {
        trimming.setBegin(begin);
        trimming.setEnd(end);
    }
    bool drawn() {
        return QTest::qWaitFor([this] { return !trimming.peaks().isEmpty(); }, 60'000);
    }
    /// Seconds of what was heard that are not silent.
    double loud_s() const {
        double loud = 0.0;
        for (const float sample : loudspeaker.heard)
            loud += std::abs(sample) > 0.001F ? 1.0 / sound_rate : 0.0;
        return loud;
    }
};

bool near(double value, double expected) { return std::abs(value - expected) < 1e-9; }

} // namespace

class TrimmingTest : public QObject {
    Q_OBJECT
private slots:
    void its_loudness_is_drawn_and_the_ends_are_told_in_seconds() {
        Bench bench;
        Trimming& trimming = bench.trimming;
        bench.recordings.choose(1);
        QVERIFY(trimming.peaks().isEmpty());
        bench.recordings.choose(0);
        QVERIFY(bench.drawn());
        QCOMPARE(trimming.peaks().size(), 400);
        QVERIFY(std::abs(trimming.peaks().at(200) - 0.25F) < 0.01F);
        QCOMPARE(trimming.duration(), 2.0);
        QCOMPARE(trimming.staysText(), QString("All of it stays."));
        trimming.setBegin(0.3);
        QCOMPARE(bench.last_said(), QString("From 0.3 seconds"));
        QVERIFY(trimming.cuts());
        trimming.setEnd(1.2);
        QCOMPARE(bench.last_said(), QString("To 1.2 seconds"));
        QCOMPARE(trimming.beginText() + '|' + trimming.endText(), QString("0.3 seconds|1.2 seconds"));
        QCOMPARE(trimming.staysText(), QString("0.9 seconds of 2.0 seconds stay."));
        trimming.setBegin(0.0);
        QVERIFY(trimming.cuts()); // its end still does
        trimming.whole();
        QVERIFY(!trimming.cuts());
        QCOMPARE(bench.last_said(), QString("All of it stays."));
    }
    void an_end_goes_as_far_as_the_other_lets_it() {
        Bench bench;
        bench.recordings.choose(1); // of 1 s
        Trimming& trimming = bench.trimming;
        trimming.setBegin(5.0);
        QVERIFY(near(trimming.begin(), 0.9));
        trimming.setEnd(-1.0);
        QVERIFY(near(trimming.end(), 1.0));
        trimming.setBegin(-1.0);
        QCOMPARE(trimming.begin(), 0.0);
        trimming.setEnd(0.0);
        QVERIFY(near(trimming.end(), Trimming::shortest_s));
        trimming.setEnd(7.0);
        QCOMPARE(trimming.end(), 1.0);
    }
    void of_one_that_is_shorter_than_the_shortest_part_all_stays() {
        CareParts bench;
        bench.add_sound("a.jpg", 0.05, 300.0);
        Trimming trimming(bench.cared, bench.recordings, bench.listening, bench.teller);
        bench.open();
        trimming.setBegin(0.03);
        trimming.setEnd(0.01);
        QVERIFY(!trimming.cuts());
        QCOMPARE(trimming.begin(), 0.0);
        QCOMPARE(trimming.end(), trimming.duration());
    }
    void the_page_is_told_where_something_changed_and_only_then() {
        Bench bench;
        QSignalSpy changed(&bench.trimming, &Trimming::changed);
        bench.trimming.setBegin(0.5);
        bench.trimming.setEnd(1.5);
        QCOMPARE(changed.size(), 2);
        bench.voice.clear();
        bench.trimming.setBegin(0.5);
        bench.trimming.setEnd(1.5);
        QCOMPARE(changed.size(), 2);
        QVERIFY(bench.voice.said().isEmpty());
        bench.trimming.whole();
        QCOMPARE(changed.size(), 3);
        bench.trimming.whole();
        QCOMPARE(changed.size(), 3);
        QCOMPARE(bench.voice.said().size(), 2); // who asks gets an answer
        QSignalSpy drawn(&bench.trimming, &Trimming::drawn);
        bench.recordings.choose(1);
        QCOMPARE(changed.size(), 4);
        QCOMPARE(drawn.size(), 1); // nothing yet
        QVERIFY(bench.drawn());
        QCOMPARE(drawn.size(), 2);
    }
    void another_one_begins_whole_and_silences_the_one_before() {
        Bench bench;
        bench.mark(0.5, 1.5);
        bench.trimming.playOrStop();
        bench.recordings.choose(1);
        QVERIFY(!bench.trimming.playing());
        QCOMPARE(bench.trimming.duration(), 1.0);
        QVERIFY(!bench.trimming.cuts());
    }
    void what_was_marked_stays_while_the_same_one_is_chosen_or_labelled() {
        Bench bench;
        bench.mark(0.5, 1.5);
        bench.recordings.choose(0); // to hear which one it is
        bench.recordings.setPerson("Anna");
        bench.recordings.move(1);
        QVERIFY(bench.rests());
        QCOMPARE(bench.recordings.chosen(), 1);
        QCOMPARE(bench.trimming.begin(), 0.5);
        QCOMPARE(bench.trimming.end(), 1.5);
    }

    // --- listening ---

    void the_chosen_one_is_played_and_stopped() {
        Bench bench;
        QSignalSpy playing(&bench.trimming, &Trimming::playingChanged),
            moved(&bench.trimming, &Trimming::positionChanged);
        bench.mark(0.5, 1.5);
        bench.trimming.playOrStop(); // all of it
        QVERIFY(bench.trimming.playing());
        QCOMPARE(playing.size(), 1);
        bench.loudspeaker.play(0.3);
        QVERIFY(bench.trimming.position() > 0.2 && bench.trimming.position() < 0.4);
        QVERIFY(moved.size() > 10);
        bench.trimming.playOrStop();
        QVERIFY(!bench.trimming.playing());
        QCOMPARE(playing.size(), 2);
        QCOMPARE(bench.trimming.position(), 0.0);
        bench.trimming.playOrStop();
        bench.trimming.playPartOrStop();
        QVERIFY(!bench.trimming.playing());
    }
    void only_what_stays_is_listened_to() {
        Bench bench;
        bench.mark(0.5, 1.5);
        bench.trimming.playPartOrStop();
        bench.loudspeaker.play(0.3);
        QVERIFY(bench.trimming.position() >= 0.5);
        bench.loudspeaker.play(2.0);
        QVERIFY(!bench.trimming.playing());
        QVERIFY2(bench.loud_s() > 0.9 && bench.loud_s() < 1.2, qPrintable(QString::number(bench.loud_s())));
    }

    // --- cutting ---

    void the_part_stays_and_undo_brings_the_whole_back() {
        Bench bench;
        bench.mark(0.5, 1.25);
        bench.trimming.playOrStop();
        bench.trimming.cut();
        QVERIFY(!bench.trimming.playing());
        QVERIFY(bench.rests());
        QCOMPARE(bench.last_said(), QString("Trimmed: 0.8 seconds stay. Undo brings the rest back."));
        QVERIFY(bench.sounded(Earcon::saved));
        QCOMPARE(bench.recordings.chosen_tag()->duration_s, 0.75);
        QCOMPARE(bench.trimming.duration(), 0.75);
        QVERIFY(!bench.trimming.cuts());
        QVERIFY(bench.drawn());
        bench.history.undo();
        QVERIFY(bench.rests());
        QCOMPARE(bench.last_said(), QString("Undone: the memo was trimmed."));
        QCOMPARE(bench.recordings.chosen_tag()->duration_s, 2.0);
        QCOMPARE(bench.trimming.duration(), 2.0);
    }
    void the_part_is_the_chosen_one_wherever_it_is_listed() {
        Bench bench;
        bench.add_sound("a.jpg", 1.0, 800.0, RecordingKind::memo);
        bench.cared.read_again();
        QVERIFY(bench.rests());
        bench.mark(0.5, 1.25);
        bench.trimming.cut();
        QVERIFY(bench.rests());
        QCOMPARE(bench.recordings.chosen_tag()->duration_s, 0.75);
    }
    void where_all_stays_there_is_nothing_to_cut_off() {
        Bench bench;
        bench.trimming.cut();
        QVERIFY(!bench.steps.busy());
        QCOMPARE(
            bench.last_said(),
            QString("All of it stays, so there is nothing to cut off. Move the start or the end first."));
        QVERIFY(bench.sounded(Earcon::error));
    }
    void on_a_full_disk_the_whole_stays_and_so_do_the_marks() {
        Bench bench;
        bench.mark(0.5, 1.25);
        {
            const FullDisk disk(".tags/");
            bench.trimming.cut();
            QVERIFY(bench.rests());
        }
        QVERIFY2(bench.last_said().endsWith("the disk is full."), qPrintable(bench.last_said()));
        QVERIFY(bench.sounded(Earcon::error));
        QCOMPARE(bench.recordings.chosen_tag()->file, bench.memo);
        QCOMPARE(bench.record().tags.size(), std::size_t{2});
        QCOMPARE(bench.trimming.begin(), 0.5);
        QCOMPARE(bench.trimming.end(), 1.25);
    }
    void one_that_another_program_deleted_costs_a_sentence() {
        Bench bench;
        bench.mark(0.5, 1.25);
        fs::remove(bench.file(bench.memo));
        bench.trimming.playPartOrStop();
        QVERIFY(!bench.trimming.playing());
        QVERIFY2(bench.last_said().contains(QString::fromStdString(bench.memo)),
                 qPrintable(bench.last_said()));
        bench.voice.clear();
        bench.trimming.cut();
        QVERIFY(bench.rests());
        QCOMPARE(bench.voice.said().size(), 1);
        QVERIFY2(!bench.last_said().startsWith("Trimmed"), qPrintable(bench.last_said()));
        QVERIFY(bench.sounded(Earcon::error));
        QVERIFY(bench.trimming.cuts());
    }
    void the_only_one_comes_back_with_its_drawing() {
        CareParts bench;
        bench.add_sound("a.jpg", 2.0, 300.0);
        Trimming trimming(bench.cared, bench.recordings, bench.listening, bench.teller);
        bench.open();
        CARE_TRY_VERIFY(!trimming.peaks().isEmpty());
        bench.recordings.remove();
        QVERIFY(bench.rests());
        QCOMPARE(trimming.duration(), 0.0);
        QVERIFY(trimming.peaks().isEmpty());
        bench.history.undo();
        QVERIFY(bench.rests());
        QCOMPARE(trimming.duration(), 2.0);
        CARE_TRY_VERIFY(!trimming.peaks().isEmpty());
    }
    void where_there_is_none_nothing_plays_and_nothing_is_cut() {
        CareParts bench;
        Trimming trimming(bench.cared, bench.recordings, bench.listening, bench.teller);
        bench.open();
        trimming.setBegin(0.5);
        trimming.setEnd(0.5);
        trimming.playOrStop();
        trimming.playPartOrStop();
        trimming.cut();
        QVERIFY(!trimming.playing() && !trimming.cuts() && !bench.steps.busy());
        QVERIFY(bench.voice.said().isEmpty());
    }
    void a_part_that_is_ready_late_does_not_disturb_the_photograph_that_is_open_then() {
        Bench bench;
        a_photo(bench.folder, "album/b.jpg", 9);
        bench.add_sound("b.jpg", 1.5, 700.0);
        bench.mark(0.5, 1.25);
        {
            SlowDisk disk("a.jpg.tags/");
            bench.trimming.cut();
            CARE_TRY_VERIFY(disk.waits());
            bench.cared.open({bench.photo("b.jpg"), &bench.album->keeper_for(bench.photo("b.jpg"))});
        }
        QVERIFY(bench.rests());
        QCOMPARE(bench.trimming.duration(), 1.5);
        QCOMPARE(bench.record("a.jpg").tags.size(), std::size_t{2});
        QVERIFY(bench.voice.said().join('\n').contains("Trimmed: 0.8 seconds stay."));
    }
};

} // namespace trimming_test

TP_TEST(trimming_test, TrimmingTest, window)
#include "trimming_test.moc"
