// SPDX-License-Identifier: Apache-2.0
#include "audio/guide/sonar_stream.hpp"
#include "heard_sound.hpp"
#include "test_program.hpp"

#include <QTest>

namespace sonar_stream_test {

using namespace tp;
using namespace tp::testing;

namespace {
constexpr std::size_t ms = sound_rate / 1000;
}

class SonarStreamTest : public QObject {
    Q_OBJECT
private slots:
    void beeps_come_at_the_interval_of_the_distance() {
        for (const double distance : {3.0, 12.0, 30.0}) {
            SonarStream stream;
            const SonarCue cue = sonar_cue(distance, 1.0, 0.0);
            stream.board().write(cue);
            HeardSound sound;
            sound.listen(stream, 3.0);
            const auto begins = HeardSound::onsets(sound.right);
            QVERIFY(begins.size() >= 3);
            QVERIFY(begins.front() < 2 * ms); // the first one at once
            for (std::size_t i = 2; i < begins.size(); ++i) {
                const double interval = static_cast<double>(begins[i] - begins[i - 1]) / sound_rate;
                QVERIFY2(std::abs(interval - cue.interval_s) < 0.0005, qPrintable(QString::number(interval)));
            }
        }
    }

    void a_beep_lasts_fifty_milliseconds_and_has_the_pitch_of_its_direction() {
        SonarStream stream;
        stream.board().write(sonar_cue(20.0, 1.0, 0.0));
        HeardSound sound;
        sound.listen(stream, 1.0);
        const std::size_t begin = HeardSound::onsets(sound.right)[1];
        QVERIFY(std::abs(HeardSound::hertz(sound.right, begin + 2 * ms, begin + 48 * ms) - level_hz) < 5.0);
        QVERIFY(HeardSound::peak({sound.right.begin() + static_cast<std::ptrdiff_t>(begin + 51 * ms),
                                  sound.right.begin() + static_cast<std::ptrdiff_t>(begin + 90 * ms)}) == 0.0);
    }

    void a_line_above_is_heard_to_rise_and_one_below_to_fall() {
        for (const double up : {1.0, -1.0}) {
            SonarStream stream;
            const SonarCue cue = sonar_cue(20.0, 0.0, up);
            stream.board().write(cue);
            HeardSound sound;
            sound.listen(stream, 1.0);
            const std::size_t begin = HeardSound::onsets(sound.left)[1];
            const double first = HeardSound::hertz(sound.left, begin, begin + 20 * ms);
            const double second = HeardSound::hertz(sound.left, begin + 30 * ms, begin + 50 * ms);
            QVERIFY2(up > 0.0 ? second > 1.1 * first : second < first / 1.1,
                     qPrintable(QString("%1 %2").arg(first).arg(second)));
            QVERIFY(std::abs(std::log2(first / cue.from_hz)) < 0.2);
            QVERIFY(std::abs(std::log2(second / cue.to_hz)) < 0.2);
        }
    }

    void left_is_louder_on_the_left_and_reedy() {
        SonarStream stream;
        stream.board().write(sonar_cue(20.0, -1.0, 0.0));
        HeardSound left;
        left.listen(stream, 0.5);
        QVERIFY(HeardSound::peak(left.left) > 0.1);
        QVERIFY(HeardSound::peak(left.right) < 0.3 * HeardSound::peak(left.left));
        QVERIFY(HeardSound::peak(left.right) > 0.1 * HeardSound::peak(left.left)); // for one who hears there
        const double third = HeardSound::energy_at(3.0 * level_hz, left.left, 0, 50 * ms);
        const double first = HeardSound::energy_at(level_hz, left.left, 0, 50 * ms);
        QVERIFY(third > 0.15 * first);

        SonarStream other;
        other.board().write(sonar_cue(20.0, 1.0, 0.0));
        HeardSound right;
        right.listen(other, 0.5);
        QVERIFY(HeardSound::peak(right.left) < 0.3 * HeardSound::peak(right.right));
        QVERIFY(HeardSound::peak(right.left) > 0.1 * HeardSound::peak(right.right));
        QVERIFY(HeardSound::energy_at(3.0 * level_hz, right.right, 0, 50 * ms) <
                0.001 * HeardSound::energy_at(level_hz, right.right, 0, 50 * ms));
    }

