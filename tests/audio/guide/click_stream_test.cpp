// SPDX-License-Identifier: Apache-2.0
#include "audio/guide/click_stream.hpp"
#include "heard_sound.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace click_stream_test {

using namespace tp;
using tp::testing::HeardSound;

namespace {

/// A loudspeaker that asks for blocks of another size each time, and now and then late.
struct Ear {
    double time = 100.0; ///< s
    std::shared_ptr<ClickList> list = std::make_shared<ClickList>();
    ClickStream stream{list, [this] { return time + late; }};
    double late = 0.0;
    std::vector<float> heard; ///< left
    std::mt19937 random{3};

    void pull(std::size_t frames) {
        std::vector<float> block(frames * played_channels);
        QCOMPARE(stream.pull(block), block.size());
        for (std::size_t i = 0; i < frames; ++i)
            heard.push_back(block[played_channels * i]);
        time += static_cast<double>(frames) / sound_rate;
    }
    void listen(double seconds) {
        std::uniform_int_distribution<std::size_t> size(64, 700);
        std::uniform_real_distribution<double> lateness(0.0, 0.008);
        for (const double end = time + seconds; time < end;) {
            late = heard.empty() ? 0.0 : lateness(random);
            pull(size(random));
        }
    }
    double energy() const {
        double sum = 0.0;
        for (const float sample : heard)
            sum += static_cast<double>(sample) * sample / sound_rate;
        return sum;
    }
    /// Where something sounds first and last.
    std::pair<std::size_t, std::size_t> ends() const {
        std::size_t first = heard.size(), last = 0;
        for (std::size_t i = 0; i < heard.size(); ++i)
            if (heard[i] != 0.0F) {
                first = std::min(first, i);
                last = i;
            }
        return {first, last};
    }
};

} // namespace

class ClickStreamTest : public QObject {
    Q_OBJECT
private slots:
    void clicks_are_as_far_apart_as_their_times_to_the_sample() {
        Ear ear;
        ear.listen(0.1);
        std::vector<double> times;
        std::mt19937 random(9);
        std::uniform_real_distribution<double> gap(0.015, 0.06);
        double time = ear.time;
        std::vector<std::size_t> places;
        for (int i = 0; i < 200; ++i) {
            time += gap(random);
            while (ear.time + 0.004 < time)
                ear.pull(96);
            QVERIFY(ear.list->push({time, 1.0, 0.5, 0.004}));
            places.push_back(
                static_cast<std::size_t>(std::llround((time + click_ahead_s - 100.0) * sound_rate)));
        }
        ear.listen(0.2);
        for (const std::size_t place : places) {
            QVERIFY(ear.heard[place] == 0.0F);
            QVERIFY(ear.heard[place + 2] > 0.0F);
            QVERIFY(place == 0 || ear.heard[place - 1] == 0.0F);
        }
    }

    void a_late_call_moves_no_click() {
        Ear ear;
        ear.listen(0.5);
        QVERIFY(ear.list->push({ear.time, 1.0, 0.5, 0.004}));
        const auto place =
            static_cast<std::size_t>(std::llround((ear.time + click_ahead_s - 100.0) * sound_rate));
        ear.listen(0.1);
        QCOMPARE(ear.ends().first, place + 1); // its first sample is zero
    }

    void one_that_comes_too_late_is_heard_at_once() {
        Ear ear;
        ear.pull(4800);
        QVERIFY(ear.list->push({ear.time - 1.0, 1.0, 0.5, 0.004}));
        ear.pull(4800);
        QCOMPARE(ear.ends().first, std::size_t(4801));
    }

    void sharpness_is_pitch_data() {
        QTest::addColumn<double>("sharpness");
        QTest::addColumn<double>("hz");
        QTest::newRow("dull") << 0.0 << 300.0;
        QTest::newRow("between") << 0.5 << 948.7;
        QTest::newRow("sharp") << 1.0 << 3000.0;
        QTest::newRow("beyond") << 7.0 << 3000.0;
    }
    void sharpness_is_pitch() {
        QFETCH(double, sharpness);
        QFETCH(double, hz);
        Ear ear;
        QVERIFY(ear.list->push({ear.time, 1.0, sharpness, 0.05}));
        ear.pull(sound_rate / 5);
        const auto [first, last] = ear.ends();
        QVERIFY(std::abs(HeardSound::hertz(ear.heard, first, last) / hz - 1.0) < 0.01);
    }

    void amplitude_is_loudness_and_bounded() {
        const auto peak_of = [](double amplitude) {
            Ear ear;
            ear.list->push({ear.time, amplitude, 1.0, 0.02});
            ear.pull(sound_rate / 5);
            return HeardSound::peak(ear.heard);
        };
        QVERIFY(std::abs(peak_of(1.0) - loudest_click) < 0.01);
        QVERIFY(std::abs(peak_of(0.5) - 0.5 * loudest_click) < 0.005);
        QCOMPARE(peak_of(100.0), peak_of(1.0));
        QCOMPARE(peak_of(-1.0), 0.0);
    }

    void a_click_has_bounded_energy_and_ends() {
        for (const double seconds : {0.0, 0.008, 0.05, 10.0}) {
            Ear ear;
            ear.list->push({ear.time, 1.0, 0.3, seconds});
            ear.pull(sound_rate / 2);
            const auto [first, last] = ear.ends();
            const double lasts = static_cast<double>(last - first) / sound_rate;
            QVERIFY(lasts <= longest_click_s && lasts >= 0.9 * shortest_click_s);
            QVERIFY(ear.energy() > 0.0);
            QVERIFY(ear.energy() < 0.5 * loudest_click * loudest_click * longest_click_s);
        }
    }

    void a_new_one_takes_the_place_of_one_under_way() {
        Ear ear;
        ear.list->push({ear.time, 1.0, 0.0, 0.05});
        ear.list->push({ear.time + 0.01, 0.1, 0.0, 0.05});
        ear.pull(sound_rate / 5);
        const auto second = static_cast<std::size_t>(std::llround((0.01 + click_ahead_s) * sound_rate));
        QVERIFY(HeardSound::peak(ear.heard, second) < 0.11 * loudest_click);
        QVERIFY(HeardSound::peak(ear.heard) > 0.11 * loudest_click);
    }

    void hushed_ones_are_not_heard_and_later_ones_are() {
        Ear ear;
        ear.list->push({ear.time, 1.0, 0.5, 0.05});
        ear.list->hush();
        ear.pull(sound_rate / 10);
        QCOMPARE(HeardSound::peak(ear.heard), 0.0);
        ear.list->push({ear.time, 1.0, 0.5, 0.05});
        ear.pull(sound_rate / 10);
        QVERIFY(HeardSound::peak(ear.heard) > 0.1);
    }

    void a_list_that_nobody_takes_from_is_full() {
        ClickList list;
        for (std::uint64_t i = 0; i < ClickList::room; ++i)
            QVERIFY(list.push({static_cast<double>(i), 1.0, 1.0, 0.01}));
        QVERIFY(!list.push({}));
        Click click;
        QVERIFY(list.take(click));
        QCOMPARE(click.time, 0.0);
        QVERIFY(list.push({}));
    }
};

} // namespace click_stream_test

TP_TEST(click_stream_test, ClickStreamTest, nothing)
#include "click_stream_test.moc"
