// SPDX-License-Identifier: Apache-2.0
// What a file is brought to the disk by, in which order, and what is left where the disk refuses.
#include "core/files/durable_file.hpp"
#include "core/files/folder_lock.hpp"
#include "core/files/whole_file.hpp"
#include "refusing_system.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <fcntl.h>
#include <filesystem>
#include <memory>
#include <string>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

using namespace tp;
namespace fs = std::filesystem;

class FailingDiskTest : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;
    fs::path root_;

    std::string content(const char* name) const {
        const auto bytes = read_whole(root_ / name, 1 << 20);
        return bytes ? *bytes : "error: " + bytes.error();
    }
    long files_here() const { return std::distance(fs::directory_iterator(root_), fs::directory_iterator()); }
    void heal() {
        file_sync_error = folder_sync_error = flag_error = rename_error = link_error = 0;
        read_error = lock_error = time_error = interruptions = inherited = 0;
        most_at_once = SIZE_MAX;
        somebody_is_sooner = false;
        asked.clear();
    }
    /// An old and a new file, on a healthy disk.
    void lay_out() {
        heal();
        for (const char* name : {"a", "b"})
            QCOMPARE(replace_file(root_ / name, name), std::string());
        asked.clear();
    }

private slots:
    void init() {
        root_ = fs::path(dir_.path().toStdString()) /
                (std::string(QTest::currentTestFunction()) +
                 (QTest::currentDataTag() != nullptr ? QTest::currentDataTag() : ""));
        fs::create_directory(root_);
        lay_out();
    }
    void cleanup() { heal(); }

    /// After a power cut the name leads to the old file or to the whole new one.
    void the_bytes_are_on_the_disk_before_the_name_and_the_name_before_it_is_said() {
        const std::vector<std::string> in_order{"file", "name", "folder"};
        QCOMPARE(replace_file(root_ / "a", "new"), std::string());
        QVERIFY(asked == in_order);
        asked.clear();
        QCOMPARE(copy_whole(root_ / "a", root_ / "copy"), std::string());
        QVERIFY(asked == in_order);
        asked.clear();
        auto swapped = NewFile::beside(root_ / "a");
        QCOMPARE(swapped->take_place(Existing::swapped), std::string());
        QVERIFY(asked == in_order);
    }

    void of_a_move_both_folders_are_brought_to_the_disk() {
        QCOMPARE(make_folder(root_ / "deep" / "er"), std::string());
        QVERIFY((asked == std::vector<std::string>{"folder", "folder"})); // each new folder's own
        asked.clear();
        QCOMPARE(move_file(root_ / "a", root_ / "c"), std::string());
        QVERIFY((asked == std::vector<std::string>{"name", "folder"}));
        asked.clear();
        QCOMPARE(move_file(root_ / "b", root_ / "deep" / "b"), std::string());
        QVERIFY((asked == std::vector<std::string>{"name", "folder", "folder"}));
        asked.clear();
        QCOMPARE(make_folder(root_ / "deep"), std::string()); // is there
        QVERIFY(asked.empty());
    }

    void bytes_that_do_not_reach_the_disk_leave_the_old_file() {
        file_sync_error = EIO;
        for (const std::string& reason :
             {replace_file(root_ / "a", "new"), copy_whole(root_ / "a", root_ / "copy")})
            QCOMPARE(reason, std::string("the disk reports a fault."));
        QCOMPARE(content("a"), std::string("a"));
        QCOMPARE(files_here(), 2L);
    }

    void a_folder_that_does_not_reach_the_disk_is_said() {
        folder_sync_error = EIO;
        const std::string fault = "the disk reports a fault.";
        QCOMPARE(replace_file(root_ / "a", "new"), fault);
        QCOMPARE(move_file(root_ / "b", root_ / "c"), fault);
        QCOMPARE(make_folder(root_ / "folder"), fault);
        QCOMPARE(sync_folder(root_), fault);
        for (const int cannot : {EINVAL, EROFS}) { // such a file system has nothing to bring
            folder_sync_error = cannot;
            QCOMPARE(sync_folder(root_), std::string());
        }
        folder_sync_error = 0;
        QVERIFY(!sync_folder(root_ / "missing").empty());
        QCOMPARE(sync_folder({}), std::string()); // where we are
    }

    /// A signal to the process, such as a child's end, comes in the middle of anything.
    void a_signal_in_between_loses_nothing() {
        const std::string bytes(200'000, 'q');
        interruptions = 2;
        most_at_once = 4097; // and a disk that takes it in pieces
        QCOMPARE(replace_file(root_ / "a", bytes), std::string());
        QCOMPARE(interruptions, 0);
        interruptions = 2;
        const std::string copied = copy_whole(root_ / "a", root_ / "copy");
        interruptions = 0;
        QCOMPARE(copied, std::string());
        QCOMPARE(content("a"), bytes);
        QCOMPARE(content("copy"), bytes);
        const FolderLock held(root_);
        interruptions = 2;
        QVERIFY(!FolderLock(root_, std::chrono::milliseconds(0)).held());
        QCOMPARE(interruptions, 0);
    }

    void at_a_place_too_all_is_read_and_written_piece_by_piece() {
        QCOMPARE(replace_file(root_ / "a", "0123456789"), std::string());
        const OpenFile file(root_ / "a", {.write = true});
        most_at_once = 3;
        std::array<char, 8> bytes{};
        QCOMPARE(file.read_at(1, bytes), std::size_t(8));
        QCOMPARE(std::string(bytes.data(), 8), std::string("12345678"));
        const Written written = file.write_at(2, "abcdefg");
        QVERIFY(written.count == 7 && written.error == 0);
        most_at_once = SIZE_MAX;
        QCOMPARE(content("a"), std::string("01abcdefg9"));
    }

    void what_cannot_be_read_or_dated_is_not_copied() {
        read_error = EIO;
        const std::string unread = copy_whole(root_ / "a", root_ / "copy");
        read_error = 0;
        QCOMPARE(unread, std::string("it cannot be read: the disk reports a fault."));
        time_error = EPERM;
        QCOMPARE(copy_whole(root_ / "a", root_ / "copy"), std::string("you are not allowed to write there."));
        QCOMPARE(files_here(), 2L);
        QCOMPARE(copy_whole(root_ / "missing", root_ / "copy"),
                 std::string("it cannot be read: its folder is gone."));
    }

    void a_file_that_breaks_off_is_not_half_read() {
        const auto broken = read_whole("/proc/self/mem", 100);
        QVERIFY(!broken.ok());
        QVERIFY2(broken.error().find("cannot be read to its end.") != std::string::npos,
                 broken.error().c_str());
    }

    /// Two programs that begin an album at the same moment.
    void a_folder_that_another_makes_sooner_is_there() {
        somebody_is_sooner = true;
        QCOMPARE(make_folder(root_ / "album" / "2026"), std::string());
        QVERIFY(fs::is_directory(root_ / "album" / "2026"));
        somebody_is_sooner = false;
        QCOMPARE(make_folder(root_ / "a"), std::string("there is a file of that name already."));
        QVERIFY(!sync_folder(root_ / "a").empty()); // no folder at all
    }

    void where_no_locks_are_known_everybody_goes_on() {
        lock_error = ENOLCK;
        const FolderLock first(root_, std::chrono::milliseconds(0));
        QVERIFY(first.held() && FolderLock(root_, std::chrono::milliseconds(0)).held());
    }

    /// A speech server that the program starts must not keep a photograph's folder busy.
    void a_program_started_meanwhile_has_none_of_the_files() {
        auto made = NewFile::beside(root_ / "a");
        QCOMPARE(made->take_place(), std::string());
        QCOMPARE(copy_whole(root_ / "a", root_ / "copy"), std::string());
        QVERIFY(FolderLock(root_).held());
        QCOMPARE(inherited, 0);
    }

    /// Where nothing is connected to standard input, the first file that is opened has the number 0.
    void number_0_is_a_file_like_others() {
        const auto open_files = [] {
            return std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator());
        };
        const int input = ::fcntl(0, F_DUPFD_CLOEXEC, 10);
        ::close(0);
        const auto before = open_files();
        const std::string replaced = replace_file(root_ / "a", "new");
        const std::string copied = copy_whole(root_ / "a", root_ / "copy");
        const std::string synced = sync_folder(root_);
        auto first = std::make_unique<FolderLock>(root_);
        const bool alone = first->held() && !FolderLock(root_, std::chrono::milliseconds(0)).held();
        first.reset();
        const auto after = open_files();
        if (input >= 0) {
            ::dup2(input, 0);
            ::close(input);
        }
        QCOMPARE(replaced, std::string());
        QCOMPARE(copied, std::string());
        QCOMPARE(synced, std::string());
        QVERIFY(alone);
        QCOMPARE(after, before);
        QCOMPARE(content("copy"), std::string("new"));
    }

    /// A folder into which others may put files and not look, as a letter box.
    void into_a_letter_box_files_are_put_all_the_same() {
        fs::create_directory(root_ / "box");
        for (const fs::path& folder : {fs::path(dir_.path().toStdString()), root_})
            fs::permissions(folder, fs::perms::group_exec | fs::perms::others_exec, fs::perm_options::add);
        fs::permissions(root_ / "box", fs::perms(0333));
        const pid_t child = ::fork();
        if (child == 0) {
            constexpr uid_t nobody = 65534;
            if (::geteuid() == 0 && ::seteuid(nobody) != 0)
                ::_exit(77);
            const bool put = replace_file(root_ / "box" / "letter", "x").empty() &&
                             sync_folder(root_ / "box").empty() && FolderLock(root_ / "box").held();
            ::_exit(put ? 7 : 1);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        fs::permissions(root_ / "box", fs::perms::owner_all);
        if (WIFEXITED(status) && WEXITSTATUS(status) == 77)
            QSKIP("the superuser may look everywhere");
        QVERIFY(WIFEXITED(status));
        QCOMPARE(WEXITSTATUS(status), 7);
        QCOMPARE(content("box/letter"), std::string("x"));
    }

    /// Some network and memory-stick file systems know no such flags.
    void without_the_system_s_flags_nothing_is_written_over_either_data() {
        QTest::addColumn<int>("error"), QTest::addColumn<int>("of_links");
        QTest::newRow("NFS") << EINVAL << 0;
        QTest::newRow("an old system") << ENOSYS << 0;
        QTest::newRow("exFAT") << EINVAL << EPERM;
        QTest::newRow("FUSE") << EINVAL << ENOSYS;
        QTest::newRow("SMB by FUSE") << ENOSYS << EOPNOTSUPP;
    }
    void without_the_system_s_flags_nothing_is_written_over_either() {
        QFETCH(int, error);
        QFETCH(int, of_links);
        flag_error = error;
        link_error = of_links;
        const std::string taken = "there is a file of that name already.";
        QCOMPARE(move_file(root_ / "a", root_ / "b"), taken);
        QCOMPARE(copy_whole(root_ / "a", root_ / "b"), taken);
        QCOMPARE(content("b"), std::string("b"));
        QCOMPARE(files_here(), 2L);
        QCOMPARE(copy_whole(root_ / "a", root_ / "copy"), std::string());
        QCOMPARE(content("copy"), std::string("a"));
        QCOMPARE(files_here(), 3L);
        QCOMPARE(move_file(root_ / "a", root_ / "moved"), std::string());
        QCOMPARE(content("moved"), std::string("a"));
        QVERIFY(!name_taken(root_ / "a"));
        {
            auto made = NewFile::beside(root_ / "b");
            QCOMPARE(made->write("new"), std::string());
            QCOMPARE(made->take_place(Existing::swapped), std::string());
            QVERIFY(made->temporary().empty()); // it could not be swapped
        }
        QCOMPARE(content("b"), std::string("new"));
        QCOMPARE(files_here(), 3L);
        QCOMPARE(make_folder(root_ / "one"), std::string());
        QCOMPARE(replace_file(root_ / "one" / "inside", "x"), std::string());
        QCOMPARE(make_folder(root_ / "other"), std::string());
        QCOMPARE(move_file(root_ / "one", root_ / "other"), taken);
        QCOMPARE(move_file(root_ / "one", root_ / "third"), std::string());
        QCOMPARE(content("third/inside"), std::string("x"));
        rename_error = ENOSPC;
        QCOMPARE(move_file(root_ / "third", root_ / "fourth"), std::string("the disk is full."));
        if (of_links != 0)
            QCOMPARE(copy_whole(root_ / "b", root_ / "fourth"), std::string("the disk is full."));
        QVERIFY(!name_taken(root_ / "fourth")); // what claimed the name is gone
        rename_error = 0;
        link_error = EACCES;
        QCOMPARE(copy_whole(root_ / "b", root_ / "fourth"),
                 std::string("you are not allowed to write there."));
    }

    void what_else_the_system_says_is_passed_on() {
        flag_error = EXDEV;
        QCOMPARE(move_file(root_ / "a", root_ / "c"), std::string("they lie on different disks."));
        flag_error = EACCES;
        const std::string forbidden = "you are not allowed to write there.";
        QCOMPARE(move_file(root_ / "a", root_ / "c"), forbidden);
        QCOMPARE(copy_whole(root_ / "a", root_ / "c"), forbidden);
        {
            auto made = NewFile::beside(root_ / "b");
            QCOMPARE(made->take_place(Existing::swapped), forbidden);
        }
        flag_error = EINVAL;
        rename_error = EXDEV;
        QCOMPARE(move_file(root_ / "a", root_ / "c"), std::string("they lie on different disks."));
        rename_error = ENOSPC;
        QCOMPARE(replace_file(root_ / "a", "new"), std::string("the disk is full."));
        QCOMPARE(content("a"), std::string("a"));
        QCOMPARE(content("b"), std::string("b"));
        QCOMPARE(files_here(), 2L);
    }

    /// An album of ten thousand photos is written file by file: none of them is left open.
    void no_file_and_no_folder_is_left_open() {
        const auto open_files = [] {
            return std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator());
        };
        const auto before = open_files();
        QCOMPARE(replace_file(root_ / "a", "new"), std::string());
        QCOMPARE(copy_whole(root_ / "a", root_ / "copy"), std::string());
        QCOMPARE(move_file(root_ / "copy", root_ / "moved"), std::string());
        QVERIFY(!copy_whole(root_, root_ / "copy").empty());
        static_cast<void>(NewFile::beside(root_ / "b"));
        static_cast<void>(FolderLock(root_).held());
        QCOMPARE(open_files(), before);
    }

    void where_no_file_can_be_made_none_is_begun() {
        QVERIFY(!NewFile::beside("/proc/touchphoto").ok());
        QVERIFY(FolderLock(root_ / "a").held() && FolderLock(root_ / "a").held());
        const FolderLock no_folder(root_ / "a"); // is a file, which nobody locks
        QVERIFY(FolderLock(root_ / "a", std::chrono::milliseconds(0)).held());
    }

    /// Whoever comes second waits, and has it as soon as the first lets go.
    void a_lock_is_waited_for() {
        auto first = std::make_unique<FolderLock>(root_);
        std::atomic<bool> has{false};
        std::thread second([&] { has = FolderLock(root_).held(); });
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        QVERIFY(!has);
        first.reset();
        second.join();
        QVERIFY(has);
        QVERIFY(FolderLock(root_ / "missing").held()); // writing will tell
    }
};

QTEST_GUILESS_MAIN(FailingDiskTest)
#include "failing_disk_test.moc"
