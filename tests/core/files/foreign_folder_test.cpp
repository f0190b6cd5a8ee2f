// SPDX-License-Identifier: Apache-2.0
// A folder of somebody else's: whatever is asked of a name in it, nothing outside is read, changed or removed.
#include "core/files/durable_file.hpp"
#include "core/files/file_system.hpp"
#include "core/files/folder_lock.hpp"
#include "core/files/foreign_folder.hpp"
#include "core/files/new_file.hpp"
#include "core/files/open_file.hpp"
#include "core/files/open_folder.hpp"
#include "core/files/whole_file.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <fcntl.h>
#include <filesystem>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <map>
#include <optional>
#include <string>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

using namespace tp;
namespace fs = std::filesystem;

namespace {

/// All that is below a folder: names, kinds, bytes, rights, times, where links lead.
std::map<std::string, std::string> state_of(const fs::path& folder) {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        struct stat about {};
        ::lstat(entry.path().c_str(), &about);
        std::string state = std::to_string(about.st_mode) + " " + std::to_string(about.st_mtim.tv_sec) + "." +
                            std::to_string(about.st_mtim.tv_nsec) + " ";
        if (S_ISREG(about.st_mode))
            state += *read_whole(entry.path(), 1 << 20);
        else if (S_ISLNK(about.st_mode))
            state += fs::read_symlink(entry.path()).string();
        all[entry.path().lexically_relative(folder).string()] = state;
    }
    return all;
}

/// The system refuses this process openat2 from then on: with "not allowed", as a container does.
bool without_openat2() {
    sock_filter filter[] = {
        {BPF_LD | BPF_W | BPF_ABS, 0, 0, static_cast<std::uint32_t>(offsetof(seccomp_data, nr))},
        {BPF_JMP | BPF_JEQ | BPF_K, 0, 1, 437},
        {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ERRNO | EPERM},
        {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ALLOW},
    };
    const sock_fprog program{4, filter};
    return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

/// Whatever can be asked of a name; what was done although it should not.
std::string done_with(const fs::path& name) {
    std::string done;
    const auto note = [&](bool well, const char* what) {
        if (well)
            done += std::string(what) + " ";
    };
    note(OpenFile(name, {}).ok(), "opened");
    note(OpenFile(name, {.write = true}).ok(), "opened to write");
    note(OpenFile(name, {.write = true, .emptied = true}).ok(), "emptied");
    note(OpenFile(name, {.write = true, .make = true}).ok(), "made");
    note(read_whole(name, 1 << 20).ok(), "read");
    note(OpenFolder(name).ok(), "listed");
    note(replace_file(name, "x").empty(), "replaced");
    note(replace_file(name / "inside", "x").empty(), "replaced inside");
    note(make_folder(name / "folder").empty(), "made a folder inside");
    note(remove_file(name).empty(), "removed");
    note(remove_tree(name).empty(), "removed with all in it");
    note(move_file(name, name.parent_path() / "elsewhere").empty(), "moved");
    note(rename_over(name, name.parent_path() / "elsewhere") == 0, "renamed");
    note(only_for_owner(name) == 0, "its rights were changed");
    note(file_there(name) || folder_there(name), "taken for a file or folder");
    return done;
}

} // namespace

class ForeignFolderTest : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;
    fs::path root_, album_, outside_;

    std::string content(const fs::path& file) const {
        const auto bytes = read_whole(file, 1000);
        return bytes ? *bytes : bytes.error();
    }

    /// Links of each kind from the album to what lies outside.
    std::vector<fs::path> links() {
        fs::create_symlink(outside_ / "secret", album_ / "file");
        fs::create_directory_symlink(outside_, album_ / "folder");
        fs::create_symlink("nowhere", album_ / "nothing");
        fs::create_symlink("../outside/secret", album_ / "relative");
        fs::create_symlink("round", album_ / "round");
        fs::create_symlink(outside_ / "empty", album_ / "empty");
        return {album_ / "file",     album_ / "folder", album_ / "nothing",
                album_ / "relative", album_ / "round",  album_ / "empty"};
    }

