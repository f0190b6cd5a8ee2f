// SPDX-License-Identifier: Apache-2.0
// What a file is brought to the disk by, in which order, and what is left where the disk refuses.
#include "core/files/durable_file.hpp"
#include "core/files/folder_lock.hpp"
#include "core/files/whole_file.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
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

namespace {

/// What was asked of the system, in order: "file", "folder" (brought to the disk), "name" (given).
std::vector<std::string> asked;
int file_sync_error = 0;             ///< errno of every fsync of a file; 0: none
int folder_sync_error = 0;           ///< of a folder
int flag_error = 0;                  ///< of renameat2
int rename_error = 0;                ///< of rename
int read_error = 0;                  ///< of every read of a file
int lock_error = 0;                  ///< of every lock
int time_error = 0;                  ///< where a file is given its time
int interruptions = 0;               ///< a signal comes as often before what is asked next is done
std::size_t most_at_once = SIZE_MAX; ///< bytes that one call writes
bool somebody_is_sooner = false;     ///< to make a folder
int inherited = 0; ///< open files, of those asked about, that a program started meanwhile would have

bool is_folder(int descriptor) {
    struct stat about {};
    return ::fstat(descriptor, &about) == 0 && S_ISDIR(about.st_mode);
}

int refused(int error) {
    errno = error;
    return -1;
}

bool is_interrupted() { return interruptions > 0 && interruptions-- > 0; }

void look_whether_inherited(int descriptor) {
    inherited += (::fcntl(descriptor, F_GETFD) & FD_CLOEXEC) == 0 ? 1 : 0;
}

} // namespace

extern "C" int fsync(int descriptor) {
    const bool folder = is_folder(descriptor);
    look_whether_inherited(descriptor);
    asked.emplace_back(folder ? "folder" : "file");
    if (const int error = folder ? folder_sync_error : file_sync_error; error != 0)
        return refused(error);
    return static_cast<int>(::syscall(SYS_fsync, descriptor));
}

extern "C" int renameat2(int old_folder, const char* from, int new_folder, const char* to,
                         unsigned flags) noexcept {
    if (flag_error != 0)
        return refused(flag_error);
    asked.emplace_back("name");
    return static_cast<int>(::syscall(SYS_renameat2, old_folder, from, new_folder, to, flags));
}

extern "C" int rename(const char* from, const char* to) noexcept {
    asked.emplace_back("name");
    if (rename_error != 0)
        return refused(rename_error);
    return static_cast<int>(::syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

extern "C" ssize_t read(int descriptor, void* bytes, std::size_t count) {
    look_whether_inherited(descriptor);
    if (is_interrupted())
        return refused(EINTR);
    if (read_error != 0)
        return refused(read_error);
    return ::syscall(SYS_read, descriptor, bytes, count);
}

extern "C" ssize_t write(int descriptor, const void* bytes, std::size_t count) {
    if (is_interrupted())
        return refused(EINTR);
    return ::syscall(SYS_write, descriptor, bytes, std::min(count, most_at_once));
}

extern "C" int flock(int descriptor, int operation) noexcept {
    look_whether_inherited(descriptor);
    if (is_interrupted())
        return refused(EINTR);
    if (lock_error != 0)
        return refused(lock_error);
    return static_cast<int>(::syscall(SYS_flock, descriptor, operation));
}

extern "C" int utimensat(int folder, const char* file, const timespec* times, int flags) noexcept {
    if (time_error != 0)
        return refused(time_error);
    return static_cast<int>(::syscall(SYS_utimensat, folder, file, times, flags));
}

extern "C" int mkdir(const char* folder, mode_t mode) noexcept {
    const long made = ::syscall(SYS_mkdirat, AT_FDCWD, folder, mode);
    return made == 0 && somebody_is_sooner ? refused(EEXIST) : static_cast<int>(made);
}

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
        file_sync_error = folder_sync_error = flag_error = rename_error = 0;
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
        QTest::addColumn<int>("error");
        QTest::newRow("EINVAL") << EINVAL;
        QTest::newRow("ENOSYS") << ENOSYS;
    }
    void without_the_system_s_flags_nothing_is_written_over_either() {
        QFETCH(int, error);
        flag_error = error;
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

    /// A process that ends in the middle of its writing leaves no half a file, and begins none.
    void a_process_that_gives_up_leaves_what_was_there() {
        const pid_t child = ::fork();
        if (child == 0) {
            ::alarm(20);
            auto made = NewFile::beside(root_ / "a");
            auto other = NewFile::beside(root_ / "fresh");
            const bool written = made->write("half").empty() && other->write("half").empty();
            NewFile::give_up_all();
            std::thread late([&] { static_cast<void>(made->take_place()); }); // waits for the end
            std::thread later([&] { static_cast<void>(NewFile::beside(root_ / "later")->write("half")); });
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            ::_exit(written ? 7 : 1);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        QVERIFY(WIFEXITED(status));
        QCOMPARE(WEXITSTATUS(status), 7);
        QCOMPARE(content("a"), std::string("a"));
        QCOMPARE(files_here(), 2L);
    }

    /// What was swapped out is somebody's whole file, and no half one of ours.
    void a_process_that_gives_up_leaves_what_was_swapped_out() {
        const pid_t child = ::fork();
        if (child == 0) {
            ::alarm(20);
            auto made = NewFile::beside(root_ / "a");
            const bool swapped = made->write("new").empty() && made->take_place(Existing::swapped).empty();
            const fs::path old = made->temporary();
            NewFile::give_up_all();
            ::_exit(!swapped ? 1 : old.empty() || fs::exists(old) ? 7 : 2);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        QVERIFY(WIFEXITED(status));
        QCOMPARE(WEXITSTATUS(status), 7);
        QCOMPARE(content("a"), std::string("new"));
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

    /// What an earlier process of the same number left behind is in nobody's way.
    void names_left_behind_are_stepped_over() {
        const std::string first = NewFile::beside(root_ / "a")->temporary().filename().string();
        const std::size_t dash = first.rfind('-');
        const int number = std::stoi(first.substr(dash + 1));
        const auto left_behind = [&](int k) {
            return root_ / (first.substr(0, dash + 1) + std::to_string(number + k) + ".tmp");
        };
        for (int k = 1; k <= 99; ++k)
            QCOMPARE(::close(::creat(left_behind(k).c_str(), 0600)), 0);
        QCOMPARE(replace_file(root_ / "a", "new"), std::string());
        QCOMPARE(content("a"), std::string("new"));
        for (int k = 101; k <= 200; ++k)
            QCOMPARE(::close(::creat(left_behind(k).c_str(), 0600)), 0);
        QVERIFY(replace_file(root_ / "a", "newer").find("left behind") != std::string::npos);
        QCOMPARE(content("a"), std::string("new"));
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
