// SPDX-License-Identifier: Apache-2.0
// A finger that feels friction allocates nothing, over a million samples with lines crossed, followed and left.
#include "core/friction/friction_finger.hpp"
#include "core/guidance/exact_law.hpp"
#include "counted_allocations.hpp"
#include "scenes.hpp"

#include <QTest>

using namespace tp;
using namespace tp::testing;

class AllocationTest : public QObject {
    Q_OBJECT
private slots:
    void the_counter_counts() {
        counting = true;
        const std::vector<int> something(100);
        counting = false;
        QVERIFY(allocations.load() > 0 && something.size() == 100);
    }

    void a_million_samples_allocate_nothing() {
        const FlatScene face = face_scene();
        FrictionChoices choices;
        choices.textured = {"left_eye", "outer_lip"};
        const ExactLaw exact(face, {});
        const FrictionLaw law(face, choices);
        FrictionFinger finger(law);
        std::size_t events = 0;
        allocations = 0;
        counting = true;
        for (int i = 0; i < 1'000'000; ++i) {
            const double t = 0.0005 * i;
            const Vec2 place(60.0 * std::sin(1.1 * t), 55.0 * std::cos(0.7 * t));
            if (i % 100'000 == 0)
                finger.lift();
            events += finger.step(place, {60, 20}, exact.at(place)).events.size();
        }
        counting = false;
        QCOMPARE(allocations.load(), 0L);
        QVERIFY(events > 300);
    }
};

QTEST_APPLESS_MAIN(AllocationTest)
#include "allocation_test.moc"
