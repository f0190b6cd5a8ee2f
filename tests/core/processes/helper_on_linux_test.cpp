// SPDX-License-Identifier: Apache-2.0
// What a helper must not be able to do on Linux, and what it cannot be handed.
#include "asked.hpp"
#include "core/processes/shared_memory.hpp"

#include <QTest>

#include <cerrno>
#include <cstdint>
#include <fcntl.h>
#include <string>
#include <sys/mman.h>
#include <unistd.h>

using namespace tp;
using namespace tp::test;

class HelperOnLinuxTest : public QObject {
    Q_OBJECT

private slots:
    void confined_it_can_do_nothing_else_data() {
        QTest::addColumn<QString>("what");
        for (const char* what :
             {"read a file", "write a file", "make a folder", "remove a file", "reach the network",
              "reach a program", "start a program", "start a process", "signal another",
              "signal another by its descriptor", "signal another with a signal of its choice",
              "hear of its descriptor by signals", "look into another", "map code", "make data code"})
            QTest::newRow(what) << what;
    }
    void confined_it_can_do_nothing_else() {
        QFETCH(QString, what);
        HelperPool pool(double_program);
        const auto helper = pool.lease();
        QVERIFY2(helper.ok(), helper.error().c_str());
        QCOMPARE(number_in((*helper)->ask(order("try", what.toStdString()))), std::int64_t{EPERM});
        QCOMPARE(text_in((*helper)->ask(order("say", "still here"))), std::string("still here"));
    }

    void its_memory_has_a_limit() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        QSKIP("a sanitizer takes terabytes of addresses for itself");
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
        QSKIP("a sanitizer takes terabytes of addresses for itself");
#endif
#endif
        HelperPool pool(double_program);
        const auto helper = pool.lease();
        QVERIFY(helper.ok());
        QCOMPARE(number_in((*helper)->ask(order("try", "take much memory"))), std::int64_t{ENOMEM});
    }

    void nothing_that_is_open_reaches_it() {
        const int leaky = ::dup(0); // one that is not closed when a program is started
        HelperPool pool(double_program);
        const auto helper = pool.lease();
        QVERIFY(helper.ok());
        QCOMPARE(number_in((*helper)->ask(order("try", "count what is open"))), std::int64_t{4});
        ::close(leaky);
    }

    void memory_whose_size_can_still_change_is_not_looked_at() {
        const Descriptor memory(::memfd_create("test", MFD_CLOEXEC | MFD_ALLOW_SEALING));
        QVERIFY(memory.ok() && ::ftruncate(memory.number(), 5000) == 0);
        QVERIFY(!received(memory).has_value());
        QCOMPARE(::fcntl(memory.number(), F_ADD_SEALS, F_SEAL_GROW), 0);
        QVERIFY(!received(memory).has_value());
        QCOMPARE(::fcntl(memory.number(), F_ADD_SEALS, F_SEAL_SHRINK), 0);
        QVERIFY(received(memory).has_value());
    }

    void what_is_no_shared_memory_is_not_looked_at() {
        const Descriptor file(::open("/proc/self/exe", O_RDONLY | O_CLOEXEC));
        QVERIFY(file.ok());
        QVERIFY(!received(file).has_value());
        QVERIFY(!received(Descriptor()).has_value());
    }

    void memory_that_is_handed_over_becomes_no_smaller() { // under the reader's hands, which would end it
        HelperPool pool(double_program);
        const auto helper = pool.lease();
        QVERIFY(helper.ok());
        auto answer = (*helper)->ask(order("share", "100000"));
        auto* const message = std::get_if<Message>(&answer);
        QVERIFY(message != nullptr);
        MessageReader reader(*message);
        reader.number();
        const auto view = received(reader.descriptor());
        QVERIFY(view.has_value());
        QCOMPARE(number_in((*helper)->ask(order("try", "shrink what is shared"))), std::int64_t{EPERM});
    }
};

QTEST_GUILESS_MAIN(HelperOnLinuxTest)
#include "helper_on_linux_test.moc"