private slots:
    void init() {
        root_ = fs::path(dir_.path().toStdString()) / QTest::currentTestFunction();
        album_ = root_ / "album";
        outside_ = root_ / "outside";
        fs::create_directories(album_ / "sub");
        fs::create_directories(outside_ / "below");
        for (const char* name : {"secret", "below/secret"})
            QCOMPARE(replace_file(outside_ / name, "secret"), std::string());
        QCOMPARE(replace_file(outside_ / "empty", ""), std::string());
    }

    void links_are_left_alone() {
        const std::vector<fs::path> planted = links();
        const auto before = state_of(root_);
        const ForeignFolder held(album_);
        for (const fs::path& link : planted) {
            QCOMPARE(done_with(link), std::string());
            QVERIFY(name_taken(link) && link_there(link));
            QCOMPARE(*link_on_the_way(link / "x"), link);
            QVERIFY(read_whole(link, 1000).error().ends_with("is a link; it is left alone."));
        }
        QVERIFY(state_of(root_) == before);
    }

    /// Where the system has no openat2, or a container's rules refuse it.
    void so_they_are_step_by_step() {
        fs::create_directories(album_ / "a/b/c");
        QCOMPARE(replace_file(album_ / "a/b/c/file", "own"), std::string());
        fs::create_directory_symlink(outside_, album_ / "a/b/link");
        links();
        const auto before = state_of(root_);
        const pid_t child = ::fork();
        if (child == 0) {
            if (!without_openat2())
                ::_exit(2);
            const ForeignFolder held(album_);
            bool well = ::syscall(437, -1, nullptr, nullptr, 0) == -1 && errno == EPERM;
            well = well && read_whole(album_ / "a/b/c/file", 100).ok();
            for (const char* name : {"file", "folder", "nothing", "relative", "round", "a/b/link"})
                well = well && done_with(album_ / name).empty();
            for (const char* name : {"a/b/link/secret", "a/b/link/below/secret", "folder/below"})
                well = well && done_with(album_ / name).empty();
            well = well && replace_file(album_ / "a/b/c/file", "own").empty();
            ::_exit(well ? 0 : 1);
        }
        int status = 0;
        QCOMPARE(::waitpid(child, &status, 0), child);
        QVERIFY(WIFEXITED(status));
        QCOMPARE(WEXITSTATUS(status), 0);
        auto after = state_of(root_);
        for (auto* state : {&after})
            for (const char* written : {"album/a/b/c/file", "album/a/b/c"})
                (*state)[written] = before.at(written);
        QVERIFY(after == before);
    }

    void what_lies_behind_a_link_is_nothing() {
        fs::create_directory_symlink(outside_, album_ / "sub/link");
        const auto before = state_of(root_);
        const ForeignFolder held(album_);
        for (const char* name : {"secret", "below/secret", "below", "new", "new/new"})
            QCOMPARE(done_with(album_ / "sub/link" / name), std::string());
        QVERIFY(!name_taken(album_ / "sub/link/secret"));
        QVERIFY(!photo_there(album_ / "sub/link/secret"));
        QVERIFY(!OpenFile(album_ / "sub/link/secret", {.looked_at = true}).ok());
        QCOMPARE(replace_file(album_ / "sub/link/new", "x"), left_alone(album_ / "sub/link"));
        QVERIFY(state_of(root_) == before);
    }

    void a_name_with_dots_leads_nowhere_else() {
        const auto before = state_of(root_);
        const ForeignFolder held(album_ / "sub");
        fs::create_directory_symlink(outside_ / "below", album_ / "sub/link");
        QVERIFY(!read_whole(album_ / "sub/link/../secret", 100).ok());
        QCOMPARE(content(album_ / "sub/../sub/../../outside/secret"),
                 std::string("secret")); // a person's own way
        fs::remove(album_ / "sub/link");
        QVERIFY(state_of(root_).at("outside/secret") == before.at("outside/secret"));
    }

    void its_own_files_are_as_everywhere() {
        const ForeignFolder held(album_);
        QCOMPARE(make_folder(album_ / "sub/one/two"), std::string());
        QCOMPARE(replace_file(album_ / "sub/one/two/a", "a"), std::string());
        QCOMPARE(copy_whole(album_ / "sub/one/two/a", album_ / "b"), std::string());
        QCOMPARE(move_file(album_ / "b", album_ / "sub/b"), std::string());
        QCOMPARE(content(album_ / "sub/b"), std::string("a"));
        QVERIFY(file_there(album_ / "sub/b") && folder_there(album_ / "sub/one"));
        QVERIFY(FolderLock(album_ / "sub").held());
        QCOMPARE(remove_file(album_ / "sub/b"), std::string());
        QCOMPARE(remove_file(album_ / "sub/b"), std::string());
        QCOMPARE(entries_of(album_ / "sub").size(), std::size_t{1}); // not itself, nor what is above it
        QCOMPARE(remove_tree(album_ / "sub"), std::string());
        QVERIFY(fs::is_empty(album_));
    }

    void the_folder_itself_may_be_a_link_that_a_person_made() {
        fs::create_directory_symlink(album_, root_ / "mine");
        const ForeignFolder held(root_ / "mine");
        QCOMPARE(replace_file(root_ / "mine/sub/a", "a"), std::string());
        QCOMPARE(content(album_ / "sub/a"), std::string("a"));
        fs::create_directory_symlink(outside_, album_ / "link");
        QVERIFY(!replace_file(root_ / "mine/link/a", "a").empty());
        QVERIFY(!fs::exists(outside_ / "a"));
    }

    /// A photograph may be looked at where a link leads to it, but not written to.
    void a_photograph_may_be_a_link() {
        fs::create_symlink(outside_ / "secret", album_ / "a.jpg");
        fs::create_symlink("/proc/self/environ", album_ / "b.jpg");
        fs::create_symlink("/dev/zero", album_ / "c.jpg");
        const ForeignFolder held(album_);
        QVERIFY(photo_there(album_ / "a.jpg") && !file_there(album_ / "a.jpg"));
        QVERIFY(OpenFile(album_ / "a.jpg", {.looked_at = true}).ok());
        QVERIFY(!OpenFile(album_ / "a.jpg", {.write = true, .looked_at = true}).ok());
        QCOMPARE(errno, ELOOP);
        for (const char* name : {"b.jpg", "c.jpg"}) { // what is the kernel's, or never ends
            QVERIFY(!OpenFile(album_ / name, {.looked_at = true}).ok());
            QCOMPARE(errno, ENXIO);
        }
    }

    void what_is_no_file_is_not_opened_and_nobody_waits() {
        QCOMPARE(::mkfifo((album_ / "pipe").c_str(), 0600), 0);
        const ForeignFolder held(album_);
        QVERIFY(!OpenFile(album_ / "pipe", {}).ok());
        QCOMPARE(errno, ENXIO);
        QVERIFY(!OpenFile(album_ / "pipe", {.write = true}).ok());
        QVERIFY(read_whole(album_ / "pipe", 10).error().ends_with("is not a file."));
        QVERIFY(!replace_file(album_ / "pipe", "x").empty());
        QVERIFY(!fs::is_regular_file(album_ / "pipe"));
    }

    void a_file_with_another_name_is_replaced_and_not_written_into() {
        fs::create_hard_link(outside_ / "secret", album_ / "hard");
        const ForeignFolder held(album_);
        const auto before = state_of(outside_);
        QVERIFY(OpenFile(album_ / "hard", {}).ok());
        QVERIFY(!OpenFile(album_ / "hard", {.write = true}).ok());
        QCOMPARE(errno, EMLINK);
        QVERIFY(!OpenFile(album_ / "hard", {.write = true, .emptied = true}).ok());
        QCOMPARE(only_for_owner(album_ / "hard"), EMLINK);
        QCOMPARE(replace_file(album_ / "hard", "new"), std::string());
        QCOMPARE(content(album_ / "hard"), std::string("new"));
        QVERIFY(state_of(outside_) == before);
    }

    void removing_a_folder_stops_at_links() {
        fs::create_directories(album_ / "tree/a/b");
        QCOMPARE(replace_file(album_ / "tree/a/file", "x"), std::string());
        fs::create_directory_symlink(outside_, album_ / "tree/a/b/link");
        const auto before = state_of(outside_);
        const ForeignFolder held(album_);
        QCOMPARE(remove_tree(album_ / "tree"), left_alone(album_ / "tree/a/b/link"));
        QVERIFY(!fs::exists(album_ / "tree/a/file") && fs::is_symlink(album_ / "tree/a/b/link"));
        QVERIFY(state_of(outside_) == before);
    }

    void what_is_listed_says_what_is_a_link() {
        links();
        const ForeignFolder held(album_);
        int error = -1;
        std::size_t found = 0;
        for (const FolderEntry& entry : entries_of(album_, &error)) {
            QCOMPARE(entry.link, entry.name != "sub");
            QVERIFY(entry.facts.kind == (entry.link ? FileFacts::Kind::link : FileFacts::Kind::folder));
            ++found;
        }
        QCOMPARE(error, 0);
        QCOMPARE(found, std::size_t{7});
        QVERIFY(entries_of(album_ / "folder", &error).empty());
        QCOMPARE(error, ELOOP);
    }

    /// By their names, whether or not an album is held.
    void what_belongs_to_a_photograph_is_held_so_everywhere() {
        for (const char* name :
             {"a.jpg.xmp", "a.jpg.XMP", "a.xmp", "a.jpg.contours.svg", "a.jpg.contours-1.svg"}) {
            fs::create_symlink(outside_ / "secret", album_ / name);
            QVERIFY2(done_with(album_ / name).empty(), name);
        }
        for (const char* name : {"a.jpg.tags", ".touchphoto"}) {
            fs::create_directory_symlink(outside_, album_ / name);
            QVERIFY2(done_with(album_ / name).empty(), name);
            QVERIFY2(done_with(album_ / name / "secret").empty(), name);
            QVERIFY2(done_with(album_ / name / "below/secret").empty(), name);
        }
        QVERIFY(content(outside_ / "secret") == "secret");
        // And nothing else is: a link to a list of preferences is a person's own.
        fs::create_symlink(outside_ / "empty", album_ / "choices.json");
        QCOMPARE(replace_file(album_ / "choices.json", "mine"), std::string());
        QCOMPARE(content(outside_ / "empty"), std::string("mine"));
    }

    void a_folder_is_held_as_long_as_one_lives() {
        fs::create_symlink(outside_ / "secret", album_ / "link");
        std::optional<ForeignFolder> first(album_), second(album_);
        const ForeignFolder third = *first;
        first.reset();
        second.reset();
        QVERIFY(!read_whole(album_ / "link", 100).ok());
        QVERIFY(foreign_place(album_ / "link")->below == "link");
        QVERIFY(!foreign_place(album_) && !foreign_place(root_ / "albums/link"));
    }

    /// What a program keeps in hidden folders of the person's home, which may be an album too.
    void a_home_that_is_an_album_keeps_its_programs_folders() {
        const QByteArray home = qgetenv("HOME");
        qputenv("HOME", QByteArray::fromStdString(album_.string()));
        fs::create_directory_symlink(outside_, album_ / ".config");
        fs::create_directory_symlink(outside_, album_ / "pictures");
        {
            const ForeignFolder held(album_);
            QVERIFY(read_whole(album_ / ".config/secret", 100).ok());
            QVERIFY(!read_whole(album_ / "pictures/secret", 100).ok());
        }
        qputenv("HOME", home);
    }

    /// Somebody puts a link in the place of a folder, again and again, while files are written into it.
    void a_folder_that_becomes_a_link_meanwhile_leads_nobody_out() {
        fs::create_directory(album_ / "real");
        fs::create_directory_symlink(outside_, album_ / "trap");
        const auto before = state_of(outside_);
        std::atomic<bool> done{false};
        std::atomic<int> swaps{0};
        std::thread other([&] {
            while (!done) {
                ::renameat2(AT_FDCWD, (album_ / "real").c_str(), AT_FDCWD, (album_ / "trap").c_str(),
                            RENAME_EXCHANGE);
                ++swaps;
            }
        });
        const ForeignFolder held(album_);
        int written = 0, refused = 0;
        for (int i = 0; (i < 300 || written == 0 || refused == 0) && i < 20'000; ++i) {
            const fs::path file = album_ / "real" / ("secret" + std::to_string(i % 3));
            (replace_file(file, "mine").empty() ? written : refused) += 1;
            if (const auto bytes = read_whole(album_ / "real/secret", 100); bytes)
                QVERIFY(*bytes != "secret");
            remove_file(album_ / "real/secret");
            remove_file(album_ / "real/below/secret");
            remove_tree(album_ / "real/below");
            make_folder(album_ / "real/new");
            remove_tree(album_ / "real/new");
        }
        done = true;
        other.join();
        QVERIFY(swaps > 0 && written > 0 && refused > 0);
        QVERIFY(state_of(outside_) == before);
    }
};

QTEST_GUILESS_MAIN(ForeignFolderTest)
#include "foreign_folder_test.moc"
