// SPDX-License-Identifier: Apache-2.0
#include "core/processes/foreign_decoder_linux.hpp"
#include "core/processes/helper_linux.hpp"
#include "core/processes/shared_memory_linux.hpp"

#include <QFile>
#include <QTest>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <fcntl.h>
#include <string>
#include <sys/mman.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

using namespace tp;
using std::chrono::milliseconds;

namespace {

const std::filesystem::path double_program = beside_this_program("helper_double");

Message order(std::string_view word, std::string_view object = {}) {
    return MessageWriter().add(word).add(object).take();
}

std::string text_in(std::variant<Message, NoAnswer> answer) {
    auto* const message = std::get_if<Message>(&answer);
    return message ? MessageReader(*message).text() : std::string("no answer");
}

std::int64_t number_in(std::variant<Message, NoAnswer> answer) {
    auto* const message = std::get_if<Message>(&answer);
    return message ? MessageReader(*message).number() : std::int64_t{-2};
}

/// No answer's reason, as text for a comparison.
QString reason_in(const std::variant<Message, NoAnswer>& answer) {
    const auto* const none = std::get_if<NoAnswer>(&answer);
    return none == nullptr ? "an answer" : *none == NoAnswer::gone ? "gone" : "too long";
}

/// Of processes that this one has started and not yet waited for.
int processes() {
    QFile list(QString("/proc/self/task/%1/children").arg(getpid()));
    return list.open(QIODevice::ReadOnly) ? static_cast<int>(list.readAll().split(' ').size()) - 1 : -1;
}

} // namespace

class HelperTest : public QObject {
    Q_OBJECT

private slots:
    void it_answers_again_and_again() {
        HelperPool pool(double_program);
        const auto helper = pool.lease();
        QVERIFY2(helper.ok(), helper.error().c_str());
        for (int i = 0; i < 100; ++i)
            QCOMPARE(text_in((*helper)->ask(order("say", std::to_string(i)))), std::to_string(i));
    }

    void its_memory_for_pictures_lies_in_large_pages_whatever_else_is_set() {
        qputenv("GLIBC_TUNABLES", "glibc.malloc.perturb=0");
        qputenv("TOUCHPHOTO_TEST_SETTING", "kept");
        HelperPool pool(double_program);
        const auto helper = pool.lease();
        QVERIFY2(helper.ok(), helper.error().c_str());
        QCOMPARE(text_in((*helper)->ask(order("tell a setting", "GLIBC_TUNABLES"))),
                 std::string("glibc.malloc.hugetlb=1"));
        QCOMPARE(text_in((*helper)->ask(order("tell a setting", "TOUCHPHOTO_TEST_SETTING"))),
                 std::string("kept"));
        qunsetenv("GLIBC_TUNABLES");
        qunsetenv("TOUCHPHOTO_TEST_SETTING");
    }

    void what_is_told_is_not_answered() {
        HelperPool pool(double_program);
        const auto helper = pool.lease();
        QVERIFY(helper.ok());
        (*helper)->tell(order("forget it"));
        QCOMPARE(text_in((*helper)->ask(order("say", "next"))), std::string("next"));
    }

