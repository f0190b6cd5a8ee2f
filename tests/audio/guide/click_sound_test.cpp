// SPDX-License-Identifier: Apache-2.0
#include "audio/guide/click_sound.hpp"
#include "fake_loudspeaker.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>

namespace click_sound_test {

using namespace tp;
using tp::testing::FakeLoudspeaker;

namespace {

struct Bench {
    FakeLoudspeaker loudspeaker;
    double time = 5.0;
    ClickSound sound{loudspeaker, [this] { return time; }};

    bool hears_a_click() {
        loudspeaker.heard.clear();
        sound.list()->push({time, 1.0, 0.5, 0.01});
        for (int i = 0; i < 10; ++i, time += 0.01)
            loudspeaker.play(0.01);
        return std::any_of(loudspeaker.heard.begin(), loudspeaker.heard.end(),
                           [](float sample) { return sample > 0.1F; });
    }
};

} // namespace

class ClickSoundTest : public QObject {
    Q_OBJECT
private slots:
    void clicks_are_heard_while_they_are_wanted() {
        Bench bench;
        QVERIFY(!bench.hears_a_click());
        bench.sound.begin();
        bench.sound.begin();
        QCOMPARE(bench.loudspeaker.runs.size(), std::size_t(1));
        QVERIFY(bench.hears_a_click());
        bench.sound.end();
        QVERIFY(!bench.loudspeaker.playing());
        QVERIFY(!bench.hears_a_click());
    }

    void what_was_not_heard_before_is_not_heard_later() {
        Bench bench;
        bench.sound.list()->push({bench.time, 1.0, 0.5, 0.01});
        bench.sound.begin();
        bench.loudspeaker.play(0.2);
        QCOMPARE(*std::max_element(bench.loudspeaker.heard.begin(), bench.loudspeaker.heard.end()), 0.0F);
    }

    void it_goes_on_when_a_loudspeaker_comes_or_changes() {
        Bench bench;
        bench.loudspeaker.there = false;
        bench.sound.begin();
        QVERIFY(!bench.hears_a_click());
        bench.loudspeaker.come();
        QVERIFY(bench.hears_a_click());
        bench.loudspeaker.move();
        QVERIFY(bench.hears_a_click());
        bench.sound.end();
        bench.loudspeaker.come();
        QVERIFY(!bench.loudspeaker.playing());
    }
};

} // namespace click_sound_test

TP_TEST(click_sound_test, ClickSoundTest, event_loop)
#include "click_sound_test.moc"
