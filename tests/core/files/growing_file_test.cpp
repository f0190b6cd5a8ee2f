// SPDX-License-Identifier: Apache-2.0
// A table that grows line by line, on a disk that may be full.
#include "core/files/durable_file.hpp"
#include "core/files/growing_file.hpp"
#include "core/files/whole_file.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <sys/syscall.h>
#include <unistd.h>
#include <vector>

using namespace tp;
namespace fs = std::filesystem;

namespace {

std::size_t room_left = SIZE_MAX; ///< bytes that the disk takes
std::size_t most_at_once = SIZE_MAX;
int interruptions = 0, sync_error = 0, cut_error = 0;
std::vector<std::string> asked;

} // namespace

extern "C" ssize_t write(int file, const void* bytes, size_t count) {
    if (interruptions > 0 && interruptions-- > 0) {
        errno = EINTR;
        return -1;
    }
    count = std::min({count, room_left, most_at_once});
    if (count == 0) {
        errno = ENOSPC;
        return -1;
    }
    room_left -= room_left == SIZE_MAX ? 0 : count;
    asked.emplace_back("write");
    return ::syscall(SYS_write, file, bytes, count);
}

extern "C" int fsync(int file) {
    asked.emplace_back("sync");
    if (sync_error != 0) {
        errno = sync_error;
        return -1;
    }
    return static_cast<int>(::syscall(SYS_fsync, file));
}

extern "C" int ftruncate64(int file, off64_t size) noexcept {
    if (cut_error != 0) {
        errno = cut_error;
        return -1;
    }
    return static_cast<int>(::syscall(SYS_ftruncate, file, size));
}
extern "C" int ftruncate(int file, off_t size) noexcept { return ftruncate64(file, size); }

class GrowingFileTest : public QObject {
    Q_OBJECT
    QTemporaryDir dir_;
    fs::path file_;

    std::string content() const { return *read_whole(file_, 1000); }

private slots:
    void init() {
        room_left = most_at_once = SIZE_MAX;
        interruptions = sync_error = cut_error = 0;
        file_ = fs::path(dir_.path().toStdString()) / "table.csv";
        QCOMPARE(replace_file(file_, "a,b\n"), std::string());
        asked.clear();
    }
    void cleanup() { room_left = SIZE_MAX, sync_error = cut_error = 0; }

    void a_line_stands_behind_the_others_and_on_the_disk() {
        QCOMPARE(append_to_file(file_, 4, "1,2\n"), std::string());
        QCOMPARE(asked, (std::vector<std::string>{"write", "sync"}));
        QCOMPARE(content(), std::string("a,b\n1,2\n"));
        interruptions = 2;
        most_at_once = 3;
        QCOMPARE(append_to_file(file_, 8, "3,4\n"), std::string());
        QCOMPARE(content(), std::string("a,b\n1,2\n3,4\n"));
    }
    void a_line_that_has_no_room_leaves_the_file_as_it_was() {
        for (std::size_t room = 0; room < 4; ++room) {
            room_left = room;
            QCOMPARE(append_to_file(file_, 4, "1,2\n"), std::string("the disk is full."));
            QCOMPARE(content(), std::string("a,b\n"));
        }
        room_left = SIZE_MAX;
        sync_error = EIO;
        QCOMPARE(append_to_file(file_, 4, "1,2\n"), std::string("the disk reports a fault."));
        sync_error = 0;
        QCOMPARE(content(), std::string("a,b\n"));
        QCOMPARE(append_to_file(file_, 4, "1,2\n"), std::string());
    }
    void where_the_disk_will_not_even_have_it_so_it_is_cut_later() {
        room_left = 2;
        cut_error = EIO;
        QCOMPARE(append_to_file(file_, 4, "1,2\n"), std::string("the disk is full."));
        QCOMPARE(content(), std::string("a,b\n1,"));
        QCOMPARE(cut_file(file_, 4), std::string("the disk reports a fault."));
        room_left = SIZE_MAX;
        QCOMPARE(append_to_file(file_, 4, "1,2\n"), std::string(changed_meanwhile));
        cut_error = 0;
        asked.clear();
        QCOMPARE(cut_file(file_, 4), std::string());
        QCOMPARE(asked, std::vector<std::string>{"sync"});
        QCOMPARE(content(), std::string("a,b\n"));
        sync_error = EIO;
        QCOMPARE(cut_file(file_, 2), std::string("the disk reports a fault."));
    }
    void a_file_of_another_size_is_left_alone() {
        for (const std::uintmax_t size : {std::uintmax_t{3}, std::uintmax_t{5}})
            QCOMPARE(append_to_file(file_, size, "x"), std::string(changed_meanwhile));
        QCOMPARE(cut_file(file_, 5), std::string(changed_meanwhile));
        QCOMPARE(content(), std::string("a,b\n"));
    }
    void what_is_there_may_be_left_as_it_is() {
        QCOMPARE(cut_file(file_, 4), std::string());
        QCOMPARE(content(), std::string("a,b\n"));
    }
    void what_is_no_file_is_said() {
        fs::remove(file_);
        QCOMPARE(append_to_file(file_, 0, "x"), std::string("it is gone."));
        QVERIFY(!fs::exists(file_));
        QCOMPARE(cut_file(file_, 0), std::string("it is gone."));
        QCOMPARE(append_to_file("/dev/null", 0, "x"), std::string("it is not a file."));
        QVERIFY(!append_to_file(file_.parent_path(), 0, "x").empty());
    }
};

QTEST_GUILESS_MAIN(GrowingFileTest)
#include "growing_file_test.moc"
