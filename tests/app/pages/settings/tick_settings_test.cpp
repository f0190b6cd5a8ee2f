// SPDX-License-Identifier: Apache-2.0
#include "app/pages/settings/tick_settings.hpp"
#include "settings_bench.hpp"
#include "test_program.hpp"

namespace tick_settings_test {

using namespace tp;

class TickSettingsTest : public QObject {
    Q_OBJECT
private slots:
    void what_is_chosen_is_kept_said_and_bounded() {
        SettingsBench bench;
        TickSettings& ticks = *bench.session.ticks();
        ticks.setStrength(0.4);
        QCOMPARE(bench.now().touch_strength, 0.4);
        QVERIFY(bench.said("Strength of ticks: 40 percent."));
        ticks.setSharpness(7.0);
        QCOMPARE(bench.now().touch_sharpness, 1.0);
        ticks.setLatency(9.0);
        QCOMPARE(bench.now().touch_latency_s, TapTest::longest_latency_s);
        bench.session.steps()->undo();
        bench.session.steps()->undo();
        bench.session.steps()->undo();
        QCOMPARE(bench.now(), Choices{});
    }

    void what_is_there_can_be_chosen() {
        SettingsBench bench;
        TickSettings& ticks = *bench.session.ticks();
        QCOMPARE(ticks.current(), -1);
        bench.ticking.plug_in();
        bench.session.enter();
        QTRY_COMPARE(ticks.names(), QStringList{"test pad"});
        QCOMPARE(ticks.current(), 0);
        ticks.choose(5);
        QCOMPARE(bench.now().touch, QString());
        ticks.choose(0);
        QCOMPARE(bench.now().touch, QString("1"));
        QVERIFY(bench.said("Ticks: test pad."));
    }

    void one_tick_is_felt_as_it_was_chosen_and_the_output_given_back() {
        SettingsBench bench;
        bench.ticking.plug_in();
        bench.session.enter();
        QTRY_VERIFY(bench.session.ticks()->current() == 0);
        bench.session.ticks()->setStrength(0.4);
        bench.session.ticks()->feelIt();
        QTRY_COMPARE(bench.ticking.ticks().size(), std::size_t(1));
        QCOMPARE(bench.ticking.ticks()[0].amplitude(), 0.4);
        QTRY_COMPARE(bench.ticking.open(), 0);
        QCOMPARE(bench.ticking.ticks().size(), std::size_t(1));
    }

    void nothing_there_and_a_refusal_are_told() {
        SettingsBench bench;
        bench.session.enter();
        bench.session.ticks()->feelIt();
        QVERIFY(bench.said("There is nothing here that ticks under a finger."));
        bench.ticking.plug_in(false, "It is held by another program.");
        QTRY_VERIFY(bench.session.ticks()->current() == 0);
        bench.session.ticks()->feelIt();
        QTRY_VERIFY(bench.said("It is held by another program."));
        QVERIFY(!bench.session.back());
    }

    void a_test_by_taps_sets_the_latency() {
        SettingsBench bench;
        bench.ticking.plug_in();
        bench.session.enter();
        QTRY_VERIFY(bench.session.ticks()->current() == 0);
        bench.session.ticks()->measure();
        QTRY_VERIFY(bench.session.ticks()->measuring());
        for (int i = 1; i <= TapTest::ticks; ++i) {
            QTRY_VERIFY(bench.ticking.ticks().size() >= std::size_t(i));
            bench.time += 0.23;
            bench.session.ticks()->tap();
        }
        QTRY_VERIFY(!bench.session.ticks()->measuring());
        QVERIFY(std::abs(bench.now().touch_latencies_s["1"] - (0.23 - TapTest::reaction_s)) < 1e-9);
        QTRY_COMPARE(bench.ticking.open(), 0);
    }

    void each_output_has_a_latency_of_its_own() {
        SettingsBench bench;
        TickSettings& ticks = *bench.session.ticks();
        bench.ticking.plug_in();
        bench.session.enter();
        QTRY_COMPARE(ticks.current(), 0);
        QCOMPARE(ticks.latency(), testing::TouchSocket::delay_s); // what it says of itself
        ticks.setLatency(0.05);
        QCOMPARE(ticks.latency(), 0.05);
        QCOMPARE(bench.now().touch_latencies_s, (QMap<QString, double>{{"1", 0.05}}));
        QCOMPARE(bench.now().touch_latency_s, 0.0);
        bench.session.steps()->undo();
        bench.preferences.change([](Choices& choices) { choices.touch_latency_s = 0.1; });
        QCOMPARE(ticks.latency(), 0.1);
    }

    void escape_ends_a_test_and_a_page_that_is_left_too() {
        SettingsBench bench;
        bench.ticking.plug_in();
        bench.session.enter();
        QTRY_VERIFY(bench.session.ticks()->current() == 0);
        bench.session.ticks()->measure();
        QTRY_VERIFY(bench.session.ticks()->measuring());
        QVERIFY(bench.session.back());
        QVERIFY(!bench.session.ticks()->measuring());
        QTRY_COMPARE(bench.ticking.open(), 0);
        bench.session.ticks()->measure();
        QTRY_VERIFY(bench.session.ticks()->measuring());
        bench.session.leave();
        QTRY_COMPARE(bench.ticking.open(), 0);
        QCOMPARE(bench.now(), Choices{});
    }
};

} // namespace tick_settings_test

TP_TEST(tick_settings_test, TickSettingsTest, window)
#include "tick_settings_test.moc"
