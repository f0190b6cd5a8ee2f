// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "touch_bench.hpp"

#include <QTest>

#include <cstddef>
#include <cstdint>

/// What is asked of every device that a program begins to touch with. Each fails the test that calls it.
namespace tp::vm {

/// At least once round the face: nothing is late, nobody is told of a fault, and every part of it draws the
/// hand. `device`: see felt_for.
inline void feels_the_whole_face(TouchBench& bench, const QString& device) {
    QVERIFY(bench.pulls());
    const double begun = now();
    pass(felt_for(device));
    const double ended = now();
    qInfo("felt for %.0f s", ended - begun);
    QVERIFY(bench.end_touching());
    QCOMPARE(bench.sessions.size(), std::size_t(1));
    const TouchSession session = bench.sessions[0];
    say("latest tick", 1e3 * session.latest_s);
    QCOMPARE(session.missed, std::uint64_t(0));
    QVERIFY2(session.latest_s < 0.5 * tick, qPrintable(QString::number(session.latest_s)));
    QCOMPARE(told_faults(bench.snapshots, begun, ended), QString());
    QCOMPARE(contours_felt(bench.snapshots, begun, ended).size(), contours_of_the_face());
}

/// Pulled out in mid-touch it is known to be lost, and its force is off; where that is so on the device too,
/// within `lets_go`, s. Plugged in again it is felt again.
inline void is_lost_and_felt_again(TouchBench& bench, double lets_go = 0.0) {
    QVERIFY(bench.pulls());
    const double pulled_out = now();
    bench.tell('u');
    QVERIFY(comes_true([&] { return bench.sessions.size() == 1; }, 10.0));
    pass(lets_go);
    const double ended = now();
    QVERIFY(bench.sessions[0].lost);
    const Fall fall = fall_after(bench.snapshots, pulled_out, ended, Fault::device_lost);
    QVERIFY(fall.noticed > 0.0);
    say("known to be lost after", 1e3 * (fall.noticed - pulled_out));
    QVERIFY(fall.last_force <= fall.noticed + ramp_down);
    if (lets_go > 0.0) {
        const double let_go = last_pull(bench.device_log, pulled_out, ended) - pulled_out;
        say("the device has let go after", 1e3 * let_go);
        QVERIFY(let_go <= lets_go);
        QVERIFY(bench.feels() == Vec2(0.0));
    }
    bench.tell('p');
    QVERIFY(bench.pulls());
    QVERIFY(bench.end_touching());
    QCOMPARE(bench.sessions.size(), std::size_t(2));
    QVERIFY(!bench.sessions[1].lost);
}

/// A fault of a moment: within 20 ms no force, and it heals.
inline void bears_a_silence(TouchBench& bench) {
    QVERIFY(bench.pulls());
    const double fell_silent = now();
    bench.tell('s');
    pass(0.2);
    const double spoke = now();
    const Fall fall = fall_after(bench.snapshots, fell_silent, spoke, Fault::stale_input);
    say("the silence is noticed after", 1e3 * (fall.noticed - fell_silent));
    say("and no force is sent after", 1e3 * (fall.last_force - fall.noticed));
    QVERIFY(fall.noticed > 0.0);
    QVERIFY(fall.noticed <= fell_silent + stale_after + tick + on_the_way);
    QVERIFY(fall.last_force <= fall.noticed + ramp_down);
    const double felt = last_pull(bench.device_log, fall.noticed, spoke) - fall.noticed;
    say("nor felt after", 1e3 * felt);
    QVERIFY(felt <= ramp_down + on_the_way);
    bench.tell('t');
    QVERIFY(bench.pulls());
    QVERIFY(bench.end_touching());
}

} // namespace tp::vm
