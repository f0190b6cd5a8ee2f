// SPDX-License-Identifier: Apache-2.0
// One thread scans while others ask, each with a connection of its own.
#include "app/album/index/album_queries.hpp"
#include "test_album.hpp"
#include "test_program.hpp"

#include <QTest>

#include <atomic>
#include <thread>

namespace threads_test {

using namespace tp;
using namespace tp::testing;

class ThreadsTest : public QObject {
    Q_OBJECT

private slots:
    void pages_are_asked_for_during_a_scan_data() {
        QTest::addColumn<bool>("memory");
        QTest::newRow("file") << false;
        QTest::newRow("memory") << true;
    }

    void pages_are_asked_for_during_a_scan() {
        QFETCH(bool, memory);
        TestAlbum album;
        SyntheticAlbum(1).write(album.root(), 600);
        auto index = memory ? AlbumIndex::in_memory() : AlbumIndex::open(album.cache());
        std::atomic<bool> done = false;
        std::atomic<int> faults = 0, answers = 0;
        const auto ask = [&] {
            auto mine = index->another();
            AlbumQueries queries(*mine);
            do {
                const auto page = queries.page(AllByTime{}, {}, 50);
                const auto matches = queries.search("a", 20);
                const auto suggestions = queries.suggestions("a", 5);
                faults += page.ok() && matches.ok() && suggestions.ok() ? 0 : 1;
                ++answers;
            } while (!done);
        };
        std::vector<std::jthread> threads;
        threads.emplace_back(ask);
        threads.emplace_back(ask);
        std::jthread([&] {
            auto mine = index->another();
            faults += album.scan(*mine).ok() ? 0 : 1;
        }).join();
        done = true;
        threads.clear();
        QCOMPARE(faults.load(), 0);
        QVERIFY(answers >= 2);
        QCOMPARE(index->totals().value().photos, std::size_t(600));
        QCOMPARE(index->dump().value(), album.fresh_dump());
    }
};

} // namespace threads_test

TP_TEST(threads_test, ThreadsTest, event_loop)
#include "threads_test.moc"