    void on_the_line_it_does_not_stop() {
        SonarStream stream;
        stream.board().write(sonar_cue(0.5, 0.0, 1.0));
        HeardSound sound;
        sound.listen(stream, 1.0);
        QCOMPARE(HeardSound::onsets(sound.left).size(), 1u);
        QVERIFY(std::abs(HeardSound::hertz(sound.left, 50 * ms, 950 * ms) - level_hz) < 0.5);
        for (std::size_t from = 50 * ms; from + 5 * ms < sound.left.size(); from += 5 * ms) {
            const double peak = HeardSound::peak({sound.left.begin() + static_cast<std::ptrdiff_t>(from),
                                                  sound.left.begin() + static_cast<std::ptrdiff_t>(from + 5 * ms)});
            QVERIFY(std::abs(peak - line_gain * std::sqrt(0.5)) < 0.002);
        }
    }

    void a_finger_that_comes_nearer_hears_it_before_the_slow_beep_is_over() {
        SonarStream stream;
        stream.board().write(sonar_cue(far_mm, 1.0, 0.0)); // one every 0.8 s
        HeardSound sound;
        sound.listen(stream, 0.2);
        stream.board().write(sonar_cue(2.0, 1.0, 0.0)); // one every 0.1 s: due already
        sound.listen(stream, 0.5);
        const auto begins = HeardSound::onsets(sound.right);
        QVERIFY(begins.size() >= 2);
        QVERIFY(begins[1] <= 201 * ms + 10 * ms);
    }

    void silence_is_silent_within_six_milliseconds_and_without_a_click() {
        for (const double distance : {0.5, 5.0}) {
            SonarStream stream;
            stream.board().write(sonar_cue(distance, 0.0, 1.0));
            HeardSound sound;
            sound.listen(stream, 0.03);
            stream.board().clear();
            sound.listen(stream, 0.5);
            QVERIFY(HeardSound::peak(sound.left) > 0.03);
            QCOMPARE(HeardSound::peak(sound.left, 37 * ms), 0.0);
        }
    }

    void the_next_touch_is_answered_at_once_and_with_its_own_sound() {
        SonarStream stream;
        stream.board().write(sonar_cue(far_mm, 0.0, -1.0));
        HeardSound sound;
        sound.listen(stream, 0.01); // lifted in the middle of a beep
        stream.board().clear();
        sound.listen(stream, 0.02);
        const std::size_t lifted = sound.left.size();
        stream.board().write(sonar_cue(far_mm, 0.0, 1.0));
        sound.listen(stream, 0.1);
        const double hz = HeardSound::hertz(sound.left, lifted, lifted + 25 * ms);
        QVERIFY2(hz > level_hz, qPrintable(QString::number(hz)));
        const auto begins = HeardSound::onsets(sound.left);
        QCOMPARE(begins.size(), 2u);
        QVERIFY(begins[1] < lifted + 2 * ms);
    }

    void nothing_clicks_whatever_the_finger_does() {
        SonarStream stream;
        HeardSound sound;
        for (int i = 0; i < 400; ++i) { // every 10 ms elsewhere, now and then lifted
            if (i % 37 == 36)
                stream.board().clear();
            else
                stream.board().write(sonar_cue((i * 7) % 23 * 0.4, std::sin(i), std::cos(1.7 * i)));
            sound.listen(stream, 0.01);
        }
        // Steeper than a full tone of 3000 Hz at the beeps' peak, together with the tone's, would be a click.
        const double steepest = (beep_gain + line_gain) * 2.0 * std::numbers::pi * 3000.0 / sound_rate;
        for (const auto& samples : {sound.left, sound.right})
            for (std::size_t i = 1; i < samples.size(); ++i)
                QVERIFY(std::abs(samples[i] - samples[i - 1]) < steepest);
        QVERIFY(HeardSound::peak(sound.left) <= beep_gain + line_gain);
    }

    void it_goes_on_in_silence_for_a_while_and_ends() {
        SonarStream stream;
        HeardSound sound;
        sound.listen(stream, 4.9);
        QVERIFY(!stream.ended());
        sound.listen(stream, 0.3);
        QVERIFY(stream.ended());
        QCOMPARE(HeardSound::peak(sound.left), 0.0);
        std::vector<float> more(96);
        QCOMPARE(stream.pull(more), 0u);
    }
};

} // namespace sonar_stream_test

TP_TEST(sonar_stream_test, SonarStreamTest, event_loop)
#include "sonar_stream_test.moc"
