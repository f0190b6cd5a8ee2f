// SPDX-License-Identifier: Apache-2.0
#include "core/aiming/self_timer.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <limits>
#include <vector>

namespace self_timer_test {

using namespace tp;

namespace {

/// Ten good frames a second from `now` on; when pictures were taken.
std::vector<double> taken(SelfTimer& timer, double& now, int frames, double apart = 0.1) {
    std::vector<double> times;
    for (int i = 0; i < frames; ++i, now += apart)
        if (timer.see(true, now))
            times.push_back(now);
    return times;
}

} // namespace

class SelfTimerTest : public QObject {
    Q_OBJECT
private slots:
    void a_picture_comes_after_the_wait_and_once() {
        SelfTimer timer;
        double now = 10.0;
        const std::vector<double> times = taken(timer, now, 100);
        QCOMPARE(times.size(), std::size_t{1});
        QVERIFY(times[0] - 10.0 >= 0.8 - 1e-9 && times[0] - 10.0 < 0.901);
    }

    void one_bad_frame_begins_the_wait_anew() {
        SelfTimer timer;
        double now = 0.0;
        QVERIFY(taken(timer, now, 7).empty());
        QVERIFY(timer.share() > 0.7);
        timer.see(false, now);
        QCOMPARE(timer.share(), 0.0);
        now += 0.1;
        QVERIFY(taken(timer, now, 7).empty());
        QCOMPARE(taken(timer, now, 3).size(), std::size_t{1});
    }

    void after_a_bad_frame_or_armed_it_takes_another() {
        SelfTimer timer;
        double now = 0.0;
        QCOMPARE(taken(timer, now, 20).size(), std::size_t{1});
        timer.see(false, now);
        now += 0.1;
        QCOMPARE(taken(timer, now, 20).size(), std::size_t{1});
        timer.arm();
        QCOMPARE(taken(timer, now, 20).size(), std::size_t{1});
    }

    void what_was_not_seen_was_not_good() {
        SelfTimer timer;
        double now = 0.0;
        QVERIFY(taken(timer, now, 50, 0.36).empty());
    }

    void up_to_a_third_of_a_second_is_as_good_as_seen() {
        SelfTimer timer;
        for (const double now : {0.0, 0.35, 0.35, 0.69}) // one frame comes twice
            QVERIFY(!timer.see(true, now));
        QVERIFY(timer.see(true, 0.8));
    }

    void how_much_of_the_wait_is_over() {
        SelfTimer timer;
        timer.see(true, 0.0);
        timer.see(true, 0.2);
        QVERIFY(std::abs(timer.share() - 0.25) < 1e-9);
        double now = 0.3;
        QCOMPARE(taken(timer, now, 40).size(), std::size_t{1});
        QCOMPARE(timer.share(), 1.0); // and no more than all
    }

    void the_next_picture_waits_as_long_as_the_first() {
        SelfTimer timer;
        double now = 0.0;
        QCOMPARE(taken(timer, now, 9).size(), std::size_t{1});
        timer.arm();
        QVERIFY(taken(timer, now, 8).empty());
        QCOMPARE(taken(timer, now, 2).size(), std::size_t{1});
    }

    void a_clock_set_back_begins_the_wait_anew() {
        SelfTimer timer;
        double now = 100.0;
        QVERIFY(taken(timer, now, 7).empty());
        now = 99.0;
        const std::vector<double> times = taken(timer, now, 20);
        QCOMPARE(times.size(), std::size_t{1});
        QVERIFY(times[0] >= 99.8 - 1e-9 && times[0] < 99.901);
    }

    void no_time_is_no_frame() {
        SelfTimer timer;
        QVERIFY(!timer.see(true, std::numeric_limits<double>::quiet_NaN()));
        QCOMPARE(timer.share(), 0.0);
    }
};

} // namespace self_timer_test

TP_TEST(self_timer_test, SelfTimerTest, nothing)
#include "self_timer_test.moc"
