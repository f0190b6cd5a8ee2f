// SPDX-License-Identifier: Apache-2.0
#include "app/parts/work/latest_task.hpp"

#include <QCoreApplication>
#include <QSemaphore>
#include <QTest>
#include <QThread>

#include <new>
#include <vector>

using tp::LatestTask;

class LatestTaskTest : public QObject {
    Q_OBJECT
private slots:
    void is_done_elsewhere_and_answered_here() {
        LatestTask work;
        QThread* done_on = nullptr;
        QThread* answered_on = nullptr;
        work.ask([&](const std::stop_token&) -> LatestTask::Answer {
            done_on = QThread::currentThread();
            return [&] { answered_on = QThread::currentThread(); };
        });
        QVERIFY(work.busy());
        QTRY_VERIFY(!work.busy());
        QVERIFY(done_on != nullptr && done_on != QThread::currentThread());
        QCOMPARE(answered_on, QThread::currentThread());
    }

    void only_the_newest_of_many_wishes_is_answered_and_the_older_ones_are_stopped_or_not_begun() {
        LatestTask work;
        QSemaphore begun, go_on;
        std::vector<int> did, answered; // `did`: only the work's thread, until it is not busy
        bool told_to_stop = false;
        work.ask([&](const std::stop_token& stop) -> LatestTask::Answer {
            did.push_back(0);
            begun.release();
            go_on.acquire();
            told_to_stop = stop.stop_requested();
            return [&] { answered.push_back(0); };
        });
        begun.acquire();
        for (int wish = 1; wish <= 5; ++wish)
            work.ask([&, wish](const std::stop_token& stop) -> LatestTask::Answer {
                did.push_back(wish);
                return [&answered, wish, stopped = stop.stop_requested()] {
                    answered.push_back(stopped ? -wish : wish);
                };
            });
        go_on.release();
        QTRY_VERIFY(!work.busy());
        QVERIFY(told_to_stop);
        QCOMPARE(did, (std::vector<int>{0, 5}));
        QCOMPARE(answered, std::vector<int>{5});
    }

    void what_is_cancelled_is_not_answered_though_it_had_ended() {
        LatestTask work;
        QSemaphore ended;
        bool answered = false;
        work.ask([&](const std::stop_token&) -> LatestTask::Answer {
            ended.release();
            return [&] { answered = true; };
        });
        ended.acquire();
        work.cancel();
        QVERIFY(!work.busy());
        work.ask([&](const std::stop_token&) { return LatestTask::Answer(); });
        QTRY_VERIFY(!work.busy()); // an answer of the first would have come before
        QVERIFY(!answered);
    }

    void an_answer_may_ask_again() {
        LatestTask work;
        int answers = 0;
        work.ask([&](const std::stop_token&) -> LatestTask::Answer {
            return [&] {
                ++answers;
                work.ask([&](const std::stop_token&) -> LatestTask::Answer { return [&] { ++answers; }; });
            };
        });
        QTRY_COMPARE(answers, 2);
        QVERIFY(!work.busy());
    }

    void what_throws_ends_without_an_answer() {
        LatestTask work;
        work.ask([](const std::stop_token&) -> LatestTask::Answer { throw std::bad_alloc(); });
        QTRY_VERIFY(!work.busy());
        bool answered = false;
        work.ask([&](const std::stop_token&) -> LatestTask::Answer { return [&] { answered = true; }; });
        QTRY_VERIFY(answered);
    }

    void its_end_stops_what_is_under_way_and_waits_for_it() {
        bool ended = false;
        bool answered = false;
        QSemaphore begun;
        {
            LatestTask work;
            work.ask([&](const std::stop_token& stop) -> LatestTask::Answer {
                begun.release();
                while (!stop.stop_requested())
                    QThread::yieldCurrentThread();
                ended = true;
                return [&] { answered = true; };
            });
            begun.acquire();
        }
        QVERIFY(ended);
        QCoreApplication::processEvents();
        QVERIFY(!answered);
    }
};

QTEST_GUILESS_MAIN(LatestTaskTest)
#include "latest_task_test.moc"
