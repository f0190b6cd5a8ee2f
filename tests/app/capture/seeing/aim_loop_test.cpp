// SPDX-License-Identifier: Apache-2.0
// The whole way in virtual time: a simulated hand holds a simulated camera before a photograph, hears what is told of its
// frames, and gets the face framed.
#include "app/capture/frames/simulated_camera.hpp"
#include "app/capture/seeing/aim_eye.hpp"
#include "core/aiming/aiming.hpp"
#include "core/handheld/guided_hand.hpp"
#include "faces/decode/picture.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace aim_loop_test {

using namespace tp;

namespace {

constexpr int frames_per_s = 10;
constexpr double longest_s = 25.0;

/// When the shutter acted, and where the face then was.
struct Taken {
    double at_s = 0.0;
    Rect face;
};

std::optional<Taken> guided(const HeldPose& start, bool front, std::uint64_t seed) {
    SimulatedHold hold;
    hold.start = start;
    hold.wall = {0.6, 1.2, {0.5, 0.45}};
    hold.taking.size = {640, 360};
    hold.frames_per_s = frames_per_s;
    hold.seed = seed;
    hold.held = {front, front};
    auto camera = SimulatedCamera::open(test::in_source("resources/samples/anna_smiling.jpg"), hold);
    if (!camera)
        return std::nullopt;
    AimEye eye(camera->held());
    Aiming aiming(Aim::middle, camera->held());
    aiming.with_tone(true);
    HandManner manner; // whether hands mistake left for right is not the matter here
    manner.wrong_side = manner.wrong_height = manner.tone_wrong_side = manner.tone_wrong_height = 0.0;
    GuidedHand hand(manner, start, front, seed);
    double sentence_ends = std::numeric_limits<double>::infinity();
    while (hand.now_s() < longest_s) {
        const double now = hand.now_s();
        if (now >= sentence_ends) {
            aiming.sentence_ended(now);
            sentence_ends = std::numeric_limits<double>::infinity();
        }
        const AimFrame seen = eye.see(**camera->next());
        const AimAnswer answer = aiming.see(seen);
        if (answer.take && !seen.faces.empty())
            return Taken{now, seen.faces.front().box};
        if (answer.say)
            sentence_ends = hand.hear_words(*answer.say, now + 0.1);
        hand.hear_tone(answer.tone, now + 0.1);
        for (int i = 0; i < 100 / frames_per_s; ++i)
            hand.step(0.01);
        camera->move_to(hand.pose());
    }
    return std::nullopt;
}

} // namespace

class AimLoopTest : public QObject {
    Q_OBJECT
private slots:
    void a_hand_that_hears_gets_the_face_framed_data() {
        QTest::addColumn<double>("pan");
        QTest::addColumn<double>("tilt");
        QTest::addColumn<double>("roll");
        QTest::addColumn<bool>("front");
        QTest::newRow("beside") << 22.0 << 5.0 << 4.0 << false;
        QTest::newRow("out of sight") << -50.0 << -6.0 << -5.0 << false;
        QTest::newRow("tilted") << -8.0 << 10.0 << 18.0 << false;
        QTest::newRow("front camera") << 18.0 << -8.0 << -12.0 << true;
    }
    void a_hand_that_hears_gets_the_face_framed() {
        QFETCH(const double, pan);
        QFETCH(const double, tilt);
        QFETCH(const double, roll);
        QFETCH(const bool, front);
        const auto taken = guided({.pan_deg = pan, .tilt_deg = tilt, .roll_deg = roll}, front, 7);
        QVERIFY(taken);
        const AimLimits limits = limits_of(Aim::middle);
        const Vec2 off = taken->face.centre() - limits.place;
        QVERIFY2(std::abs(off.x) < 1.2 * limits.tolerance.x && std::abs(off.y) < 1.2 * limits.tolerance.y,
                 qPrintable(QString("%1 %2").arg(off.x).arg(off.y)));
        qInfo("after %.1f s", taken->at_s);
    }
};

} // namespace aim_loop_test

TP_TEST(aim_loop_test, AimLoopTest, nothing)
#include "aim_loop_test.moc"
