// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/earcon_player.hpp"
#include "audio/sound/earcon_synth.hpp"
#include "fake_loudspeaker.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>

namespace earcon_player_test {

using namespace tp;
using namespace tp::testing;

namespace {

struct Bench {
    FakeLoudspeaker loudspeaker;
    EarconPlayer earcons{loudspeaker};
    double peak() const {
        float most = 0.0F;
        for (const float sample : loudspeaker.heard)
            most = std::max(most, std::abs(sample));
        return most;
    }
};

} // namespace

class EarconPlayerTest : public QObject {
    Q_OBJECT
private slots:
    void one_is_heard_as_it_is() {
        Bench bench;
        bench.earcons.play(Earcon::saved);
        bench.loudspeaker.play(0.5);
        const auto sound = samples_of(Earcon::saved);
        QVERIFY(std::equal(sound.begin(), sound.end(), bench.loudspeaker.heard.begin()));
        for (std::size_t i = sound.size(); i < bench.loudspeaker.heard.size(); ++i)
            QCOMPARE(bench.loudspeaker.heard[i], 0.0F);
    }

    void the_loudspeaker_stays_on_for_the_next_and_is_given_back_later() {
        Bench bench;
        bench.earcons.play(Earcon::next);
        bench.loudspeaker.play(2.0);
        bench.earcons.play(Earcon::next);
        bench.loudspeaker.play(1.0);
        QCOMPARE(bench.loudspeaker.runs.size(), 1u);
        bench.loudspeaker.play(6.0);
        QVERIFY(!bench.loudspeaker.playing());
        bench.earcons.play(Earcon::next);
        QCOMPARE(bench.loudspeaker.runs.size(), 2u);
        QVERIFY(bench.loudspeaker.playing());
    }

    void many_at_once_do_not_overflow_and_a_fault_gets_through() {
        Bench bench;
        for (int i = 0; i < 100; ++i)
            bench.earcons.play(Earcon::contour_crossed);
        bench.loudspeaker.play(0.05);
        QVERIFY(bench.peak() <= 4.001 * earcon_peak);
        for (int i = 0; i < 4; ++i)
            bench.earcons.play(Earcon::contour_crossed);
        bench.earcons.play(Earcon::fault);
        bench.loudspeaker.heard.clear();
        bench.loudspeaker.play(0.2);
        QVERIFY(std::abs(bench.loudspeaker.heard[4000]) > 0.0F); // longer than the ticks
    }

    void without_a_loudspeaker_they_are_dropped() {
        Bench bench;
        bench.loudspeaker.there = false;
        bench.earcons.play(Earcon::saved);
        bench.loudspeaker.come();
        bench.loudspeaker.play(0.5);
        QCOMPARE(bench.peak(), 0.0);
        bench.earcons.play(Earcon::saved);
        bench.loudspeaker.play(0.5);
        QVERIFY(bench.peak() > 0.2);
    }

    void switched_off_they_are_silent() {
        Bench bench;
        bench.earcons.set_on(false);
        bench.earcons.play(Earcon::saved);
        QVERIFY(bench.loudspeaker.runs.empty());
    }
};

} // namespace earcon_player_test

TP_TEST(earcon_player_test, EarconPlayerTest, event_loop)
#include "earcon_player_test.moc"
