// SPDX-License-Identifier: Apache-2.0
// What is felt while one aims, in the time of the frames.
#include "app/pages/capture/aim_pulses.hpp"
#include "test_program.hpp"

#include <QTest>

#include <optional>
#include <vector>

namespace aim_pulses_test {

using namespace tp;

namespace {

constexpr double frame_s = 1.0 / 30.0;

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
};

} // namespace aim_pulses_test

TP_TEST(aim_pulses_test, AimPulsesTest, event_loop)
#include "aim_pulses_test.moc"
