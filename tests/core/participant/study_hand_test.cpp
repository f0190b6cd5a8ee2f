// SPDX-License-Identifier: Apache-2.0
#include "core/experiment/experiment_file.hpp"
#include "core/participant/study_hand.hpp"
#include "core/trials/trial_judge.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>

namespace study_hand_test {

using namespace tp;

namespace {

constexpr double dt = 0.005;

struct Way {
    TrialJudge judge;
    std::vector<Vec2> places;
    std::size_t times_lost = 0;
};

StudyTrial trial(const char* path, std::uint64_t seed, const char* more = "") {
    return trial_of(read_experiment("experiment: a\ntask: follow\nset stiffness: 0.4 N/mm\nset path: " +
                                    std::string(path) + "\nfactor range: 8, 10 mm\nlongest trial: 90 s\n" +
                                    more)
                        .value(),
                    {0, 0, false, seed})
        .value();
}

/// A finger without mass: it lies where the arm's spring and the line's pull are equal, which it reaches in some tenths of a second.
/// `sign` -1: a line that pushes away.
Way follow(const StudyTrial& trial, const Person& person, std::uint64_t seed, double sign = 1.0) {
    const auto scene = haptic_scene_of(trial).value();
    StudyHand hand(person, trial.scene.surface(), trial.start, true, dt, seed);
    Way way{TrialJudge(trial), {}};
    Vec2 finger = trial.start;
    for (double time = 0.0; way.judge.state() == TrialState::going; time += dt) {
        const Vec2 force = sign * scene->law->at(finger).force;
        const Vec2 meant = hand.step(finger, force);
        finger += 0.15 * (meant + force / (person.stiffness_n_per_mm + trial.profile.stiffness) - finger);
        way.judge.feed(time, finger);
        way.places.push_back(finger);
    }
    way.times_lost = hand.times_lost();
    return way;
}

} // namespace

class StudyHandTest : public QObject {
    Q_OBJECT
private slots:
    void one_seed_is_one_way_with_every_compiler() {
        StudyHand hand(Person{}, {{-90, -90}, {90, 90}}, {1, 2}, true, 0.001, 7);
        Vec2 at(0.0);
        for (int i = 0; i < 200; ++i)
            at = hand.step(at, {0.3, -0.001 * i});
        QVERIFY2(length(at - Vec2(1.212064, -0.181414)) < 1e-5,
                 qPrintable(QString("%1 %2").arg(at.x, 0, 'f', 6).arg(at.y, 0, 'f', 6)));
    }
    void a_hand_follows_what_pulls_it_to_the_end() {
        for (const char* const path : {"circle", "triangle", "curve"}) {
            int done = 0;
            for (std::uint64_t seed = 1; seed <= 12; ++seed)
                done += follow(trial(path, seed), Person{}, seed).judge.state() == TrialState::done ? 1 : 0;
            QVERIFY2(done >= 10, qPrintable(QString("%1 %2").arg(path).arg(done)));
        }
    }
    /// It would if it knew the scene, or if what it feels did not matter.
    void it_does_not_follow_what_pushes_it_away() {
        int done = 0;
        for (std::uint64_t seed = 1; seed <= 8; ++seed)
            done +=
                follow(trial("circle", seed), Person{}, seed, -1.0).judge.state() == TrialState::done ? 1 : 0;
        QVERIFY(done <= 1);
    }
    void the_same_seed_goes_the_same_way_and_another_another() {
        const StudyTrial one = trial("circle", 3);
        QVERIFY(follow(one, Person{}, 5).places == follow(one, Person{}, 5).places);
        QVERIFY(follow(one, Person{}, 5).places != follow(one, Person{}, 6).places);
    }
    void a_weaker_pull_is_followed_less_exactly() {
        double strong = 0.0, weak = 0.0;
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            StudyTrial one = trial("circle", seed);
            strong += *follow(one, Person{}, seed).judge.error_mm();
            one.profile.stiffness = 0.05;
            weak += *follow(one, Person{}, seed).judge.error_mm();
        }
        QVERIFY2(weak > 1.5 * strong, qPrintable(QString("%1 %2").arg(weak).arg(strong)));
    }
    void a_hand_that_feels_nothing_searches_and_stays_on_the_surface() {
        const Rect area{{-100, -100}, {100, 100}};
        for (const bool on_line : {true, false}) {
            StudyHand hand(Person{}, area, Vec2(0.0), on_line, dt, 4);
            Rect been{Vec2(0.0), Vec2(0.0)};
            Vec2 finger(0.0);
            for (double time = 0.0; time < 120.0; time += dt) {
                finger = hand.step(finger, Vec2(0.0));
                QVERIFY(area.contains(finger));
                been.min = glm::min(been.min, finger);
                been.max = glm::max(been.max, finger);
            }
            QVERIFY(been.width() > 150.0 && been.height() > 150.0);
            QVERIFY(!hand.following() && hand.trail().size() < 40);
            QVERIFY(!on_line || hand.times_lost() > 0);
        }
    }
    void it_goes_no_faster_than_a_hand() {
        const StudyTrial one = trial("triangle", 3);
        const Way way = follow(one, Person{}, 5);
        for (std::size_t i = 1; i < way.places.size(); ++i)
            QVERIFY(length(way.places[i] - way.places[i - 1]) < 400.0 * dt);
    }
    /// On the line the pull fades as the hand comes to it; outside it is gone while it was strong.
    void a_strong_pull_that_is_gone_is_a_line_that_was_left_and_a_weak_one_is_the_line() {
        for (const bool leaves : {true, false}) {
            StudyHand hand(Person{}, {{-100, -100}, {100, 100}}, Vec2(0.0), true, dt, 4);
            Vec2 finger(0.0);
            for (double time = 0.0; time < 2.4; time += dt) {
                const double pull = time >= 2.0 ? 0.0 : leaves ? 0.8 : 0.4 * (2.0 - time);
                finger = hand.step(finger, {0.0, -pull});
            }
            QCOMPARE(hand.times_lost(), std::size_t(leaves ? 1 : 0));
        }
    }
    void its_trail_lies_where_it_was() {
        const StudyTrial one = trial("circle", 3);
        const auto scene = haptic_scene_of(one).value();
        StudyHand hand(Person{}, one.scene.surface(), one.start, true, dt, 3);
        Vec2 finger = one.start;
        for (int i = 0; i < 2000; ++i)
            finger += 0.15 * (hand.step(finger, scene->law->at(finger).force) - finger);
        QVERIFY(hand.trail().size() > 20);
        for (const FeltPlace& felt : hand.trail())
            QVERIFY(distance_to(one.path, felt.place) < 25.0 && std::abs(length(felt.heading) - 1.0) < 1e-6);
    }
};

} // namespace study_hand_test

TP_TEST(study_hand_test, StudyHandTest, nothing)
#include "study_hand_test.moc"
