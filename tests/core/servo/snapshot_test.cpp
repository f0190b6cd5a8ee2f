// SPDX-License-Identifier: Apache-2.0
#include "core/servo/snapshot.hpp"

#include <QTest>

#include <thread>

using tp::Published;

class SnapshotTest : public QObject {
    Q_OBJECT
private slots:
    void is_never_torn() {
        struct Value {
            std::uint64_t a = 0, b = 0, c = 0;
            std::uint32_t d = 0;
        };
        Published<Value> published;
        std::atomic<bool> stop{false};
        std::thread writer([&] {
            for (std::uint64_t i = 1; !stop; ++i)
                published.publish({i, 3 * i, ~i, static_cast<std::uint32_t>(i)});
        });
        std::uint64_t last = 0;
        int seen = 0;
        bool whole = true;
        while (seen < 20000) {
            const Value value = published.latest();
            if (value.a == 0)
                continue;
            whole = whole && value.b == 3 * value.a && value.c == ~value.a &&
                    value.d == static_cast<std::uint32_t>(value.a) && value.a >= last;
            last = value.a;
            ++seen;
        }
        stop = true;
        writer.join();
        QVERIFY(whole);
        QVERIFY(last > 1);
    }

    void starts_as_zeroes() { QCOMPARE(Published<double>().latest(), 0.0); }
};

QTEST_APPLESS_MAIN(SnapshotTest)
#include "snapshot_test.moc"
