// SPDX-License-Identifier: Apache-2.0
#include "asked.hpp"
#include "core/files/open_file.hpp"
#include "core/processes/shared_memory.hpp"
#include "own_processes.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

using namespace tp;
using namespace tp::test;
using std::chrono::milliseconds;

namespace {

#if defined(_WIN32)
constexpr std::size_t shared_at_once = 4096; ///< bytes: whole pages
#else
constexpr std::size_t shared_at_once = 1;
#endif

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

    void the_words_it_is_started_with_come_as_they_are() {
        for (const char* word : {"two words", "a\"quotation\\\"mark", "ends with \\", "", "C:\\x\\ y\\\\"}) {
            HelperPool pool(double_program, {word});
            const auto helper = pool.lease();
            QVERIFY2(helper.ok(), word);
            QCOMPARE(text_in((*helper)->ask(order("say your word"))), std::string(word));
        }
    }

    void what_is_told_is_not_answered() {
        HelperPool pool(double_program);
        const auto helper = pool.lease();
        QVERIFY(helper.ok());
        (*helper)->tell(order("forget it"));
        QCOMPARE(text_in((*helper)->ask(order("say", "next"))), std::string("next"));
    }

    void confined_it_can_still_compute() {
        HelperPool pool(double_program);
        const auto helper = pool.lease();
        QVERIFY(helper.ok());
        QCOMPARE(number_in((*helper)->ask(order("try", "start a thread"))), std::int64_t{0});
        QCOMPARE(number_in((*helper)->ask(order("try", "take little memory"))), std::int64_t{0});
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
        QCOMPARE(own_processes(), 0);
        const auto next = pool.lease();
        QCOMPARE(text_in((*next)->ask(order("say", "well"))), std::string("well"));
    }

    void computing_is_not_taken_for_standing_still() {
        if (in_wine)
            QSKIP("Wine does not count what another process has computed");
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
            QCOMPARE(own_processes(), 1);
        }
    }

    void one_that_was_killed_while_idle_is_replaced() {
        HelperPool pool(double_program);
        QVERIFY(pool.lease().ok());
        QCOMPARE(kill_own_processes(), 1);
        const auto helper = pool.lease();
        QVERIFY(helper.ok());
        QCOMPARE(text_in((*helper)->ask(order("say", "well"))), std::string("well"));
        QCOMPARE(own_processes(), 1);
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
            QCOMPARE(own_processes(), 2);
        }
        QCOMPARE(own_processes(), 0);
    }

    void what_is_not_there_is_a_sentence() {
        HelperPool pool("/nowhere/touchphoto-decoder");
        const auto helper = pool.lease();
        QVERIFY(!helper.ok());
        QVERIFY2(helper.error().find("touchphoto-decoder") != std::string::npos, helper.error().c_str());
    }

    void what_is_no_helper_is_a_sentence() {
        HelperPool pool(beside_this_program("helper_finder"));
        QVERIFY(!pool.lease().ok());
    }

    void a_file_that_is_handed_over_can_be_read() {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("file").toStdString();
        std::ofstream(path) << "its bytes";
        HelperPool pool(double_program);
        const auto helper = pool.lease();
        QVERIFY(helper.ok());
        const Message with_file =
            MessageWriter().add("read").add("").hand_over(OpenFile(path, {}).handed_over()).take();
        QCOMPARE(text_in((*helper)->ask(with_file)), std::string("its bytes"));
    }

    void messages_of_every_length_come_whole() {
        HelperPool pool(double_program);
        const auto helper = pool.lease();
        QVERIFY(helper.ok());
        const std::size_t room = longest_message - order("say").bytes.size();
        for (const std::size_t length : {std::size_t{0}, std::size_t{4096}, room - 1, room}) {
            const std::string text(length, 'x');
            QVERIFY(text_in((*helper)->ask(order("say", text))) == text);
        }
        QCOMPARE(reason_in((*helper)->ask(order("say", std::string(room + 1, 'x')))), QString("gone"));
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
        QCOMPARE(view->size(), (std::size_t{100'000} + shared_at_once - 1) / shared_at_once * shared_at_once);
        const auto* const bytes = static_cast<const unsigned char*>(view->data());
        QVERIFY(std::all_of(bytes, bytes + 100'000, [](unsigned char byte) { return byte == 7; }));
    }
};

QTEST_GUILESS_MAIN(HelperTest)
#include "helper_test.moc"
