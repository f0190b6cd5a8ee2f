// SPDX-License-Identifier: Apache-2.0
#include "core/servo/real_time.hpp"

#include <QFile>
#include <QTest>

#include <cstdint>
#include <linux/capability.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <thread>
#include <unistd.h>
#include <vector>

using namespace tp;

namespace {

/// What of this process is kept in memory, KiB.
long locked_kib() {
    QFile status("/proc/self/status");
    if (!status.open(QIODevice::ReadOnly))
        return -1;
    for (const QByteArray& line : status.readAll().split('\n'))
        if (line.startsWith("VmLck:"))
            return line.simplified().split(' ').value(1).toLong();
    return -1;
}

/// The sanitizers' runtime says that it locks, and does not.
bool can_lock() {
    std::vector<char> probe(256 * 1024, 'p');
    const long before = locked_kib();
    const bool locked = mlock(probe.data(), probe.size()) == 0 && locked_kib() >= before + 256;
    munlock(probe.data(), probe.size());
    return locked;
}

/// As sched_getattr(2) has them.
struct SchedulingAttributes {
    std::uint32_t size = sizeof(SchedulingAttributes);
    std::uint32_t policy = 0;
    std::uint64_t flags = 0;
    std::int32_t nice = 0;
    std::uint32_t priority = 0;
    std::uint64_t runtime_ns = 0;
    std::uint64_t deadline_ns = 0;
    std::uint64_t period_ns = 0;
};

/// The calling thread may do no more than an ordinary person's.
bool give_up_priorities() {
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    __user_cap_data_struct may[2] = {};
    if (syscall(SYS_capget, &header, may) != 0)
        return false;
    may[0].effective &= ~(1U << CAP_SYS_NICE);
    return syscall(SYS_capset, &header, may) == 0;
}

} // namespace

class RealTimeTest : public QObject {
    Q_OBJECT
private slots:
    /// No tick waits for a disk: the loop's own data and 64 KiB of its stack stay where they are.
    void what_is_locked_stays_in_memory_until_it_is_forgotten() {
        if (!can_lock())
            QSKIP("Nothing is locked in memory here, by the system's word or a sanitizer's.");
        std::vector<char> data(128 * 1024, 'd');
        const long before = locked_kib();
        QVERIFY(lock_memory(data.data(), data.size()));
        const long locked = locked_kib() - before;
        QVERIFY2(locked >= 128 + 64, qPrintable(QString::number(locked)));
        QVERIFY2(locked <= 128 + 64 + 16, qPrintable(QString::number(locked))); // whole pages
        forget_memory(data.data(), data.size());
        QVERIFY(locked_kib() - before <= 64 + 8); // the stack goes with the thread
    }

    /// Where the system gives the priority, it is the one that was asked for, and it is said.
    void the_priority_asked_for_is_the_one_given() {
        bool possible = false, said = false;
        int given = 0;
        std::thread([&] {
            sched_param lowest{};
            lowest.sched_priority = 1;
            possible = sched_setscheduler(0, SCHED_FIFO, &lowest) == 0;
        }).join();
        std::thread([&] {
            said = prefer_real_time(3);
            sched_param now{};
            sched_getparam(0, &now);
            given = now.sched_priority;
        }).join();
        QCOMPARE(said, possible);
        QCOMPARE(given, possible ? 3 : 0);
    }

    /// Where it does not, a thread that works shortly and often comes before those that compute for long.
    void without_the_priority_the_shortest_slice_is_asked_for() {
        bool said = false, given = false, asked = false;
        std::uint64_t slice_ns = 0;
        int nice = 0;
        std::thread([&] {
            if (!give_up_priorities())
                return;
            setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), 7);
            said = prefer_real_time(3);
            given = sched_getscheduler(0) == SCHED_FIFO;
            SchedulingAttributes now;
            asked = syscall(SYS_sched_getattr, 0, &now, sizeof now, 0U) == 0;
            slice_ns = now.runtime_ns;
            nice = now.nice;
        }).join();
        QCOMPARE(said, given);
        if (given || !asked || slice_ns == 0)
            QSKIP("This system gives everybody real-time priority, or says nothing of slices.");
        QCOMPARE(slice_ns, std::uint64_t(100'000));
        QCOMPARE(nice, 7); // and it stays as polite as it was
    }

    void memory_that_is_not_there_is_not_locked() {
        if (!can_lock())
            QSKIP("Nothing is locked in memory here, by the system's word or a sanitizer's.");
        const auto nowhere = reinterpret_cast<const void*>(std::uintptr_t(4096)); // no process has that page
        QVERIFY(!lock_memory(nowhere, 4096));
    }
};

QTEST_APPLESS_MAIN(RealTimeTest)
#include "real_time_test.moc"
