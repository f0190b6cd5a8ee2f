// SPDX-License-Identifier: Apache-2.0
#include "core/servo/snapshot.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <sched.h>
#include <thread>
#include <type_traits>

namespace snapshot_test {

using tp::Published;

class SnapshotTest : public QObject {
    Q_OBJECT
private slots:
    void is_never_torn() {
        struct Value {
            std::uint64_t a = 0, b = 0, c = 0;
            std::uint32_t d = 0;
            std::array<std::uint64_t, 100> rest{}; ///< long to write, so that a reader comes in the middle
        };
        Published<Value> published;
        std::atomic<bool> stop{false};
        std::thread writer([&] {
            for (std::uint64_t i = 1; !stop; ++i) {
                Value value{i, 3 * i, ~i, static_cast<std::uint32_t>(i), {}};
                value.rest.fill(i);
                published.publish(value);
            }
        });
        std::uint64_t last = 0;
        int seen = 0;
        bool whole = true;
        while (seen < 20000) {
            const Value value = published.latest();
            if (value.a == 0)
                continue;
            whole = whole && value.b == 3 * value.a && value.c == ~value.a &&
                    value.d == static_cast<std::uint32_t>(value.a) && value.a >= last &&
                    std::count(value.rest.begin(), value.rest.end(), value.a) == 100;
            last = value.a;
            ++seen;
        }
        stop = true;
        writer.join();
        QVERIFY(whole);
        QVERIFY(last > 1);
    }

    /// On one processor the writer loses it at any moment, often in the middle of its writing.
    void what_an_interrupted_writer_leaves_half_done_is_not_seen() {
        cpu_set_t allowed;
        QCOMPARE(sched_getaffinity(0, sizeof allowed, &allowed), 0);
        cpu_set_t one;
        CPU_ZERO(&one);
        for (int cpu = 0; cpu < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++cpu)
            if (CPU_ISSET(cpu, &allowed))
                CPU_SET(cpu, &one);
        sched_setaffinity(0, sizeof one, &one); // the thread that is made next inherits it
        using Value = std::array<std::uint64_t, 100>;
        Published<Value> published;
        std::atomic<bool> stop{false};
        std::thread writer([&] {
            Value value;
            for (std::uint64_t i = 1; !stop; ++i) {
                value.fill(i);
                published.publish(value);
            }
        });
        bool whole = true;
        for (int i = 0; i < 60; ++i) {
            std::this_thread::yield();
            const Value value = published.latest();
            whole = whole && std::count(value.begin(), value.end(), value[0]) == 100;
        }
        stop = true;
        writer.join();
        sched_setaffinity(0, sizeof allowed, &allowed);
        QVERIFY(whole);
    }

    void a_value_of_any_size_comes_out_whole() {
        const auto same = [](const auto& value) {
            Published<std::remove_cvref_t<decltype(value)>> published;
            published.publish(value);
            return published.latest() == value;
        };
        QVERIFY(same(std::array<char, 1>{'a'}));
        QVERIFY(same(std::array<char, 9>{'a', 'b', 'c', 'd', 'e', 'f', 'g', 'h', 'i'}));
        QVERIFY(same(std::array<std::int32_t, 3>{1, 2, 3}));
        QVERIFY(same(std::array<std::int64_t, 2>{-1, -2}));
    }

    /// What a page shows before there is anything to show.
    void a_view_of_nothing_is_at_rest() {
        const tp::ServoSnapshot view;
        QVERIFY(view.finger() == tp::Vec2(0.0) && view.force() == tp::Vec2(0.0));
        QVERIFY(view.nearest_x == 0.0 && view.nearest_y == 0.0 && view.distance == 0.0);
        QVERIFY(view.time == 0.0 && view.gain == 0.0 && view.tour_progress == 0.0 &&
                view.worst_lateness == 0.0);
        QVERIFY(view.ticks == 0 && view.scene == 0 && view.contour == -1 && view.buttons == 0);
        QVERIFY(view.fault == tp::Fault::none && !view.engaged && !view.touring && !view.tour_finished);
    }

    void starts_as_zeroes() { QCOMPARE(Published<double>().latest(), 0.0); }
};

} // namespace snapshot_test

TP_TEST(snapshot_test, SnapshotTest, nothing)
#include "snapshot_test.moc"
