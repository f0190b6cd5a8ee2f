// SPDX-License-Identifier: Apache-2.0
// The bars of guided aiming, over many simulated people in virtual time.
#include "core/handheld/aim_trial.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cstdint>
#include <optional>
#include <vector>

namespace aim_trial_test {

using namespace tp;

namespace {

std::vector<AimTrialResult> results_of(AimTrial trial, std::uint64_t people, std::uint64_t first = 1) {
    std::vector<AimTrialResult> results;
    for (std::uint64_t i = 0; i < people; ++i) {
        trial.seed = first + i;
        results.push_back(run_trial(trial));
    }
    return results;
}

AimShares shares(AimGuidance guidance, Aim aim = Aim::middle, HeldCamera camera = {},
                 std::uint64_t people = 500) {
    AimTrial trial;
    trial.guidance = guidance;
    trial.aim = aim;
    trial.camera = camera;
    return shares_of(results_of(trial, people));
}

} // namespace

class AimTrialTest : public QObject {
    Q_OBJECT
private slots:
    void words_and_tone_lead_nearly_everybody_there() {
        const AimShares both = shares(AimGuidance::words_and_tone);
        QVERIFY(both.within_15_s >= 0.95);
        QVERIFY(both.median_s && *both.median_s <= 6.0);
        QVERIFY(both.missed_pictures < 0.05);
    }

    void each_guidance_is_worth_something() {
        const AimShares both = shares(AimGuidance::words_and_tone);
        const AimShares words = shares(AimGuidance::words);
        const AimShares tone = shares(AimGuidance::tone);
        const AimShares none = shares(AimGuidance::none);
        QVERIFY(both.within_15_s > words.within_15_s);
        QVERIFY(words.within_15_s > tone.within_15_s);
        QVERIFY(tone.within_15_s > none.within_15_s);
        QVERIFY(none.sentences == 0.0 && tone.sentences == 0.0 && both.sentences > 1.0);
        QVERIFY(both.sentences < words.sentences);
    }

    void every_way_to_hold_a_camera_leads_there() {
        for (const bool front : {false, true})
            for (const bool mirrored : {false, true})
                QVERIFY(shares(AimGuidance::words_and_tone, Aim::middle, {front, mirrored}, 120).within_15_s >
                        0.9);
    }

    void every_aim_leads_there() {
        for (const Aim aim : {Aim::thirds, Aim::everybody})
            QVERIFY(shares(AimGuidance::words_and_tone, aim, {}, 120).within_15_s > 0.9);
        QVERIFY(shares(AimGuidance::words_and_tone, Aim::head_and_shoulders, {}, 120).within_20_s > 0.9);
    }

    void a_seed_is_one_person() {
        AimTrial trial;
        const AimStart start = start_of(trial);
        for (const AimGuidance guidance : all_guidance) {
            trial.guidance = guidance;
            QCOMPARE(start_of(trial).pose.pan_deg, start.pose.pan_deg);
            const AimTrialResult one = run_trial(trial);
            const AimTrialResult again = run_trial(trial);
            QCOMPARE(one.framed_s, again.framed_s);
            QCOMPARE(one.way.size(), again.way.size());
            QCOMPARE(one.way.back().pan_deg, again.way.back().pan_deg);
        }
        trial.seed = 2;
        QVERIFY(start_of(trial).pose.pan_deg != start.pose.pan_deg);
    }

    void what_is_acceptable() {
        const CameraOptics optics;
        const std::vector<ScenePlace> one{{0.0, 0.0, 1.2}};
        const HeldPose good{.tilt_deg = -2.0};
        QVERIFY(acceptable(one, good, optics, Aim::middle));
        QVERIFY(!acceptable(one, {.pan_deg = 9.0, .tilt_deg = -2.0}, optics, Aim::middle));
        QVERIFY(!acceptable(one, {.tilt_deg = 8.0}, optics, Aim::middle));
        QVERIFY(!acceptable(one, {.tilt_deg = -2.0, .roll_deg = 10.0}, optics, Aim::middle));
        QVERIFY(!acceptable(one, {.tilt_deg = -2.0, .forward_m = 0.8}, optics, Aim::middle));
        QVERIFY(!acceptable(one, {.tilt_deg = -2.0, .forward_m = -2.0}, optics, Aim::middle));
        QVERIFY(!acceptable(one, {.pan_deg = 60.0}, optics, Aim::middle));
        const std::vector<ScenePlace> three{{-0.5, 0.0, 2.0}, {0.0, 0.0, 2.0}, {0.5, 0.0, 2.0}};
        QVERIFY(acceptable(three, good, optics, Aim::everybody));
        QVERIFY(!acceptable(three, {.pan_deg = 25.0, .tilt_deg = -2.0}, optics, Aim::everybody));
    }

    void shares_are_of_all() {
        std::vector<AimTrialResult> results(4);
        results[0].framed_s = 5.0;
        results[1].framed_s = 12.0;
        results[1].missed_pictures = 2;
        results[2].sentences = 4;
        const AimShares made = shares_of(results);
        QCOMPARE(made.trials, std::size_t{4});
        QCOMPARE(made.within_5_s, 0.25);
        QCOMPARE(made.within_10_s, 0.25);
        QCOMPARE(made.within_15_s, 0.5);
        QCOMPARE(made.within_20_s, 0.5);
        QCOMPARE(made.median_s, std::optional(12.0));
        QCOMPARE(made.missed_pictures, 0.5);
        QCOMPARE(made.sentences, 1.0);
        results.emplace_back();
        QVERIFY(!shares_of(results).median_s);
        QCOMPARE(shares_of({}).trials, std::size_t{0});
    }
};

} // namespace aim_trial_test

TP_TEST(aim_trial_test, AimTrialTest, nothing)
#include "aim_trial_test.moc"
