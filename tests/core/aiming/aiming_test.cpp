// SPDX-License-Identifier: Apache-2.0
// The whole room in virtual time, in the cases in which a camera and a detector are at their worst.
#include "core/aiming/aiming.hpp"
#include "frames.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace aiming_test {

using namespace tp;
using namespace tp::testing;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// A room and somebody whose sentences take a second.
struct Session {
    explicit Session(Aim aim = Aim::middle) : aiming(aim) {}
    AimAnswer see(std::vector<AimFace> faces) {
        now += 0.1;
        return see_at(now, std::move(faces));
    }
    AimAnswer see_at(double time, std::vector<AimFace> faces) {
        if (speaking && (time >= ends || time < ends - 1.5)) {
            aiming.sentence_ended(time);
            speaking = false;
        }
        const AimAnswer answer = aiming.see(frame_of(time, std::move(faces)));
        if (answer.say) {
            over_itself = over_itself || speaking;
            said.push_back(answer.say->advice);
            speaking = true;
            ends = time + 1.0;
        }
        pictures += answer.take ? 1 : 0;
        return answer;
    }

    Aiming aiming;
    double now = 0.0;
    double ends = 0.0;
    bool speaking = false;
    bool over_itself = false;
    int pictures = 0;
    std::vector<Advice> said;
};

} // namespace

class AimingTest : public QObject {
    Q_OBJECT
private slots:
    void from_beside_to_the_picture() {
        Session session;
        AimAnswer answer;
        for (int i = 0; i < 60; ++i)
            answer = session.see({face_at(std::max(0.5, 0.8 - 0.01 * std::max(0, i - 15)), 0.45)});
        QCOMPARE(session.said.front(), Advice::move_right);
        QCOMPARE(session.said.back(), Advice::ready);
        QCOMPARE(session.pictures, 1);
        QVERIFY(answer.good && answer.tone.rising);
        QVERIFY(!session.over_itself);
    }

    void a_change_is_said_within_a_quarter_of_a_second() {
        Session session;
        for (int i = 0; i < 30; ++i)
            session.see({face_at(0.5, 0.45)});
        const std::size_t before = session.said.size();
        const double at = session.now;
        while (session.said.size() == before && session.now < at + 2.0)
            session.see({face_at(0.85, 0.45)});
        QVERIFY(session.now - at < 0.25 + 1e-9);
    }

    void a_flickering_face_gives_one_sentence() {
        Session session;
        for (int i = 0; i < 25; ++i)
            session.see(i % 2 == 0 ? std::vector{face_at(0.75, 0.45)} : std::vector<AimFace>{});
        for (const Advice advice : session.said)
            QCOMPARE(advice, Advice::move_right);
        QVERIFY(session.said.size() <= 2);
    }

    void two_who_swap_their_order_are_one_advice() {
        Session session;
        const AimFace left = face_at(0.25, 0.45, 0.3);
        const AimFace right = face_at(0.7, 0.45, 0.29);
        for (int i = 0; i < 50; ++i) {
            const AimAnswer answer =
                session.see(i % 2 == 0 ? std::vector{left, right} : std::vector{right, left});
            if (i > 1)
                QCOMPARE(answer.now.advice, Advice::move_left);
        }
    }

    void nonsense_is_looked_through() {
        Session session;
        AimFace nothing;
        nothing.box = {{no_number, no_number}, {no_number, no_number}};
        nothing.brightness = no_number;
        for (int i = 0; i < 30; ++i) {
            AimFace face = face_at(0.5, 0.45);
            face.brightness = no_number;
            face.eyes = {{Vec2(no_number, 0.0), Vec2(0.0, no_number)}};
            session.see({nothing, face});
        }
        QCOMPARE(session.said, std::vector{Advice::ready});
        QCOMPARE(session.pictures, 1);
        QVERIFY(!session.aiming.see(frame_of(no_number, {})).say);
        const AimAnswer at_first = Aiming(Aim::middle).see(frame_of(no_number, {face_at(0.5, 0.45)}));
        QVERIFY(!at_first.good && !at_first.take && !at_first.say);
    }

