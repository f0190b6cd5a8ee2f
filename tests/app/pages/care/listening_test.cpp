// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/listening.hpp"
#include "care_bench.hpp"
#include "test_program.hpp"

#include <QSignalSpy>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace listening_test {

using namespace tp;
namespace fs = std::filesystem;

namespace {

struct Bench : TwoRecordings {
    /// The memo of 2 s.
    void play(double from_s = 0.0, double to_s = 10.0, double gain_db = 0.0) {
        Tag tag = *recordings.chosen_tag();
        tag.gain_db = gain_db;
        listening.play(file(memo), tag, from_s, to_s);
    }
    double loudest() const {
        float loudest = 0.0F;
        for (const float sample : loudspeaker.heard)
            loudest = std::max(loudest, std::abs(sample));
        return loudest;
    }
};

} // namespace

class ListeningTest : public QObject {
    Q_OBJECT
private slots:
    void it_plays_to_its_end_and_tells_the_page() {
        Bench bench;
        QSignalSpy changed(&bench.listening, &Listening::changed), moved(&bench.listening, &Listening::moved);
        QVERIFY(!bench.listening.playing());
        bench.play();
        QVERIFY(bench.listening.playing());
        QCOMPARE(changed.size(), 1);
        QCOMPARE(moved.size(), 1);
        bench.loudspeaker.play(1.0);
        QVERIFY(bench.listening.position() > 0.9 && bench.listening.position() <= 1.0);
        QVERIFY(moved.size() > 50);
        QCOMPARE(changed.size(), 1);
        bench.loudspeaker.play(2.0);
        QVERIFY(!bench.listening.playing());
        QCOMPARE(bench.listening.position(), 0.0);
        QCOMPARE(changed.size(), 2);
        const auto moves = moved.size();
        bench.loudspeaker.play(1.0);
        QCOMPARE(moved.size(), moves);
    }
    void a_part_begins_and_ends_where_it_should() {
        Bench bench;
        bench.play(0.5, 1.5);
        QCOMPARE(bench.listening.position(), 0.5);
        bench.loudspeaker.play(0.9);
        QVERIFY(bench.listening.playing());
        bench.loudspeaker.play(0.2);
        QVERIFY(!bench.listening.playing());
        QCOMPARE(bench.player.state(), Player::State::stopped);
        bench.play(); // the next one ends where it ends
        bench.loudspeaker.play(1.8);
        QVERIFY(bench.listening.playing());
    }
    void it_is_as_loud_as_the_others() {
        Bench bench;
        bench.play(0.0, 10.0, -6.0206); // half as loud as it was recorded
        bench.loudspeaker.play(0.5);
        QVERIFY2(std::abs(bench.loudest() - 0.125) < 0.01, qPrintable(QString::number(bench.loudest())));
    }
    void it_is_stopped_at_once_and_once() {
        Bench bench;
        QSignalSpy changed(&bench.listening, &Listening::changed), moved(&bench.listening, &Listening::moved);
        bench.listening.stop();
        QVERIFY(changed.isEmpty() && moved.isEmpty());
        bench.play();
        bench.loudspeaker.play(0.5);
        const auto moves = moved.size();
        bench.listening.stop();
        QCOMPARE(bench.player.state(), Player::State::stopped);
        QVERIFY(!bench.loudspeaker.playing());
        QCOMPARE(changed.size(), 2);
        QCOMPARE(moved.size(), moves + 1); // it is at 0 now
        QCOMPARE(bench.listening.position(), 0.0);
    }
    void another_takes_over_without_an_end_between() {
        Bench bench;
        bench.play();
        bench.loudspeaker.play(1.0);
        QSignalSpy changed(&bench.listening, &Listening::changed);
        bench.play(0.25);
        QVERIFY(bench.listening.playing() && changed.isEmpty());
        QCOMPARE(bench.listening.position(), 0.25);
    }
    void nobody_talks_over_it() {
        Bench bench;
        const int stops = bench.voice.stops();
        bench.play();
        QCOMPARE(bench.voice.stops(), stops + 1);
    }
    void one_that_another_program_deleted_is_told_and_over() {
        Bench bench;
        fs::remove(bench.file(bench.memo));
        bench.play();
        QVERIFY(!bench.listening.playing());
        QCOMPARE(bench.voice.said().size(), 1);
        QVERIFY2(bench.last_said().contains(QString::fromStdString(bench.memo)),
                 qPrintable(bench.last_said()));
    }
    void without_a_loudspeaker_it_waits_for_one() {
        Bench bench;
        bench.play();
        bench.loudspeaker.play(0.5);
        bench.loudspeaker.vanish();
        QVERIFY2(bench.last_said().startsWith("The loudspeaker is gone."), qPrintable(bench.last_said()));
        QVERIFY(bench.listening.playing());
        bench.loudspeaker.come();
        bench.loudspeaker.play(0.2);
        QVERIFY(bench.listening.position() > 0.6);
        bench.loudspeaker.vanish();
        bench.listening.stop();
        bench.loudspeaker.come();
        QVERIFY(!bench.loudspeaker.playing());
    }
    void what_another_page_plays_is_not_its_own() {
        Bench bench;
        QSignalSpy changed(&bench.listening, &Listening::changed), moved(&bench.listening, &Listening::moved);
        bench.player.set_list({{bench.file(bench.story), RecordingKind::story, {}, 0.0, 0.0},
                               {bench.folder / "nowhere.flac", RecordingKind::story, {}, 0.0, 0.0}});
        bench.player.play();
        bench.loudspeaker.play(0.5);
        QVERIFY(!bench.listening.playing());
        QCOMPARE(bench.listening.position(), 0.0);
        bench.listening.stop();
        QCOMPARE(bench.player.state(), Player::State::playing);
        bench.loudspeaker.play(3.0);
        QCOMPARE(bench.player.state(), Player::State::stopped);
        QVERIFY(changed.isEmpty() && moved.isEmpty());
        QVERIFY(bench.voice.said().isEmpty());
    }
};

} // namespace listening_test

TP_TEST(listening_test, ListeningTest, window)
#include "listening_test.moc"
