// SPDX-License-Identifier: Apache-2.0
#include "app/shell/end_signals.hpp"

#include <QSignalSpy>
#include <QTest>

#include <csignal>

using namespace tp;

namespace {

/// What would happen at the next one.
bool would_end_the_program(int signal) {
    struct sigaction now {};
    sigaction(signal, nullptr, &now);
    return now.sa_handler == SIG_DFL;
}

} // namespace

class EndSignalsTest : public QObject {
    Q_OBJECT
private slots:
    void the_first_one_is_told_in_the_event_loop_and_the_second_one_ends_the_program_data() {
        QTest::addColumn<int>("signal");
        QTest::newRow("SIGTERM") << SIGTERM;
        QTest::newRow("SIGINT") << SIGINT;
        QTest::newRow("SIGHUP") << SIGHUP;
    }
    void the_first_one_is_told_in_the_event_loop_and_the_second_one_ends_the_program() {
        QFETCH(int, signal);
        EndSignals end;
        QSignalSpy asked(&end, &EndSignals::asked);
        QVERIFY(!would_end_the_program(signal));
        ::raise(signal);
        QCOMPARE(asked.size(), 0); // not in the handler
        QTRY_COMPARE(asked.size(), 1);
        QVERIFY(would_end_the_program(signal));
    }
    void afterwards_all_is_as_it_was_before() {
        struct sigaction before {
        }, after{};
        sigaction(SIGTERM, nullptr, &before);
        { const EndSignals end; }
        sigaction(SIGTERM, nullptr, &after);
        QVERIFY(after.sa_handler == before.sa_handler);
    }
};

QTEST_GUILESS_MAIN(EndSignalsTest)
#include "end_signals_test.moc"
