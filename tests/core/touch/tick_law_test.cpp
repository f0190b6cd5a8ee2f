// SPDX-License-Identifier: Apache-2.0
#include "core/touch/tick_law.hpp"
#include "test_program.hpp"

#include <QTest>

#include <array>
#include <cmath>
#include <numbers>

namespace tick_law_test {

using namespace tp;

namespace {

LineEvent event_of(LineEventKind kind, double share = 1.0, double angle = std::numbers::pi / 2.0) {
    LineEvent event{};
    event.kind = kind;
    event.share = share;
    event.angle = angle;
    return event;
}

constexpr std::array kinds{LineEventKind::crossed, LineEventKind::followed, LineEventKind::left,
                           LineEventKind::corner};
const TickChoices choices{0.6, 0.8};

} // namespace

class TickLawTest : public QObject {
    Q_OBJECT
private slots:
    void a_crossing_is_a_click_the_softer_the_flatter() {
        const Tick across = tick_of(event_of(LineEventKind::crossed), choices);
        QCOMPARE(across.amplitude(), 0.6);
        QCOMPARE(across.sharpness(), 0.8);
        const Tick flat = tick_of(event_of(LineEventKind::crossed, 1.0, std::numbers::pi / 6.0), choices);
        QCOMPARE(flat.amplitude(), 0.6);
        QVERIFY(std::abs(flat.sharpness() - 0.4) < 1e-12);
    }

    void leaving_a_line_is_stronger_and_sharper_than_beginning_to_follow_it() {
        const Tick begins = tick_of(event_of(LineEventKind::followed), choices);
        const Tick leaves = tick_of(event_of(LineEventKind::left), choices);
        QVERIFY(!begins.empty());
        QVERIFY(leaves.amplitude() > begins.amplitude());
        QVERIFY(leaves.sharpness() > begins.sharpness());
    }

    void each_kind_has_its_strength_and_its_length() {
        QVERIFY(tick_of(event_of(LineEventKind::crossed), choices) == Tick(0.6, 0.8, 0.008));
        QVERIFY(tick_of(event_of(LineEventKind::followed), choices) == Tick(0.3, 0.0, 0.016));
        QVERIFY(tick_of(event_of(LineEventKind::left), choices) == Tick(0.6, 1.0, 0.016));
        const Tick corner = tick_of(event_of(LineEventKind::corner), choices);
        QVERIFY(std::abs(corner.amplitude() - 0.4) < 1e-12);
        QCOMPARE(corner.sharpness(), 0.8);
        QCOMPARE(corner.seconds(), 0.008);
    }

    void each_kind_is_felt_and_none_like_another() {
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            QVERIFY(!tick_of(event_of(kinds[i]), choices).empty());
            for (std::size_t k = 0; k < i; ++k)
                QVERIFY(tick_of(event_of(kinds[i]), choices) != tick_of(event_of(kinds[k]), choices));
        }
    }

    void nothing_is_told_to_a_finger_at_rest() {
        for (const LineEventKind kind : kinds) {
            QVERIFY(tick_of(event_of(kind, 0.0), choices).empty());
            const double whole = tick_of(event_of(kind), choices).amplitude();
            QVERIFY(std::abs(tick_of(event_of(kind, 0.5), choices).amplitude() - 0.5 * whole) < 1e-12);
        }
    }

    void of_several_at_once_the_strongest_is_told() {
        QVERIFY(tick_of(Friction{}, choices).empty());
        const std::array events{event_of(LineEventKind::followed), event_of(LineEventKind::crossed),
                                event_of(LineEventKind::left, 0.9)};
        Friction friction;
        friction.events = events;
        QVERIFY(tick_of(friction, choices) == tick_of(events[1], choices));
        const std::array twins{event_of(LineEventKind::crossed, 1.0, 0.5), event_of(LineEventKind::crossed)};
        friction.events = twins;
        QVERIFY(tick_of(friction, choices) == tick_of(twins[0], choices));
    }
};

} // namespace tick_law_test

TP_TEST(tick_law_test, TickLawTest, nothing)
#include "tick_law_test.moc"
