// SPDX-License-Identifier: Apache-2.0
#include "explore_parts.hpp"
#include "test_program.hpp"

#include <QTest>

namespace explore_choices_test {

using namespace tp;

class ExploreChoicesTest : public QObject {
    Q_OBJECT
private slots:
    void the_force_limit_is_the_persons_and_is_kept() {
        ExploreParts bench;
        QCOMPARE(bench.choices.maxForce(), 1.0);
        bench.choices.setMaxForce(0.4);
        QCOMPARE(bench.sounds.preferences.choices().max_force_n, 0.4);
        bench.sounds.preferences.change([](Choices& choices) { choices.max_force_n = 0.2; });
        QCOMPARE(bench.choices.maxForce(), 0.2);
        const auto& points = bench.view.felt().lines[outline].points;
        const QPointF beside =
            bench.view.frame().from_surface(0.5 * (points[0] + points[1]) + Vec2(5.0, 0.0));
        bench.hand.touchDown(beside.x(), beside.y());
        QTRY_VERIFY(bench.finger.newtons() > 0.1);
        QVERIFY(bench.finger.newtons() <= 0.2 + 1e-9);
    }

    void the_guide_can_be_changed_by_one_key() {
        ExploreParts bench;
        QCOMPARE(bench.choices.guide(), static_cast<int>(Choices::Guide::both));
        bench.choices.nextGuide();
        QCOMPARE(bench.said(), QString("Guide: Ticks under the finger."));
        bench.choices.nextGuide();
        QCOMPARE(bench.said(), QString("Guide: Ticks and beeps."));
        bench.choices.nextGuide();
        QCOMPARE(bench.said(), QString("Guide: None."));
        bench.choices.nextGuide();
        QCOMPARE(bench.said(), QString("Guide: Beeps."));
        QCOMPARE(bench.sounds.preferences.choices().guide, Choices::Guide::sonar);
    }

    void a_guide_beeps_speaks_or_does_both_and_beeps_where_nothing_can_tick() {
        ExploreParts bench(0);
        const bool beeps[]{false, true, false, true, true, true};
        const bool speaks[]{false, false, true, true, false, false};
        for (int i = 0; i < 6; ++i) {
            bench.choices.setGuide(i);
            QCOMPARE(bench.choices.beeps(), beeps[i]);
            QCOMPARE(bench.choices.speaks(), speaks[i]);
            QCOMPARE(bench.choices.ticks(), i >= 4);
        }
        bench.choices.setGuide(6); // there is none
        QCOMPARE(bench.choices.guide(), 5);
    }

    void what_the_program_adds_is_felt_beside_what_the_person_wants() {
        ExploreParts bench(0);
        bench.settings.extras.irises = true;
        ExploreChoices choices(bench.sounds.preferences, bench.servo, bench.words, bench.settings);
        bench.sounds.preferences.change([](Choices& wanted) { wanted.nose = true; });
        QVERIFY(choices.extras().irises && choices.extras().nose && !choices.extras().brows);
    }
};

} // namespace explore_choices_test

TP_TEST(explore_choices_test, ExploreChoicesTest, event_loop)
#include "explore_choices_test.moc"
