// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/player.hpp"
#include "audio/sound/sound_format.hpp"
#include "fake_loudspeaker.hpp"
#include "inline_filler.hpp"
#include "sound_files.hpp"
#include "test_program.hpp"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <filesystem>

namespace player_test {

using namespace tp;
using namespace tp::testing;
using State = Player::State;

namespace {

bool near(double a, double b, double tolerance = 0.02) { return std::abs(a - b) <= tolerance; }

/// A player whose time a test moves; three recordings of 4, 5 and 6 s whose tones tell them apart.
struct Bench {
    QTemporaryDir folder;
    FakeLoudspeaker loudspeaker;
    InlineFiller filler;
    Player player{loudspeaker, filler};
    QSignalSpy began{&player, &Player::began};
    QSignalSpy ended{&player, &Player::ended};
    QSignalSpy gaps{&player, &Player::gap};
    QSignalSpy left{&player, &Player::left};
    QSignalSpy list_ends{&player, &Player::list_end};
    QSignalSpy said{&player, &Player::said};
    QSignalSpy sounding{&player, &Player::sounding_changed};

    explicit Bench(int count = 3) {
        std::vector<PlayItem> list;
        for (int i = 0; i < count; ++i)
            list.push_back(item(std::to_string(i) + ".wav", tone(hz(i), 4.0 + i, sound_rate)));
        player.set_list(std::move(list));
    }
    static double hz(int i) { return 300.0 + 200.0 * i; }
    PlayItem item(const std::string& name, const std::vector<float>& samples, int rate = sound_rate) {
        PlayItem result;
        result.file = std::filesystem::path(folder.path().toStdString()) / name;
        write_wav(result.file, samples, rate);
        return result;
    }
    void pass(double seconds) {
        for (auto steps = static_cast<int>(seconds * 10.0 + 0.5); steps > 0; --steps) {
            filler.fill();
            loudspeaker.play(0.1);
        }
    }
    /// The tone that was heard in the last so many seconds.
    double heard_hz(double seconds) const {
        const auto count = static_cast<std::ptrdiff_t>(seconds * sound_rate);
        return frequency_of({loudspeaker.heard.end() - count, loudspeaker.heard.end()}, sound_rate);
    }
    double last_left() const { return left.last().at(1).toDouble(); }
};

} // namespace

class PlayerTest : public QObject {
    Q_OBJECT
private slots:
    void plays_one_after_the_other_with_a_silence_between() {
        Bench bench;
        bench.player.play();
        bench.pass(2.0);
        QCOMPARE(bench.player.state(), State::playing);
        QVERIFY(bench.player.sounding());
        QVERIFY(near(bench.player.position_s(), 2.0));
        QVERIFY(near(bench.player.duration_s(), 4.0));
        QVERIFY(near(bench.heard_hz(1.0), 300.0, 1.0));
        bench.pass(2.3);
        QCOMPARE(bench.ended.size(), 1);
        QCOMPARE(bench.gaps.size(), 1);
        QCOMPARE(bench.gaps.last().at(0).value<std::size_t>(), 1u);
        QVERIFY(!bench.player.sounding());
        bench.pass(2.0);
        QVERIFY(bench.player.sounding());
        QCOMPARE(bench.player.current(), 1u);
        QVERIFY(near(bench.heard_hz(1.0), 500.0, 1.0));
        bench.pass(12.0);
        QCOMPARE(bench.began.size(), 3);
        QCOMPARE(bench.ended.size(), 3);
        QCOMPARE(bench.list_ends.size(), 1);
        QCOMPARE(bench.player.state(), State::stopped);
        QCOMPARE(bench.sounding.size(), 6);
        QVERIFY(!bench.loudspeaker.playing());
    }

    void every_sample_is_heard_once() {
        Bench bench(1);
        bench.player.play();
        bench.pass(5.0);
        const std::vector<float> source = tone(300.0, 4.0, sound_rate);
        QVERIFY(bench.loudspeaker.heard.size() >= source.size());
        for (std::size_t i = 0; i < source.size(); ++i)
            QVERIFY(std::abs(bench.loudspeaker.heard[i] - source[i]) < 1e-4F);
    }

    void goes_on_where_it_was_paused_and_counts_only_what_was_heard() {
        Bench bench(1);
        bench.loudspeaker.late_frames = sound_rate / 5;
        bench.player.play();
        bench.pass(1.5);
        QVERIFY(near(bench.player.position_s(), 1.3));
        bench.player.pause();
        QCOMPARE(bench.player.state(), State::paused);
        QVERIFY(!bench.loudspeaker.playing());
        QVERIFY(near(bench.last_left(), 1.3));
        bench.pass(3.0);
        bench.player.play();
        bench.pass(1.0);
        QVERIFY(near(bench.player.position_s(), 2.1));
        bench.pass(2.5);
        QCOMPARE(bench.ended.size(), 1);
    }