    void confined_it_can_do_nothing_else_data() {
        QTest::addColumn<QString>("what");
        for (const char* what : {"read a file", "write a file", "make a folder", "remove a file",
                                 "reach the network", "reach a program", "start a program", "start a process",
                                 "signal another", "look into another", "map code", "make data code"})
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

    void confined_it_can_still_compute() {
        HelperPool pool(double_program);
        const auto helper = pool.lease();
        QVERIFY(helper.ok());
        QCOMPARE(number_in((*helper)->ask(order("try", "start a thread"))), std::int64_t{0});
        QCOMPARE(number_in((*helper)->ask(order("try", "take little memory"))), std::int64_t{0});
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
        QCOMPARE(number_in((*helper)->ask(order("count descriptors"))), std::int64_t{4});
        ::close(leaky);
    }

    void one_that_ends_is_one_sentence_and_the_next_is_another() {
        HelperPool pool(double_program);
        for (const char* way : {"crash", "leave"}) {
            {
                const auto helper = pool.lease();
                QVERIFY(helper.ok());
                QCOMPARE(reason_in((*helper)->ask(order(way))), QString("gone"));
                QCOMPARE(reason_in((*helper)->ask(order("say", "something"))), QString("gone"));
            }
            const auto next = pool.lease();
            QVERIFY(next.ok());
            QCOMPARE(text_in((*next)->ask(order("say", "well"))), std::string("well"));
        }
    }

    void one_that_takes_too_long_is_ended_data() {
        QTest::addColumn<QString>("way");
        QTest::newRow("computing") << "compute for ever";
        QTest::newRow("sleeping") << "do nothing";
    }
    void one_that_takes_too_long_is_ended() {
        QFETCH(QString, way);
        HelperPatience short_one;
        short_one.computed = milliseconds(50);
        short_one.still = milliseconds(200);
        HelperPool pool(double_program, {}, short_one);
        {
            const auto helper = pool.lease();
            QVERIFY(helper.ok());
            QCOMPARE(reason_in((*helper)->ask(order(way.toStdString()))), QString("too long"));
        }
        QCOMPARE(processes(), 0);
        const auto next = pool.lease();
        QCOMPARE(text_in((*next)->ask(order("say", "well"))), std::string("well"));
    }

    void computing_is_not_taken_for_standing_still() {
        HelperPatience patience;
        patience.still = milliseconds(1500); // a busy computer may keep it waiting for some of that
        HelperPool pool(double_program, {}, patience);
        const auto helper = pool.lease();
        QVERIFY(helper.ok());
        QCOMPARE(text_in((*helper)->ask(order("compute for two seconds", "done"))), std::string("done"));
    }

    void the_same_one_is_used_again() {
        HelperPool pool(double_program);
        for (int i = 0; i < 5; ++i) {
            const auto helper = pool.lease();
            QVERIFY(helper.ok());
            QCOMPARE(text_in((*helper)->ask(order("say", "a"))), std::string("a"));
            QCOMPARE(processes(), 1);
        }
    }

    void one_that_was_killed_while_idle_is_replaced() {
        HelperPool pool(double_program);
        QVERIFY(pool.lease().ok());
        QFile list(QString("/proc/self/task/%1/children").arg(getpid()));
        QVERIFY(list.open(QIODevice::ReadOnly));
        const pid_t idle = list.readAll().trimmed().toInt();
        QVERIFY(idle > 0);
        ::kill(idle, SIGKILL);
        siginfo_t ended{};
        QCOMPARE(::waitid(P_PID, static_cast<id_t>(idle), &ended, WEXITED | WNOWAIT), 0);
        const auto helper = pool.lease();
        QVERIFY(helper.ok());
        QCOMPARE(text_in((*helper)->ask(order("say", "well"))), std::string("well"));
        QCOMPARE(processes(), 1);
    }

    void each_thread_has_its_own() {
        HelperPool pool(double_program);
        std::atomic<int> right = 0;
        std::vector<std::thread> threads;
        for (int t = 0; t < 4; ++t)
            threads.emplace_back([&, t] {
                for (int i = 0; i < 20; ++i) {
                    const auto helper = pool.lease();
                    if (!helper.ok())
                        continue;
                    if (t == 0) // ends its own, and nobody else's
                        right += reason_in((*helper)->ask(order("crash"))) == "gone" ? 1 : 0;
                    else
                        right += text_in((*helper)->ask(order("say", std::to_string(t)))) == std::to_string(t)
                                     ? 1
                                     : 0;
                }
            });
        for (std::thread& thread : threads)
            thread.join();
        QCOMPARE(right.load(), 80);
    }

    void none_outlives_its_pool() {
        {
            HelperPool pool(double_program);
            const auto one = pool.lease();
            const auto two = pool.lease();
            QVERIFY(one.ok() && two.ok());
            QCOMPARE(processes(), 2);
        }
        QCOMPARE(processes(), 0);
    }

    void what_is_not_there_is_a_sentence() {
        HelperPool pool("/nowhere/touchphoto-decoder");
        const auto helper = pool.lease();
        QVERIFY(!helper.ok());
        QVERIFY2(helper.error().find("touchphoto-decoder") != std::string::npos, helper.error().c_str());
    }

    void what_is_no_helper_is_a_sentence() {
        HelperPool pool("/bin/true");
        QVERIFY(!pool.lease().ok());
    }

    void memory_comes_back_as_it_was_written() {
        HelperPool pool(double_program);
        const auto helper = pool.lease();
        QVERIFY(helper.ok());
        auto answer = (*helper)->ask(order("share", "100000"));
        auto* const message = std::get_if<Message>(&answer);
        QVERIFY(message != nullptr);
        MessageReader reader(*message);
        QCOMPARE(reader.number(), std::int64_t{100'000});
        QVERIFY(reader.has_descriptor());
        const auto view = received(reader.descriptor());
        QVERIFY(!reader.has_descriptor() && view.has_value());
        QCOMPARE(view->size(), std::size_t{100'000});
        const auto* const bytes = static_cast<const unsigned char*>(view->data());
        QVERIFY(std::all_of(bytes, bytes + 100'000, [](unsigned char byte) { return byte == 7; }));
        // What became smaller under the reader's hands would end it.
        QCOMPARE(number_in((*helper)->ask(order("try", "shrink what is shared"))), std::int64_t{EPERM});
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
};

QTEST_GUILESS_MAIN(HelperTest)
#include "helper_test.moc"
