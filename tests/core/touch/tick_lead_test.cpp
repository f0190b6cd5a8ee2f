// SPDX-License-Identifier: Apache-2.0
#include "core/touch/tick_lead.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <initializer_list>

namespace tick_lead_test {

using namespace tp;

namespace {

const Polyline way{{{0.0, 0.0}, {0.0, 60.0}}, false};
const TickChoices choices{0.6, 0.8};

} // namespace

class TickLeadTest : public QObject {
    Q_OBJECT
private slots:
    /// It must know at once that it is led.
    void the_first_tick_comes_with_the_first_step_and_the_next_a_fifth_of_a_second_later() {
        TickLead lead(way, {0.0, 0.0});
        QVERIFY(!lead.step({0.0, 0.0}, 0.001, choices).empty());
        int steps = 0;
        while (lead.step({0.0, 0.0}, 0.001, choices).empty() && steps < 1000)
            ++steps;
        QVERIFY2(std::abs(steps - 199) <= 1, qPrintable(QString::number(steps)));
    }

    void a_tick_is_the_weaker_the_farther_the_finger_is_from_what_leads_it() {
        for (const double away : {0.0, 3.0, 6.0, 9.0, 12.0, 50.0}) {
            TickLead lead(way, {0.0, 0.0});
            const Vec2 leader = lead.leader();
            const Tick tick = lead.step(leader + Vec2(away, 0.0), 0.0, choices);
            const double distance = length(lead.leader() - (leader + Vec2(away, 0.0)));
            QVERIFY(std::abs(distance - away) < 1e-9);
            const double share = away < 12.0 ? 1.0 - 0.9 * away / 12.0 : 0.1;
            QVERIFY2(std::abs(tick.amplitude() - 0.6 * share) < 1e-9, qPrintable(QString::number(away)));
            QCOMPARE(tick.sharpness(), 0.8);
            QCOMPARE(tick.seconds(), 0.008);
        }
    }

    void what_leads_waits_4_mm_ahead_of_a_finger_that_does_not_come() {
        TickLead lead(way, {0.0, 0.0});
        for (int i = 0; i < 10'000; ++i)
            lead.step({0.0, 0.0}, 0.001, choices);
        QVERIFY(length(lead.leader() - Vec2(0.0, 4.0)) < 0.05);
        QVERIFY(!lead.finished());
    }

    void a_finger_that_follows_arrives_and_hears_no_more() {
        TickLead lead(way, {0.0, 0.0});
        double seconds = 0.0;
        while (!lead.finished() && seconds < 10.0) {
            lead.step(lead.leader(), 0.001, choices);
            seconds += 0.001;
        }
        QVERIFY(lead.finished());
        QCOMPARE(lead.progress(), 1.0);
        QVERIFY(length(lead.leader() - Vec2(0.0, 60.0)) < 1e-6);
        for (int i = 0; i < 1000; ++i)
            QVERIFY(lead.step({0.0, 60.0}, 0.001, choices).empty());
    }
};

} // namespace tick_lead_test

TP_TEST(tick_lead_test, TickLeadTest, nothing)
#include "tick_lead_test.moc"
