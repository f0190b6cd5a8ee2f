// SPDX-License-Identifier: Apache-2.0
// What is felt while one aims, by an output that remembers: it comes and goes, ends with the page, and is nobody's who has not
// chosen it.
#include "capture_bench.hpp"
#include "test_program.hpp"

#include <QLocale>

#include <algorithm>
#include <vector>

namespace capture_touch_test {

using namespace tp;

namespace {

const Vec2 middle{0.5, 0.45};
const Vec2 beside{0.75, 0.45};

Choices with(Choices::Guide guide) {
    Choices choices = CaptureBench::told();
    choices.guide = guide;
    choices.shutter_by_itself = false;
    return choices;
}

/// An output is plugged in before the page is entered.
struct Bench : CaptureBench {
    explicit Bench(Choices::Guide guide = Choices::Guide::ticks_and_sonar) : CaptureBench(with(guide)) {
        touch.plug_in();
    }
    bool ticks() const { return session->touch().in_use(); }
    void begin() {
        enter();
        QTRY_VERIFY(ticks());
        voice.clear();
    }
    std::vector<Tick> felt_for(double seconds, Vec2 face) {
        touch.forget();
        see_for(seconds, {face});
        return touch.ticks();
    }
};

double strongest(const std::vector<Tick>& ticks) {
    double most = 0.0;
    for (const Tick& tick : ticks)
        most = std::max(most, tick.amplitude());
    return most;
}

} // namespace

class CaptureTouchTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English)); }

    void a_hand_that_comes_nearer_feels_more_and_stronger_pulses() {
        Bench bench;
        bench.begin();
        std::vector<Tick> before;
        for (const double x : {0.95, 0.75, 0.66}) {
            bench.felt_for(0.5, {x, middle.y});
            const std::vector<Tick> ticks = bench.felt_for(4.0, {x, middle.y});
            QVERIFY2(ticks.size() > before.size(),
                     qPrintable(QString("%1 after %2").arg(ticks.size()).arg(before.size())));
            QVERIFY(strongest(ticks) > strongest(before));
            for (const Tick& tick : ticks)
                QVERIFY(!tick.empty() && tick.seconds() <= Tick::longest_s);
            before = ticks;
        }
        const double of_well = bench.preferences.choices().touch_strength * well_pulse;
        QVERIFY(strongest(before) < of_well);
        QCOMPARE(bench.felt_for(2.0, middle).back().amplitude(), of_well);
        QVERIFY(bench.felt_for(2.0, middle).empty()); // a motor would blur the picture
    }

    void they_are_as_strong_and_sharp_as_was_chosen() {
        Bench bench;
        bench.preferences.change([](Choices& choices) {
            choices.touch_strength = 0.5;
            choices.touch_sharpness = 0.2;
        });
        bench.begin();
        bench.felt_for(1.0, beside);
        const Tick well = bench.felt_for(2.0, middle).back();
        QCOMPARE(well.amplitude(), 0.5);
        QCOMPARE(well.sharpness(), 0.2);
    }

    void the_pages_end_is_stillness_and_the_output_is_given_back() {
        Bench bench;
        bench.begin();
        QVERIFY(!bench.felt_for(1.0, beside).empty());
        const int halts = bench.touch.halts();
        bench.session->leave();
        QVERIFY(bench.touch.halts() > halts);
        QTRY_COMPARE(bench.touch.open(), 0);
        bench.session->enter();
        QTRY_VERIFY(bench.ticks());
        bench.session->setInSight(false);
        QVERIFY(!bench.ticks());
        QTRY_COMPARE(bench.touch.open(), 0);
        bench.session->setInSight(true);
        QTRY_VERIFY(bench.ticks());
        QCOMPARE(bench.touch.most_open(), 1);
    }

    void escape_ends_them_and_so_does_a_face_that_is_gone() {
        Bench bench;
        bench.begin();
        QVERIFY(!bench.felt_for(1.0, beside).empty());
        int halts = bench.touch.halts();
        bench.touch.forget();
        bench.see_for(2.0, {});
        QVERIFY(bench.touch.halts() > halts);
        bench.touch.forget();
        bench.see_for(1.0, {});
        QVERIFY(bench.touch.ticks().empty());
        QVERIFY(!bench.felt_for(1.0, beside).empty());
        halts = bench.touch.halts();
        bench.session->stop();
        QVERIFY(bench.touch.halts() > halts);
        QVERIFY(bench.felt_for(1.0, beside).empty());
        bench.session->listen();
        QVERIFY(!bench.felt_for(1.0, beside).empty());
    }

    void a_lost_output_is_told_once_and_is_felt_again_when_it_is_there_again() {
        Bench bench(Choices::Guide::ticks);
        bench.begin();
        QVERIFY(!bench.felt_for(1.0, beside).empty());
        QVERIFY(!bench.guide.sounds()); // the ticks tell it
        bench.touch.unplug();
        QVERIFY(bench.felt_for(1.0, beside).empty());
        QVERIFY(!bench.ticks());
        QVERIFY(bench.guide.sounds());
        bench.see_for(2.0, {beside});
        QCOMPARE(bench.voice.said().filter("No more ticks from test pad").size(), 1);
        QTRY_COMPARE(bench.touch.open(), 0);
        bench.touch.plug_in();
        QTRY_VERIFY(bench.ticks());
        QCOMPARE(bench.voice.said().filter("Ticks again: test pad.").size(), 1);
        QVERIFY(!bench.felt_for(1.0, beside).empty());
        QVERIFY(!bench.guide.sounds());
        QCOMPARE(bench.touch.most_open(), 1);
    }

    void nobody_who_has_not_chosen_ticks_has_any() {
        for (const Choices::Guide guide : {Choices::Guide::none, Choices::Guide::sonar,
                                           Choices::Guide::clock_voice, Choices::Guide::both}) {
            Bench bench(guide);
            bench.enter();
            QVERIFY(bench.felt_for(1.0, beside).empty());
            QCOMPARE(bench.touch.most_open(), 0);
        }
        Bench bench;
        bench.begin();
        QVERIFY(!bench.felt_for(1.0, beside).empty());
        const int halts = bench.touch.halts();
        bench.preferences.change([](Choices& choices) { choices.guide = Choices::Guide::sonar; });
        QVERIFY(!bench.ticks());
        QVERIFY(bench.touch.halts() > halts);
        QVERIFY(bench.felt_for(1.0, beside).empty());
        QTRY_COMPARE(bench.touch.open(), 0);
    }

    void where_nothing_ticks_the_tone_leads_and_that_is_told_once() {
        CaptureBench bench(with(Choices::Guide::ticks));
        bench.enter();
        QTRY_COMPARE(bench.voice.said().filter("There is no motor here").size(), 1);
        bench.see_for(1.0, {beside});
        QVERIFY(bench.guide.sounds());
        bench.session->leave();
        QVERIFY(!bench.guide.sounds());
        bench.enter();
        bench.see_for(1.0, {beside});
        QCOMPARE(bench.voice.said().filter("There is no motor here").size(), 1);
    }

    void one_that_is_held_by_another_program_is_told_once() {
        Bench bench(Choices::Guide::ticks);
        bench.touch.plug_in(false, "It is held by another program.");
        bench.enter();
        QTRY_COMPARE(bench.voice.said()
                         .filter("It is held by another program. Until then the tone and words lead you.")
                         .size(),
                     1);
        bench.see_for(2.0, {beside});
        QVERIFY(bench.guide.sounds());
        QCOMPARE(bench.voice.said().filter("held by another").size(), 1);
    }
};

} // namespace capture_touch_test

TP_TEST(capture_touch_test, CaptureTouchTest, event_loop)
#include "capture_touch_test.moc"
