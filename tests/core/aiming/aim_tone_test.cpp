// SPDX-License-Identifier: Apache-2.0
#include "core/aiming/aim_tone.hpp"
#include "frames.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>

namespace aim_tone_test {

using namespace tp;
using namespace tp::testing;

namespace {

AimTone heard(const AimFrame& frame, HeldCamera camera = {}, bool speaking = false) {
    FaceTracks tracks;
    Adviser adviser(Aim::middle, camera);
    AimFrame next = frame;
    for (int i = 0; i < 15; ++i) {
        next.time_s = 0.1 * i;
        tracks.see(next);
        adviser.advise(tracks.faces(), next);
    }
    return aim_tone(adviser, camera, speaking);
}
AimTone heard(double x, double y, HeldCamera camera = {}, bool speaking = false) {
    return heard(frame_of(0.0, {face_at(x, y)}), camera, speaking);
}

} // namespace

class AimToneTest : public QObject {
    Q_OBJECT
private slots:
    void nobody_is_silence() {
        const AimTone tone = heard(frame_of(0.0, {}));
        QVERIFY(!tone.sounds && !tone.rising);
        QCOMPARE(tone.gain, 1.0);
    }

    void all_is_well_rises() {
        const AimTone tone = heard(0.5, 0.45);
        QVERIFY(tone.sounds && tone.rising);
        QCOMPARE(tone.beats_per_s, 0.0);
        QCOMPARE(tone.side, 0.0);
    }

    void on_its_place_but_not_well_is_steady() {
        const AimTone tone = heard(frame_of(0.0, {face_at(0.5, 0.45, 0.1)}));
        QVERIFY(tone.sounds && !tone.rising);
        QCOMPARE(tone.beats_per_s, 0.0);
        QCOMPARE(tone.pitch_octaves, 0.0);
    }

    /// No way leads from there to its place.
    void one_over_both_edges_in_the_middle_is_steady() {
        AimFace face;
        face.box = {{-0.25, 0.25}, {1.25, 0.65}};
        const AimTone tone = heard(frame_of(0.0, {face}));
        QVERIFY(tone.sounds);
        QCOMPARE(tone.beats_per_s, 0.0);
        QCOMPARE(tone.side, 0.0);
    }

    void the_way_is_side_and_pitch() {
        QVERIFY(heard(0.9, 0.45).side > 0.99);
        QVERIFY(heard(0.1, 0.45).side < -0.99);
        QVERIFY(std::abs(heard(0.5, 0.1).pitch_octaves - 0.5) < 0.01);
        QVERIFY(std::abs(heard(0.5, 0.8).pitch_octaves + 0.5) < 0.01);
        const AimTone both = heard(0.7, 0.21); // twice either tolerance
        QVERIFY(std::abs(both.side - std::sqrt(0.5)) < 0.01);
        QVERIFY(std::abs(both.pitch_octaves - 0.5 * std::sqrt(0.5)) < 0.01);
    }

    void a_front_camera_sounds_on_the_persons_side() {
        QVERIFY(heard(0.9, 0.45, {true, false}).side < -0.99);
        QVERIFY(heard(0.9, 0.45, {true, true}).side > 0.99);
        QVERIFY(heard(0.5, 0.1, {true, false}).pitch_octaves > 0.0);
    }

    void nearer_is_faster() {
        double before = 0.0;
        for (const double x : {0.95, 0.85, 0.75, 0.65}) {
            const double rate = heard(x, 0.45).beats_per_s;
            QVERIFY(rate > before);
            QVERIFY(rate >= 1.25 - 1e-9 && rate <= 10.0 + 1e-9);
            before = rate;
        }
        QVERIFY(std::abs(heard(1.05, 0.45).beats_per_s - 1.25) < 1e-9); // no slower
        // Halfway between the tolerance and far off, the time between beats is halfway too.
        QVERIFY(std::abs(1.0 / heard(0.8, 0.45).beats_per_s - 0.45) < 1e-3);
    }

    void words_are_heard_over_it() {
        QCOMPARE(heard(0.9, 0.45, {}, true).gain, 0.35);
        QCOMPARE(heard(0.9, 0.45).gain, 1.0);
    }
};

} // namespace aim_tone_test

TP_TEST(aim_tone_test, AimToneTest, nothing)
#include "aim_tone_test.moc"
