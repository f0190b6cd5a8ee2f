// SPDX-License-Identifier: Apache-2.0
#include "device/latest_writer.hpp"

#include <QObject>
#include <QTest>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <semaphore>
#include <thread>
#include <vector>

using tp::LatestWriter;

namespace {

/// Remembers what was sent; fails or hangs when told to.
class Wire final : public LatestWriter::Sink {
public:
    bool send(std::uint64_t message) noexcept override {
        if (hangs) {
            hanging.release();
            let_go.acquire();
        }
        const std::lock_guard lock(mutex_);
        sent_.push_back(message);
        return !broken;
    }
    std::vector<std::uint64_t> sent() const {
        const std::lock_guard lock(mutex_);
        return sent_;
    }
    bool broken = false;
    std::atomic<bool> hangs{false};
    std::counting_semaphore<8> hanging{0};
    std::counting_semaphore<8> let_go{0};

private:
    mutable std::mutex mutex_;
    std::vector<std::uint64_t> sent_;
};

} // namespace

class LatestWriterTest : public QObject {
    Q_OBJECT

private slots:
    void only_the_newest_is_sent_and_only_once() {
        const auto wire = std::make_shared<Wire>();
        LatestWriter writer(wire, 0, LatestWriter::Thread::caller);
        writer.deliver();
        QVERIFY(wire->sent().empty());
        writer.post(1);
        writer.post(2);
        writer.deliver();
        writer.deliver();
        QCOMPARE(wire->sent(), std::vector<std::uint64_t>{2});
        writer.post(2); // the same again is news: the device's watchdog wants to hear it
        writer.deliver();
        QCOMPARE(wire->sent(), (std::vector<std::uint64_t>{2, 2}));
    }

    void it_ends_with_the_last_message_and_sends_no_more() {
        for (const auto thread : {LatestWriter::Thread::caller, LatestWriter::Thread::own}) {
            const auto wire = std::make_shared<Wire>();
            LatestWriter writer(wire, 9, thread);
            writer.post(7);
            QVERIFY(writer.end());
            QVERIFY(!wire->sent().empty());
            QCOMPARE(wire->sent().back(), std::uint64_t{9});
            const std::size_t before = wire->sent().size();
            writer.post(8);
            writer.deliver();
            QVERIFY(writer.end());
            QCOMPARE(wire->sent().size(), before);
        }
    }

    void a_write_that_fails_or_a_back_end_that_knows_loses_the_device() {
        const auto wire = std::make_shared<Wire>();
        LatestWriter writer(wire, 0, LatestWriter::Thread::caller);
        wire->broken = true;
        writer.post(1);
        QVERIFY(!writer.lost());
        writer.deliver();
        QVERIFY(writer.lost());
        writer.post(2);
        writer.deliver();
        QCOMPARE(wire->sent().size(), std::size_t{1});

        const auto other = std::make_shared<Wire>();
        LatestWriter told(other, 0, LatestWriter::Thread::own);
        told.lose();
        QVERIFY(told.lost());
        QVERIFY(told.end());
    }

    void one_that_hangs_is_left_behind_with_its_wire() {
        const auto wire = std::make_shared<Wire>();
        {
            LatestWriter writer(wire, 0, LatestWriter::Thread::own);
            wire->hangs = true;
            writer.post(5);
            wire->hanging.acquire();
            QVERIFY(!writer.end());
            QVERIFY(!writer.end());
            QVERIFY(wire.use_count() > 1);
        }
        wire->hangs = false;
        wire->let_go.release();
        while (wire.use_count() > 1) // the thread sends the end, and goes
            std::this_thread::yield();
        QCOMPARE(wire->sent(), (std::vector<std::uint64_t>{5, 0}));
    }
};

QTEST_APPLESS_MAIN(LatestWriterTest)
#include "latest_writer_test.moc"
