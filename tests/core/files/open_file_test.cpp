// SPDX-License-Identifier: Apache-2.0
// A file held open: what may be done with it, what of it is read and written, and who else may have it.
#include "core/files/durable_file.hpp"
#include "core/files/open_file.hpp"
#include "core/files/whole_file.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <string>
#include <string_view>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>
#include <utility>

using namespace tp;
namespace fs = std::filesystem;

class OpenFileTest : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;
    fs::path root_;

    /// A file of that name that holds "0123456789".
    fs::path ten(const char* name) const {
        fs::path file = root_ / name;
        return replace_file(file, "0123456789").empty() ? file : fs::path();
    }
    static std::string content(const fs::path& file) { return *read_whole(file, 1000); }
    static std::string read(OpenFile& file, std::size_t most) {
        std::string bytes(most, '?');
        const std::int64_t count = file.read(bytes);
        return count < 0 ? "fault" : bytes.substr(0, static_cast<std::size_t>(count));
    }

private slots:
    void init() {
        root_ = fs::path(dir_.path().toStdString()) / QTest::currentTestFunction();
        fs::create_directory(root_);
    }

    void what_it_is_opened_for_is_what_can_be_done() {
        const fs::path file = ten("a");
        OpenFile reader(file, {});
        QCOMPARE(read(reader, 4), std::string("0123"));
        QCOMPARE(reader.write("x").error, EBADF);
        OpenFile writer(file, {.read = false, .write = true});
        QCOMPARE(writer.write("ab").error, 0);
        QCOMPARE(read(writer, 4), std::string("fault"));
        OpenFile both(file, {.write = true});
        QCOMPARE(read(both, 3), std::string("ab2"));
        QCOMPARE(both.write("c").count, std::size_t(1));
        QCOMPARE(content(file), std::string("ab2c456789"));
        QVERIFY(!OpenFile().ok());
        QVERIFY(!OpenFile(root_ / "missing", {.write = true}).ok());
        QCOMPARE(errno, ENOENT);
    }

    void it_is_made_emptied_or_written_behind_only_where_that_was_asked_for() {
        const fs::path file = ten("a");
        QVERIFY(OpenFile(file, {.write = true, .make = true}).ok());
        QCOMPARE(content(file), std::string("0123456789"));
        QVERIFY(!OpenFile(file, {.write = true, .make = true, .only_new = true}).ok());
        QCOMPARE(errno, EEXIST);
        QVERIFY(OpenFile(root_ / "new", {.write = true, .make = true, .only_new = true}).ok());
        OpenFile behind(file, {.read = false, .write = true, .at_end = true});
        QCOMPARE(behind.write("x").error, 0);
        QCOMPARE(behind.go_to(0, SEEK_SET), std::int64_t(0));
        QCOMPARE(behind.write("y").error, 0);
        QCOMPARE(content(file), std::string("0123456789xy"));
        QVERIFY(OpenFile(file, {.write = true, .emptied = true}).ok());
        QCOMPARE(content(file), std::string());
    }

    void a_link_is_followed_but_where_it_may_not() {
        ten("a");
        fs::create_symlink("a", root_ / "link");
        QVERIFY(OpenFile(root_ / "link", {}).ok());
        QVERIFY(!OpenFile(root_ / "link", {.follow_link = false}).ok());
        QCOMPARE(errno, ELOOP);
        QVERIFY(OpenFile(root_ / "a", {.follow_link = false}).ok());
    }

    /// Nobody writes into it.
    void a_pipe_makes_nobody_wait() {
        QCOMPARE(::mkfifo((root_ / "pipe").c_str(), 0600), 0);
        const OpenFile pipe(root_ / "pipe", {});
        QVERIFY(pipe.ok());
        QVERIFY(pipe.facts()->kind == FileFacts::Kind::other);
    }

    void who_may_read_a_new_one_and_which_programs_have_it() {
        ::umask(022);
        const auto mode = [](const OpenFile& file) {
            struct stat about {};
            return ::fstat(file.number(), &about) == 0 ? about.st_mode & 0777u : 0;
        };
        const OpenFile usual(root_ / "usual", {.write = true, .make = true});
        QCOMPARE(mode(usual), 0644u);
        const OpenFile secret(root_ / "secret",
                              {.write = true, .make = true, .readers = Readers::owner_only});
        QCOMPARE(mode(secret), 0600u);
        QVERIFY((::fcntl(secret.number(), F_GETFD) & FD_CLOEXEC) != 0);
        secret.give_readers_of(root_ / "missing"); // is no fault
        QCOMPARE(mode(secret), 0600u);
        fs::permissions(root_ / "usual", fs::perms(0751));
        secret.give_readers_of(root_ / "usual");
        QCOMPARE(mode(secret), 0751u);
    }

    void what_the_disk_says_of_it() {
        const fs::path file = ten("a");
        fs::create_hard_link(file, root_ / "other name");
        ten("b");
        const FileFacts a = *OpenFile(file, {}).facts();
        QVERIFY(a.kind == FileFacts::Kind::file);
        QCOMPARE(a.bytes, std::uint64_t(10));
        QVERIFY(a.identity == OpenFile(root_ / "other name", {}).facts()->identity);
        QVERIFY(a.identity != OpenFile(root_ / "b", {}).facts()->identity);
        struct timespec times[2] = {{1'000, 0}, {1'234'567'890, 123'456'789}};
        QCOMPARE(::utimensat(AT_FDCWD, file.c_str(), times, 0), 0);
        const FileFacts later = *OpenFile(file, {}).facts();
        QCOMPARE(later.written_ns, std::int64_t(1'234'567'890'123'456'789));
        QVERIFY(later.changed_ns >= a.changed_ns && later.changed_ns > later.written_ns);
        QVERIFY(OpenFile(root_, {}).facts()->kind == FileFacts::Kind::folder);
        QVERIFY(!OpenFile().facts());
    }

    void a_read_goes_on_where_the_last_one_ended() {
        OpenFile file(ten("a"), {});
        QCOMPARE(read(file, 4), std::string("0123"));
        QCOMPARE(read(file, 4), std::string("4567"));
        QCOMPARE(read(file, 4), std::string("89"));
        QCOMPARE(read(file, 4), std::string());
        QCOMPARE(file.go_to(3, SEEK_SET), std::int64_t(3));
        QCOMPARE(file.go_to(2, SEEK_CUR), std::int64_t(5));
        QCOMPARE(read(file, 1), std::string("5"));
        QCOMPARE(file.go_to(-1, SEEK_END), std::int64_t(9));
        QCOMPARE(file.go_to(-1, SEEK_SET), std::int64_t(-1));
        QCOMPARE(read(file, 4), std::string("9"));
    }

    void a_read_at_a_place_moves_nothing() {
        OpenFile file(ten("a"), {});
        std::array<char, 4> bytes{};
        const auto at = [&](std::uint64_t place) {
            return std::string(bytes.data(), file.read_at(place, bytes));
        };
        QCOMPARE(at(3), std::string("3456"));
        QCOMPARE(at(8), std::string("89"));
        QCOMPARE(at(10), std::string());
        QCOMPARE(read(file, 2), std::string("01"));
        QCOMPARE(tp::read_at(file.number(), 6, bytes), std::size_t(4));
        QCOMPARE(std::string_view(bytes.data(), 4), std::string_view("6789"));
        QCOMPARE(OpenFile().read_at(0, bytes), std::size_t(0));
    }

    void a_write_at_a_place_changes_only_what_is_there() {
        const fs::path file = ten("a");
        OpenFile open(file, {.write = true});
        const Written written = open.write_at(4, "xy");
        QCOMPARE(written.count, std::size_t(2));
        QCOMPARE(written.error, 0);
        QCOMPARE(open.write("z").count, std::size_t(1)); // where it stood
        QCOMPARE(content(file), std::string("z123xy6789"));
        const Written refused = OpenFile(file, {}).write_at(0, "q");
        QCOMPARE(refused.count, std::size_t(0));
        QCOMPARE(refused.error, EBADF);
        QCOMPARE(open.cut(4), 0);
        QCOMPARE(content(file), std::string("z123"));
        QCOMPARE(open.to_disk(), 0);
        QCOMPARE(open.bytes_to_disk(), 0);
        for (const int error : {OpenFile().cut(0), OpenFile().to_disk(), OpenFile().bytes_to_disk()})
            QCOMPARE(error, EBADF);
    }

    void each_is_closed_once() {
        const fs::path file = ten("a");
        const auto is_open = [](int number) { return ::fcntl(number, F_GETFD) >= 0; };
        OpenFile first(file, {});
        const int one = first.number();
        OpenFile second(file, {});
        const int two = second.number();
        first = std::move(second);
        QVERIFY(!is_open(one) && is_open(two));
        QCOMPARE(first.number(), two);
        {
            const OpenFile third(std::move(first));
            QVERIFY(!first.ok() && is_open(two)); // NOLINT(bugprone-use-after-move): it holds nothing
        }
        QVERIFY(!is_open(two));
        OpenFile last(file, {});
        const int number = last.release();
        last.close();
        QVERIFY(!last.ok() && is_open(number));
        OpenFile(number).close();
        QVERIFY(!is_open(number));
    }

    /// As between two of our programs with one album.
    void one_opening_at_a_time_has_its_lock() {
        const fs::path file = ten("a");
        OpenFile first(file, {});
        OpenFile second(file, {});
        QVERIFY(first.lock());
        QVERIFY(!second.lock());
        QCOMPARE(errno, EWOULDBLOCK);
        std::atomic<bool> has{false};
        bool had = false;
        std::thread waiting([&] {
            had = second.wait_for_lock();
            has = true;
        });
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        const bool too_soon = has;
        first.close();
        waiting.join();
        QVERIFY(!too_soon && had);
        QVERIFY(!OpenFile(file, {}).lock());
        QVERIFY(!OpenFile().lock() && !OpenFile().wait_for_lock());
    }
};

QTEST_GUILESS_MAIN(OpenFileTest)
#include "open_file_test.moc"