    void a_speed_changes_the_time_and_not_the_pitch_data() {
        QTest::addColumn<double>("speed");
        QTest::newRow("half") << 0.5;
        QTest::newRow("three halves") << 1.5;
        QTest::newRow("double") << 2.0;
    }

    void a_speed_changes_the_time_and_not_the_pitch() {
        QFETCH(double, speed);
        Bench bench(1);
        bench.player.play();
        bench.pass(1.0);
        bench.player.set_speed(speed);
        QVERIFY(near(bench.player.position_s(), 1.0));
        bench.pass(1.0);
        QVERIFY(near(bench.player.position_s(), 1.0 + speed));
        QVERIFY(near(bench.heard_hz(0.6), 300.0, 3.0));
        bench.pass(3.0 / speed - 1.0 - 0.2);
        QCOMPARE(bench.ended.size(), 0);
        bench.pass(0.4);
        QCOMPARE(bench.ended.size(), 1);
    }

    void an_absurd_speed_is_limited() {
        Bench bench(1);
        bench.player.set_speed(50.0);
        QCOMPARE(bench.player.speed(), 2.0);
        bench.player.set_speed(0.0);
        QCOMPARE(bench.player.speed(), 0.5);
    }

    void next_previous_and_their_ends() {
        Bench bench;
        bench.player.play();
        bench.pass(1.0);
        bench.player.next();
        bench.pass(1.0);
        QCOMPARE(bench.player.current(), 1u);
        QVERIFY(near(bench.last_left(), 1.0)); // the first was left there
        bench.player.previous();
        QCOMPARE(bench.player.current(), 0u);
        bench.pass(3.5);
        bench.player.previous(); // far in: to its beginning
        QCOMPARE(bench.player.current(), 0u);
        QVERIFY(near(bench.player.position_s(), 0.0));
        QCOMPARE(bench.list_ends.size(), 0);
        bench.player.previous();
        QCOMPARE(bench.list_ends.size(), 1);
        QCOMPARE(bench.player.state(), State::playing);
        bench.player.play_at(2);
        bench.pass(1.0);
        QVERIFY(near(bench.heard_hz(0.5), 700.0, 1.0));
        bench.player.next();
        QCOMPARE(bench.list_ends.size(), 2);
        QCOMPARE(bench.player.current(), 2u);
        QCOMPARE(bench.player.state(), State::playing);
    }

    void resumes_where_it_was_left_another_time() {
        Bench bench(2);
        std::vector<PlayItem> list = bench.player.list();
        list[0].resume_at_s = 2.5;
        list[1].resume_at_s = 99.0; // behind its end: the file is a shorter one now
        bench.player.set_list(list);
        bench.player.play();
        bench.pass(0.5);
        QVERIFY(near(bench.player.position_s(), 3.0));
        bench.player.stop();
        QCOMPARE(bench.player.state(), State::stopped);
        QCOMPARE(bench.last_left(), 0.0); // its last seconds are not worth coming back for
        bench.player.play_at(1);
        bench.pass(0.5);
        QCOMPARE(bench.ended.size(), 1);
    }

    void a_loudspeaker_that_goes_is_waited_for() {
        Bench bench(1);
        bench.player.play();
        bench.pass(1.5);
        bench.loudspeaker.vanish();
        QCOMPARE(bench.player.state(), State::waiting);
        QVERIFY(!bench.player.sounding());
        QCOMPARE(bench.said.size(), 1);
        bench.pass(1.0);
        bench.loudspeaker.come();
        bench.pass(1.0);
        QCOMPARE(bench.player.state(), State::playing);
        QVERIFY(near(bench.player.position_s(), 2.5));
    }

    void without_a_loudspeaker_it_says_so_and_waits() {
        Bench bench(1);
        bench.loudspeaker.there = false;
        bench.player.play();
        QCOMPARE(bench.player.state(), State::waiting);
        QCOMPARE(bench.said.size(), 1);
        bench.player.play(); // tries again
        QCOMPARE(bench.player.state(), State::waiting);
        bench.player.pause();
        bench.loudspeaker.come();
        QCOMPARE(bench.player.state(), State::paused); // not wanted any more
    }

    void follows_the_system_to_another_loudspeaker_without_a_word() {
        Bench bench(1);
        bench.player.play();
        bench.pass(1.0);
        bench.loudspeaker.move();
        bench.pass(1.0);
        QVERIFY(near(bench.player.position_s(), 2.0));
        QVERIFY(bench.said.isEmpty());
        QCOMPARE(bench.loudspeaker.runs.size(), 2u);
    }

