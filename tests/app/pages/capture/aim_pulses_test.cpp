// SPDX-License-Identifier: Apache-2.0
// What is felt while one aims, in the time of the frames, by a motor that remembers.
#include "app/pages/capture/aim_pulses.hpp"
#include "capture_bench.hpp"

#include <algorithm>
#include <vector>

using namespace tp;

namespace {

constexpr double frame_s = 1.0 / 30.0;
const Vec2 middle{0.5, 0.45};

AimTone beats(double per_s) {
    AimTone tone;
    tone.sounds = true;
    tone.beats_per_s = per_s;
    return tone;
}

AimTone well() {
    AimTone tone = beats(0.0);
    tone.rising = true;
    return tone;
}

/// The pulses of a tone that sounds for ten seconds.
std::vector<double> felt(AimPulses& pulses, const AimTone& tone, double from_s = 0.0) {
    std::vector<double> strengths;
    for (int frame = 0; frame < 300; ++frame)
        if (const auto strength = pulses.due(tone, from_s + frame_s * frame))
            strengths.push_back(*strength);
    return strengths;
}

} // namespace

class AimPulsesTest : public QObject {
    Q_OBJECT
private slots:
    void the_nearer_the_faster_and_the_stronger() {
        std::size_t pulses = 0;
        double strength = 0.0;
        for (const double per_s : {slowest_beats, 2.0, 4.0, fastest_beats}) {
            AimPulses one;
            const std::vector<double> here = felt(one, beats(per_s));
            QVERIFY(here.size() > pulses && here.front() > strength);
            QVERIFY(static_cast<double>(here.size()) <= 10.0 * per_s + 1.0);
            pulses = here.size();
            strength = here.front();
        }
        QCOMPARE(strength, nearest_pulse);
        QVERIFY(pulses > 70);
    }

    void all_is_well_is_one_firm_pulse_and_stillness() {
        AimPulses pulses;
        QCOMPARE(felt(pulses, well()), std::vector<double>{well_pulse});
        felt(pulses, beats(4.0), 10.0);
        QCOMPARE(felt(pulses, well(), 20.0), std::vector<double>{well_pulse});
    }

    void where_nobody_is_seen_and_at_the_place_nothing_is_felt() {
        AimPulses pulses;
        QVERIFY(felt(pulses, AimTone{}).empty());
        QVERIFY(felt(pulses, beats(0.0)).empty());
        QVERIFY(felt(pulses, well()).size() == 1);
        felt(pulses, AimTone{}, 10.0);
        QVERIFY(felt(pulses, well(), 20.0).size() == 1); // somebody came back
    }

    void a_hand_that_comes_nearer_feels_it_and_the_page_ends_it() {
        CaptureBench bench;
        bench.session->choices()->setByItself(false);
        bench.enter();
        std::size_t before = 0;
        for (const double x : {0.95, 0.75, 0.66}) {
            bench.see_for(0.5, {{x, middle.y}});
            bench.vibration.pulses.clear();
            bench.see_for(4.0, {{x, middle.y}});
            const std::vector<double>& pulses = bench.vibration.pulses;
            QVERIFY2(pulses.size() > before,
                     qPrintable(QString("%1 after %2").arg(pulses.size()).arg(before)));
            QVERIFY(*std::max_element(pulses.begin(), pulses.end()) < well_pulse);
            before = pulses.size();
        }
        bench.see_for(2.0, {middle});
        QCOMPARE(bench.vibration.pulses.back(), well_pulse);
        bench.vibration.pulses.clear();
        bench.see_for(2.0, {middle});
        QVERIFY(bench.vibration.pulses.empty());
        bench.see_for(0.5, {{0.75, middle.y}});
        QVERIFY(!bench.vibration.pulses.empty());
        const int stops = bench.vibration.stops;
        bench.session->leave();
        QCOMPARE(bench.vibration.stops, stops + 1);
    }

    void whoever_wants_no_beeps_feels_none_and_escape_ends_them() {
        Choices choices = CaptureBench::told();
        choices.guide = Choices::Guide::clock_voice;
        CaptureBench none(choices);
        none.enter();
        none.see_for(2.0, {{0.75, middle.y}});
        QVERIFY(none.vibration.pulses.empty());
        CaptureBench bench;
        bench.enter();
        bench.see_for(1.0, {{0.75, middle.y}});
        QVERIFY(!bench.vibration.pulses.empty());
        bench.session->stop();
        bench.vibration.pulses.clear();
        bench.see_for(1.0, {{0.75, middle.y}});
        QVERIFY(bench.vibration.pulses.empty());
    }
};

QTEST_GUILESS_MAIN(AimPulsesTest)
#include "aim_pulses_test.moc"
