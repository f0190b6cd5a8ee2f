// SPDX-License-Identifier: Apache-2.0
#include "audio/guide/sonified_guide.hpp"
#include "fake_loudspeaker.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>

namespace sonified_guide_test {

using namespace tp;
using namespace tp::testing;

namespace {

struct Bench {
    FakeLoudspeaker loudspeaker;
    SonifiedGuide guide{loudspeaker};

    double peak_of(double seconds) {
        loudspeaker.heard.clear();
        loudspeaker.play(seconds);
        float most = 0.0F;
        for (const float sample : loudspeaker.heard)
            most = std::max(most, std::abs(sample));
        return most;
    }
};

const SonarCue near_cue = sonar_cue(3.0, 0.0, 1.0);

} // namespace

class SonifiedGuideTest : public QObject {
    Q_OBJECT
private slots:
    void what_is_asked_for_is_heard_until_silence() {
        Bench bench;
        QVERIFY(!bench.guide.sounds());
        QVERIFY(bench.loudspeaker.runs.empty());
        bench.guide.sound(near_cue);
        QVERIFY(bench.guide.sounds());
        QVERIFY(bench.peak_of(0.3) > 0.1);
        bench.guide.silence();
        QVERIFY(!bench.guide.sounds());
        bench.peak_of(0.02);
        QCOMPARE(bench.peak_of(1.0), 0.0);
    }

    void the_loudspeaker_stays_on_for_the_next_touch_and_is_given_back_later() {
        Bench bench;
        bench.guide.sound(near_cue);
        bench.loudspeaker.play(0.2);
        bench.guide.silence();
        bench.loudspeaker.play(3.0);
        bench.guide.sound(near_cue);
        QVERIFY(bench.peak_of(0.2) > 0.1);
        QCOMPARE(bench.loudspeaker.runs.size(), 1u);
        bench.guide.silence();
        bench.loudspeaker.play(6.0);
        QVERIFY(!bench.loudspeaker.playing());
        bench.guide.sound(near_cue);
        QCOMPARE(bench.loudspeaker.runs.size(), 2u);
        QVERIFY(bench.peak_of(0.2) > 0.1);
    }

    void without_a_loudspeaker_it_is_not_asked_for_again_with_every_movement() {
        Bench bench;
        bench.loudspeaker.there = false;
        for (int i = 0; i < 100; ++i)
            bench.guide.sound(near_cue);
        QCOMPARE(bench.loudspeaker.runs.size(), 1u);
        bench.loudspeaker.come();
        bench.guide.sound(near_cue);
        QCOMPARE(bench.loudspeaker.runs.size(), 2u);
        QVERIFY(bench.peak_of(0.2) > 0.1);
    }

    void another_loudspeaker_goes_on() {
        Bench bench;
        bench.guide.sound(near_cue);
        bench.loudspeaker.play(0.1);
        bench.loudspeaker.move();
        bench.guide.sound(near_cue);
        QVERIFY(bench.peak_of(0.2) > 0.1);
    }
};

} // namespace sonified_guide_test

TP_TEST(sonified_guide_test, SonifiedGuideTest, event_loop)
#include "sonified_guide_test.moc"