    void a_frame_without_shape_changes_nothing_and_takes_no_picture() {
        Session small;
        for (int i = 0; i < 15; ++i)
            small.see({face_at(0.5, 0.45, 0.1)});
        Session well;
        while (well.pictures == 0 && well.now < 5.0)
            well.see({face_at(0.5, 0.45)});
        QCOMPARE(well.pictures, 1);
        for (const double aspect : {-1.0, 0.0, no_number}) {
            AimFrame flat = frame_of(small.now + 0.1, {face_at(0.9, 0.9)});
            flat.aspect = aspect;
            QCOMPARE(small.aiming.see(flat).now.advice, Advice::closer);
            QVERIFY(!well.aiming.see(flat).take);
        }
    }

    void fifty_faces_are_an_aim_like_any() {
        Session session(Aim::everybody);
        std::vector<AimFace> crowd;
        for (int i = 0; i < 50; ++i)
            crowd.push_back(face_at(0.1 + 0.08 * (i % 10), 0.15 + 0.14 * (i / 10), 0.09));
        AimAnswer answer;
        for (int i = 0; i < 20; ++i)
            answer = session.see(crowd);
        QCOMPARE(answer.now.faces, 50);
        QVERIFY(answer.good);
        QCOMPARE(session.pictures, 1);
    }

    void a_clock_that_jumps_takes_no_picture_and_talks_on() {
        Session session;
        for (int i = 0; i < 6; ++i)
            session.see({face_at(0.5, 0.45)});
        session.now = 5000.0;
        QVERIFY(!session.see({face_at(0.5, 0.45)}).take);
        session.now = -100.0;
        for (int i = 0; i < 5; ++i)
            QVERIFY(!session.see({face_at(0.5, 0.45)}).take);
        session.said.clear();
        for (int i = 0; i < 50; ++i)
            session.see({face_at(0.9, 0.45)});
        QVERIFY(!session.said.empty());
        QVERIFY(!session.over_itself);
    }

    void another_aim_and_another_camera_are_said_anew() {
        Session session;
        for (int i = 0; i < 20; ++i)
            session.see({face_at(0.5, 0.42, 0.3)});
        QCOMPARE(session.said.back(), Advice::ready);
        session.aiming.aim_at(Aim::thirds);
        for (int i = 0; i < 5; ++i)
            session.see({face_at(0.5, 0.42, 0.3)});
        QCOMPARE(session.said.back(), Advice::move_right); // the left line of thirds: the face goes left
        session.aiming.hold({true, false});
        for (int i = 0; i < 25; ++i)
            session.see({face_at(0.5, 0.42, 0.3)});
        QCOMPARE(session.said.back(), Advice::move_left);
    }

    /// Whoever aims anew, or turns the camera round, hears it anew, though it is what was said last.
    void what_is_said_anew_is_said_soon() {
        for (const bool turned : {false, true}) {
            Session session;
            for (int i = 0; i < 20; ++i)
                session.see({face_at(0.5, 0.45)});
            QCOMPARE(session.said, std::vector{Advice::ready});
            if (turned)
                session.aiming.hold({true, false});
            else
                session.aiming.aim_at(Aim::everybody);
            for (int i = 0; i < 5; ++i)
                session.see({face_at(0.5, 0.45)});
            QCOMPARE(session.said, (std::vector{Advice::ready, Advice::ready}));
        }
    }

    void a_camera_that_was_turned_round_has_seen_nobody_yet() {
        Session session;
        for (int i = 0; i < 15; ++i)
            session.see({face_at(0.9, 0.45)});
        session.aiming.hold({true, false});
        const AimAnswer now = session.see({});
        QCOMPARE(now.now.faces, 0);
        QCOMPARE(now.now.advice, Advice::look_right); // as everybody is looked for, not to where that one is
        for (int i = 0; i < 15; ++i)
            session.see({face_at(0.9, 0.45)});
        QVERIFY(session.see({face_at(0.9, 0.45)}).tone.side < -0.9);
    }

