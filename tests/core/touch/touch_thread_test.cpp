// SPDX-License-Identifier: Apache-2.0
// What the touch loop asks of the system for its thread.
#include "core/touch/touch_loop.hpp"
#include "touch_output_double.hpp"

#include <QByteArray>
#include <QFile>
#include <QTest>

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <sched.h>
#include <sys/mman.h>
#include <thread>
#include <vector>

using namespace tp;
using namespace tp::testing;

namespace {

/// No page with it leaves this machine's memory, by what the kernel says of its mapping.
bool stays_in_memory(const void* data) {
    QFile maps("/proc/self/smaps");
    if (!maps.open(QIODevice::ReadOnly))
        return false;
    const auto address = reinterpret_cast<std::uintptr_t>(data);
    bool here = false;
    for (const QByteArray& line : maps.readAll().split('\n')) {
        const QByteArray range = line.left(line.indexOf(' '));
        if (const qsizetype dash = range.indexOf('-'); dash > 0 && !range.endsWith(':'))
            here = range.left(dash).toULongLong(nullptr, 16) <= address &&
                   address < range.mid(dash + 1).toULongLong(nullptr, 16);
        if (here && line.startsWith("VmFlags:"))
            return line.contains(" lo");
    }
    return false;
}

/// The sanitizers' runtime says that it locks, and does not.
bool can_lock() {
    std::vector<char> probe(256 * 1024, 'p');
    const bool locked = mlock(probe.data(), probe.size()) == 0 && stays_in_memory(probe.data() + 128 * 1024);
    munlock(probe.data(), probe.size());
    return locked;
}

/// Of the thread that calls it: its real-time priority, 0 where it has none.
int priority() {
    sched_param now{};
    sched_getparam(0, &now);
    return now.sched_priority;
}

} // namespace

class TouchThreadTest : public QObject {
    Q_OBJECT
private slots:
    void it_comes_just_after_a_forces_loop_where_the_system_lets_it() {
        int possible = 0;
        std::thread([&] {
            sched_param lowest{};
            lowest.sched_priority = 1;
            possible = sched_setscheduler(0, SCHED_FIFO, &lowest) == 0 ? 19 : 0;
        }).join();
        std::atomic<int> given{-1};
        TouchOutputDouble output;
        output.pad = [&](double) {
            given = priority();
            return std::optional<PadTouch>();
        };
        SteadyClock clock;
        TouchLoop loop(output, output.capabilities(), clock, {});
        loop.start();
        QTRY_VERIFY(given >= 0);
        loop.stop();
        QCOMPARE(given.load(), possible);
    }

    void what_it_works_with_stays_in_memory_while_it_runs() {
        if (!can_lock())
            QSKIP("Nothing is locked in memory here, by the system's word or a sanitizer's.");
        TouchOutputDouble output;
        SteadyClock clock;
        const auto loop = std::make_unique<TouchLoop>(output, output.capabilities(), clock, TouchSettings{});
        QVERIFY(!stays_in_memory(loop.get()));
        loop->start();
        QTRY_VERIFY(stays_in_memory(loop.get()));
        loop->stop();
        QVERIFY(!stays_in_memory(loop.get()));
    }
};

QTEST_GUILESS_MAIN(TouchThreadTest)
#include "touch_thread_test.moc"
