// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/clock_guide.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <limits>

namespace clock_guide_test {

using namespace tp;

namespace {
using Word = ClockGuide::Word;
using Said = std::optional<Word>;
const Vec2 right(1.0, 0.0);
} // namespace

class ClockGuideTest : public QObject {
    Q_OBJECT
private slots:
    void a_finger_that_rests_is_told_once() {
        ClockGuide guide;
        QCOMPARE(guide.follow({0, 0}, 8.0, right, 0.0), Said());
        QCOMPARE(guide.follow({0.5, 0}, 8.0, right, 0.4), Said());
        QCOMPARE(guide.follow({1, 0}, 8.2, right, 0.5), Said(Word{3, 8}));
        for (double now = 0.6; now < 20.0; now += 0.1)
            QCOMPARE(guide.follow({1, 0}, 8.2, right, now), Said());
    }
    void a_finger_that_moves_is_left_alone_unless_it_drifts_away() {
        ClockGuide guide;
        double now = 0.0;
        for (double x = 30.0; x > 10.0; x -= 2.5, now += 0.1) // on its way to the line
            QCOMPARE(guide.follow({-x, 0}, x, right, now), Said());
        Said said;
        double x = 10.0;
        for (; !said && x < 40.0; x += 2.5, now += 0.1) // and away again
            said = guide.follow({-x, 0}, x, right, now);
        QVERIFY(said.has_value());
        QCOMPARE(said->hour, 3);
        QVERIFY(said->millimetres >= 16 && said->millimetres <= 19);
    }
    void it_waits_until_it_can_be_heard() {
        ClockGuide guide;
        guide.follow({0, 0}, 8.0, right, 0.0);
        guide.busy_until(3.0);
        guide.busy_until(2.0); // the later one counts
        QCOMPARE(guide.follow({0, 0}, 8.0, right, 2.9), Said());
        QCOMPARE(guide.follow({0, 0}, 8.0, right, 3.0), Said(Word{3, 8}));
    }
    void on_the_line_there_is_nothing_to_say() {
        ClockGuide guide;
        guide.follow({0, 0}, 1.0, right, 0.0);
        QCOMPARE(guide.follow({0, 0}, 1.0, right, 5.0), Said());
    }
    void a_finger_set_down_again_is_told_again() {
        ClockGuide guide;
        guide.follow({0, 0}, 8.0, right, 0.0);
        QVERIFY(guide.follow({0, 0}, 8.0, right, 1.0));
        guide.lift();
        QCOMPARE(guide.follow({0, 0}, 8.0, right, 2.0), Said());
        QVERIFY(guide.follow({0, 0}, 8.0, right, 3.0));
    }
    void another_direction_is_worth_a_word() {
        ClockGuide guide;
        guide.follow({0, 0}, 8.0, right, 0.0);
        guide.follow({0, 0}, 8.0, right, 1.0);
        QCOMPARE(guide.follow({1.5, 0}, 8.0, {0.0, -1.0}, 2.0), Said(Word{6, 8}));
    }
    void nothing_is_said_of_nowhere() {
        ClockGuide guide;
        const double none = std::numeric_limits<double>::infinity();
        guide.follow({0, 0}, none, right, 0.0);
        QCOMPARE(guide.follow({0, 0}, none, right, 5.0), Said());
        QCOMPARE(guide.follow(Vec2(std::nan("")), 8.0, right, 9.0), Said());
    }
    void longer_sentences_take_longer_and_faster_voices_less() {
        QCOMPARE(speech_seconds(QString(28, 'a')), 2.0);
        QVERIFY(speech_seconds("3 o'clock, 8 millimetres", 0.7) < speech_seconds("3 o'clock, 8 millimetres", 0.0));
        QVERIFY(speech_seconds("3 o'clock, 8 millimetres", -0.6) > speech_seconds("3 o'clock, 8 millimetres", 0.0));
        QCOMPARE(speech_seconds(QString::fromUtf8("왼쪽 눈")), (3 * 3 + 1) / 14.0);
        QCOMPARE(speech_seconds({}), 0.0);
    }
};

} // namespace clock_guide_test

TP_TEST(clock_guide_test, ClockGuideTest, event_loop)
#include "clock_guide_test.moc"