    void a_recording_that_cannot_be_read_costs_a_sentence() {
        Bench bench(3);
        std::filesystem::resize_file(bench.player.list()[0].file, 20);
        std::filesystem::remove(bench.player.list()[1].file);
        bench.player.play();
        QCOMPARE(bench.said.size(), 2);
        for (const auto& sentence : bench.said)
            QVERIFY(sentence.at(0).toString().startsWith("The") && sentence.at(0).toString().endsWith("."));
        QCOMPARE(bench.player.current(), 2u);
        bench.pass(1.0);
        QVERIFY(bench.player.sounding());
        QCOMPARE(bench.began.size(), 1);
    }

    void a_list_of_nothing_readable_ends() {
        Bench bench(2);
        for (const PlayItem& item : bench.player.list())
            std::filesystem::remove(item.file);
        bench.player.play();
        QCOMPARE(bench.player.state(), State::stopped);
        QCOMPARE(bench.said.size(), 2);
        QCOMPARE(bench.list_ends.size(), 1);
        QVERIFY(bench.began.isEmpty());
    }

    void an_empty_list_is_at_its_end() {
        Bench bench(0);
        bench.player.play();
        bench.player.next();
        bench.player.previous();
        bench.player.pause();
        QCOMPARE(bench.list_ends.size(), 3);
        QCOMPARE(bench.player.state(), State::stopped);
    }

    void the_gap_can_be_held_for_something_to_be_said() {
        Bench bench(2);
        connect(&bench.player, &Player::gap, &bench.player, &Player::pause);
        bench.player.play();
        bench.pass(8.0);
        QCOMPARE(bench.player.state(), State::paused);
        QCOMPARE(bench.player.current(), 1u);
        bench.player.play();
        bench.pass(1.0);
        QVERIFY(near(bench.player.position_s(), 1.0));
    }

    void a_slow_disk_is_heard_as_silence_and_nothing_is_lost() {
        Bench bench(1);
        bench.player.play();
        bench.pass(0.5);
        bench.filler.asleep = true;
        bench.pass(4.0);
        QVERIFY(bench.player.position_s() < 3.0);
        QCOMPARE(bench.ended.size(), 0);
        bench.filler.asleep = false;
        bench.pass(3.0);
        QCOMPARE(bench.ended.size(), 1);
    }

    void a_gain_is_applied_and_never_overflows() {
        Bench bench(0);
        PlayItem quiet = bench.item("quiet.wav", tone(440.0, 1.0, sound_rate, 0.1));
        quiet.gain_db = 6.0206;
        PlayItem loud = bench.item("loud.wav", tone(440.0, 1.0, sound_rate, 0.9));
        loud.gain_db = 20.0;
        bench.player.set_list({quiet, loud});
        bench.player.play();
        bench.pass(0.9);
        QVERIFY(near(*std::ranges::max_element(bench.loudspeaker.heard), 0.2, 0.001));
        bench.pass(2.0);
        QCOMPARE(*std::ranges::max_element(bench.loudspeaker.heard), 1.0F);
    }

    void other_rates_are_brought_to_the_loudspeakers() {
        Bench bench(0);
        bench.player.set_list({bench.item("old.wav", tone(440.0, 2.0, 8000), 8000)});
        bench.player.play();
        bench.pass(1.0);
        QVERIFY(near(bench.player.duration_s(), 2.0));
        QVERIFY(near(bench.heard_hz(0.5), 440.0, 4.4));
        bench.pass(1.2);
        QCOMPARE(bench.ended.size(), 1);
    }

    void the_order_is_memo_person_place_story_ambient_unless_re_ordered() {
        std::vector<PlayItem> items;
        const auto add = [&](const char* name, RecordingKind kind, std::optional<int> place = {}) {
            items.push_back({name, kind, place});
        };
        add("a", RecordingKind::ambient);
        add("s", RecordingKind::story);
        add("m1", RecordingKind::memo);
        add("pl", RecordingKind::place);
        add("m2", RecordingKind::memo);
        add("pe", RecordingKind::person);
        const auto names = [](const std::vector<PlayItem>& list) {
            QStringList result;
            for (const PlayItem& item : list)
                result << QString::fromStdString(item.file.string());
            return result.join(' ');
        };
        QCOMPARE(names(playback_order(items)), QString("m1 m2 pe pl s a"));
        items[0].place = 2;
        items[1].place = 1;
        QCOMPARE(names(playback_order(items)), QString("s a m1 m2 pe pl"));
        QVERIFY(playback_order({}).empty());
    }
};

} // namespace player_test

TP_TEST(player_test, PlayerTest, event_loop)
#include "player_test.moc"
