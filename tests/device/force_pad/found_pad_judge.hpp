// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "found_pad_bench.hpp"

#include <QTest>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>

/// What is asked of a pad behind either of its interfaces.
namespace tp {

inline void judge_a_thousand_frames(FoundPadBench& bench) {
    QVERIFY2(bench.loop, bench.error.c_str());
    for (int i = 0; i < 1000; ++i)
        bench.tick(true);
    const ServoSnapshot view = bench.loop->snapshot();
    QCOMPARE(view.fault, Fault::none);
    QVERIFY(std::abs(view.x - 10.0) < 0.1);
    QVERIFY(view.y < 2.0); // drawn to the line
    QCOMPARE(bench.device->bad_frames(), std::uint64_t(0));
}

template <typename Unplug>
void judge_unplugged_in_mid_touch(FoundPadBench& bench, Unplug unplug) {
    QVERIFY2(bench.loop, bench.error.c_str());
    for (int i = 0; i < 300; ++i)
        bench.tick(true);
    QCOMPARE(bench.loop->snapshot().fault, Fault::none);
    unplug();
    bench.until([&] { return bench.loop->snapshot().fault == Fault::device_lost; });
    QVERIFY(bench.loop->snapshot().force() == Vec2(0.0));
    bench.loop->stop();
    QVERIFY(!bench.device->write(SafeForce{}));
}

template <typename Silence, typename Speak>
void judge_silent_for_a_while(FoundPadBench& bench, Silence silence, Speak speak) {
    QVERIFY2(bench.loop, bench.error.c_str());
    for (int i = 0; i < 700; ++i)
        bench.tick(true);
    QVERIFY(bench.loop->snapshot().gain == 1.0);
    silence();
    QVERIFY(bench.ticks_until_let_go() <= 60);
    speak();
    bench.until([&] { return bench.loop->snapshot().fault == Fault::none; });
}

/// The rows of devices with the same ids that are no pad.
inline void other_devices() {
    QTest::addColumn<bool>("silent");
    QTest::newRow("says other things") << false;
    QTest::newRow("says nothing") << true;
}
inline void judge_another_device(const FoundPadBench& bench) {
    QVERIFY(!bench.loop);
    QVERIFY2(bench.error.find("does not answer like a force pad") != std::string::npos, bench.error.c_str());
}

/// What opening it came to, without permission.
inline void judge_without_permission(const Result<std::unique_ptr<ReportTransport>>& opened) {
    QVERIFY(!opened.ok());
    QVERIFY2(opened.error().find("udev/rules.d") != std::string::npos, opened.error().c_str());
}

} // namespace tp