    /// Who was seen before is not looked for after it, and who is seen after it is as at first.
    void a_jump_of_the_clock_is_a_new_beginning_and_only_one() {
        Session session;
        const auto advice = [&session](double x) {
            AimAnswer answer;
            for (int i = 0; i < 15; ++i)
                answer = session.see({face_at(x, 0.45)});
            return answer.now.advice;
        };
        for (const double jump : {500.0, 1000.0}) { // a fault ends below where it begins
            QCOMPARE(advice(0.605), Advice::move_right);
            QCOMPARE(advice(0.58), Advice::move_right);
            QCOMPARE(advice(0.1), Advice::move_left);
            session.now = jump;
            QCOMPARE(session.see({}).now.advice, Advice::look_right);
        }
    }

    void what_the_person_says_is_heeded() {
        Session group(Aim::everybody);
        group.aiming.expect(2);
        Session tone;
        tone.aiming.with_tone(true);
        AimAnswer one, turned;
        for (int i = 0; i < 15; ++i) {
            one = group.see({face_at(0.5, 0.45)});
            turned = tone.see({face_at(0.68, 0.45, 0.27, 11.0)});
        }
        QCOMPARE(one.now.advice, Advice::farther);
        QCOMPARE(turned.now.advice, Advice::turn_clockwise);
        Session session;
        for (const int pictures : {1, 2}) {
            for (int i = 0; i < 15; ++i)
                session.see({face_at(0.5, 0.45)});
            QCOMPARE(session.pictures, pictures);
            session.aiming.arm();
        }
    }

    void words_are_heard_over_the_tone() {
        Session session;
        for (int i = 0; i < 25; ++i) {
            const AimAnswer answer = session.see({face_at(0.8, 0.45)});
            QCOMPARE(answer.tone.gain, session.speaking ? 0.35 : 1.0);
        }
    }

    void whatever_is_seen_nothing_breaks() {
        std::mt19937 random(3);
        const auto number = [&random] {
            const auto kind = random() % 12;
            const double value = static_cast<double>(random() % 1000) / 500.0 - 0.5;
            return kind == 0   ? no_number
                   : kind == 1 ? std::numeric_limits<double>::infinity()
                   : kind == 2 ? 1e300 * value
                               : value;
        };
        for (const Aim aim : {Aim::middle, Aim::thirds, Aim::head_and_shoulders, Aim::everybody}) {
            Session session(aim);
            for (int i = 0; i < 3000; ++i) {
                std::vector<AimFace> faces(random() % 5);
                for (AimFace& face : faces) {
                    face.box = {{number(), number()}, {number(), number()}};
                    face.confidence = number() + 0.5;
                    face.brightness = number();
                    face.eyes = {{Vec2(number(), number()), Vec2(number(), number())}};
                }
                session.now = random() % 50 == 0 ? number() : session.now;
                const AimAnswer answer = session.see(std::move(faces));
                QVERIFY(std::isfinite(answer.now.amount) && answer.now.amount >= 0.0);
                QVERIFY(std::isfinite(answer.tone.side) && std::abs(answer.tone.side) <= 1.0);
                QVERIFY(std::isfinite(answer.tone.pitch_octaves) &&
                        std::abs(answer.tone.pitch_octaves) <= highest_octaves);
                QVERIFY(answer.tone.beats_per_s == 0.0 || (answer.tone.beats_per_s >= slowest_beats - 1e-9 &&
                                                           answer.tone.beats_per_s <= fastest_beats + 1e-9));
            }
            QVERIFY(!session.over_itself);
        }
    }
};

} // namespace aiming_test

TP_TEST(aiming_test, AimingTest, nothing)
#include "aiming_test.moc"
