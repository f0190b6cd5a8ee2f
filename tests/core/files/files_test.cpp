// SPDX-License-Identifier: Apache-2.0
#include "core/files/durable_file.hpp"
#include "core/files/file_system.hpp"
#include "core/files/file_words.hpp"
#include "core/files/first_line.hpp"
#include "core/files/folder_lock.hpp"
#include "core/files/free_name.hpp"
#include "core/files/photo_endings.hpp"
#include "core/files/whole_file.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#if defined(__linux__)
#include <sys/xattr.h>
#endif
#include <unistd.h>
#include <vector>

using namespace tp;
namespace fs = std::filesystem;

namespace {

std::string content(const fs::path& file) {
    const auto bytes = read_whole(file, 1 << 24);
    return bytes ? *bytes : "error: " + bytes.error();
}

unsigned mode_of(const fs::path& file) {
    struct stat about {};
    return ::stat(file.c_str(), &about) == 0 ? about.st_mode & 0777u : 0;
}

} // namespace

class FilesTest : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;
    fs::path root_;

    long files_here() const { return std::distance(fs::directory_iterator(root_), fs::directory_iterator()); }

private slots:
    void init() {
        root_ = fs::path(dir_.path().toStdString()) / QTest::currentTestFunction();
        fs::create_directory(root_);
    }

    void the_first_free_name_is_that_of_which_all_are_free() {
        const auto named = [&](int number) {
            const std::string name = std::to_string(number);
            return std::vector{root_ / (name + ".csv"), root_ / (name + ".json")};
        };
        QCOMPARE(free_name(named).value(), root_ / "1.csv");
        QCOMPARE(replace_file(root_ / "1.json", ""), std::string());
        fs::create_symlink("nowhere", root_ / "2.csv");
        QCOMPARE(free_name(named).value(), root_ / "3.csv");
        QCOMPARE(replace_file(root_ / "0", ""), std::string());
        QVERIFY(free_name([&](int) { return std::vector{root_ / "0/1"}; }).ok()); // making it tells why not
    }
    /// A disk that does not tell whether a name is taken, by a name that is too long for it.
    void a_name_that_is_not_known_is_not_free() {
        const auto named = [&](int) { return std::vector{root_ / std::string(300, 'n')}; };
        QCOMPARE(free_name(named).error(), reason_of(ENAMETOOLONG));
    }

    void what_is_written_is_read() {
        const fs::path file = root_ / "a";
        for (const std::string& bytes : {std::string("one"), std::string(), std::string(300'000, '\0')}) {
            QCOMPARE(replace_file(file, bytes), std::string());
            QCOMPARE(content(file), bytes);
        }
        QCOMPARE(files_here(), 1L);
    }

    void the_first_line_is_without_its_end_and_never_longer_than_it_may_be() {
        const auto of = [this](const std::string& bytes) {
            return replace_file(root_ / "a", bytes).empty() ? first_line(root_ / "a") : "not written";
        };
        QCOMPARE(of("Webcam\n"), std::string("Webcam"));
        QCOMPARE(of("Webcam"), std::string("Webcam"));
        QCOMPARE(of("\nWebcam\n"), std::string());
        QCOMPARE(of(""), std::string());
        QCOMPARE(of(std::string(longest_first_line, 'x')), std::string(longest_first_line, 'x'));
        QCOMPARE(of(std::string(1 << 20, 'x')), std::string(longest_first_line, 'x'));
        QCOMPARE(first_line(root_ / "none"), std::string());
        QCOMPARE(first_line(root_), std::string());
        QCOMPARE(::mkfifo((root_ / "pipe").c_str(), 0600), 0);
        QCOMPARE(first_line(root_ / "pipe"), std::string()); // and waits for nobody who writes into it
    }

    void owner_only_is_so_from_the_first_byte() {
        ::umask(022);
        auto made = NewFile::beside(root_ / "secret", Readers::owner_only);
        QVERIFY(made.ok());
        QCOMPARE(mode_of(made->temporary()), 0600u);
        QCOMPARE(made->write("x"), std::string());
        QCOMPARE(made->take_place(), std::string());
        QVERIFY(made->temporary().empty());
        QCOMPARE(mode_of(root_ / "secret"), 0600u);
        QCOMPARE(replace_file(root_ / "open", "x"), std::string());
        QCOMPARE(mode_of(root_ / "open"), 0644u);
        QCOMPARE(make_folder(root_ / "deep" / "secret", Readers::owner_only), std::string());
        QCOMPARE(mode_of(root_ / "deep"), 0700u);
        QCOMPARE(make_folder(root_ / "shared" / "open"), std::string());
        QCOMPARE(mode_of(root_ / "shared"), 0755u);
        QCOMPARE(mode_of(root_ / "shared" / "open"), 0755u);
    }

    void a_copy_is_no_more_open_than_what_it_is_copied_from() {
        ::umask(022);
        for (const auto& [mode, copied] :
             {std::pair{0600u, 0600u}, {0640u, 0640u}, {0777u, 0644u}, {0400u, 0600u}}) {
            const fs::path from = root_ / ("from" + std::to_string(mode)),
                           to = root_ / ("to" + std::to_string(mode));
            QCOMPARE(replace_file(from, "x"), std::string());
            ::chmod(from.c_str(), mode);
            QCOMPARE(copy_whole(from, to), std::string());
            QCOMPARE(mode_of(to), copied);
        }
        ::chmod((root_ / "from384").c_str(), 0640);
        QVERIFY(more_open_than(root_ / "from384", root_ / "to384"));
        QVERIFY(!more_open_than(root_ / "to384", root_ / "from384"));
        QCOMPARE(no_more_open_than(root_ / "from384", root_ / "to384"), 0);
        QCOMPARE(mode_of(root_ / "from384"), 0600u);
        QVERIFY(!more_open_than(root_ / "from384", root_ / "to384"));
        QVERIFY(!more_open_than(root_ / "none", root_ / "to384") &&
                !more_open_than(root_ / "to384", root_ / "none"));
    }

    /// As `setfacl -m d:u:1234:r` makes it.
    void who_a_folder_names_may_read_what_is_made_in_it() {
#if defined(__linux__)
        struct Entry {
            std::uint16_t tag, rights;
            std::uint32_t who;
        };
        constexpr std::uint32_t nobody = 0xFFFFFFFF, version = 2;
        const std::array<Entry, 5> entries{
            { {0x01, 7, nobody},
              {0x02, 4, 1234},
              {0x04, 0, nobody},
              {0x10, 4, nobody},
              { 0x20,
                0,
                nobody } }};
        std::string list(sizeof version + sizeof entries, '\0');
        std::memcpy(list.data(), &version, sizeof version);
        std::memcpy(list.data() + sizeof version, entries.data(), sizeof entries);
        QVERIFY(!names_its_readers(root_));
        if (::setxattr(root_.c_str(), "system.posix_acl_default", list.data(), list.size(), 0) != 0)
            QSKIP("The file system of temporary files knows no access control lists.");
        QVERIFY(names_its_readers(root_));
        ::umask(077);
        QCOMPARE(replace_file(root_ / "secret", "x", Readers::owner_only), std::string());
        QCOMPARE(make_folder(root_ / "own", Readers::owner_only), std::string());
        QCOMPARE(replace_file(root_ / "own" / "secret", "x", Readers::owner_only), std::string());
        for (const fs::path& made : {root_ / "secret", root_ / "own" / "secret"}) {
            QCOMPARE(mode_of(made), 0640u); // the list's mask stands where a group's rights do
            QVERIFY(::getxattr(made.c_str(), "system.posix_acl_access", nullptr, 0) > 0);
        }
        QVERIFY(names_its_readers(root_ / "own"));
        ::umask(022);
#else
        QSKIP("Only Linux has such lists.");
#endif
    }

    void a_replaced_file_keeps_who_may_read_it() {
        QCOMPARE(replace_file(root_ / "a", "x"), std::string());
        ::chmod((root_ / "a").c_str(), 0640);
        QCOMPARE(replace_file(root_ / "a", "y"), std::string());
        QCOMPARE(mode_of(root_ / "a"), 0640u);
        ::chmod((root_ / "a").c_str(), 0755);
        QCOMPARE(replace_file(root_ / "a", "z"), std::string());
        QCOMPARE(mode_of(root_ / "a"), 0755u);
    }

    void what_was_swapped_out_can_be_looked_at() {
        QCOMPARE(replace_file(root_ / "a", "theirs"), std::string());
        {
            auto made = NewFile::beside(root_ / "a");
            QCOMPARE(made->write("ours"), std::string());
            QCOMPARE(made->take_place(Existing::swapped), std::string());
            QCOMPARE(content(root_ / "a"), std::string("ours"));
            if (!made->temporary().empty()) // a file system that cannot swap
                QCOMPARE(content(made->temporary()), std::string("theirs"));
        }
        QCOMPARE(files_here(), 1L);
        auto alone = NewFile::beside(root_ / "b");
        QVERIFY(!alone->take_place(Existing::swapped).empty() || alone->temporary().empty());
    }

    void a_folder_is_locked_by_one() {
        {
            const FolderLock first(root_);
            QVERIFY(first.held());
            QVERIFY(!FolderLock(root_, std::chrono::milliseconds(0)).held());
        }
        QVERIFY(FolderLock(root_, std::chrono::milliseconds(0)).held());
        QCOMPARE(files_here(), 0L);
    }

    void one_that_is_given_up_leaves_nothing() {
        {
            auto made = NewFile::beside(root_ / "a");
            QVERIFY(made.ok());
            QVERIFY(is_temporary(made->temporary()));
            QCOMPARE(made->write("half"), std::string());
            NewFile elsewhere = std::move(*made);
            QCOMPARE(files_here(), 1L);
        }
        QCOMPARE(files_here(), 0L);
        for (int standard = 0; standard < 3; ++standard) // and closes nothing of others'
            QVERIFY(::fcntl(standard, F_GETFD) >= 0 || standard == 0);
        QVERIFY(!is_temporary(root_ / "a.tmp"));
        QVERIFY(!is_temporary(root_ / ".touchphoto-1"));
        QVERIFY(!is_temporary(root_ / "a.touchphoto-1.tmp"));
    }

    void a_name_that_is_taken_is_kept() {
        QCOMPARE(replace_file(root_ / "a", "first"), std::string());
        QCOMPARE(replace_file(root_ / "b", "second"), std::string());
        for (const std::string& reason :
             {move_file(root_ / "b", root_ / "a"), copy_whole(root_ / "b", root_ / "a")})
            QVERIFY2(reason.find("already") != std::string::npos, reason.c_str());
        QCOMPARE(content(root_ / "a"), std::string("first"));
        QCOMPARE(content(root_ / "b"), std::string("second"));
        QCOMPARE(files_here(), 2L);
    }

    void a_copy_has_the_bytes_and_the_time() {
        const std::string bytes(200'001, 'q');
        QCOMPARE(replace_file(root_ / "a", bytes), std::string());
        fs::last_write_time(root_ / "a", fs::file_time_type::clock::now() - std::chrono::hours(1000));
        QCOMPARE(copy_whole(root_ / "a", root_ / "b"), std::string());
        QCOMPARE(content(root_ / "b"), bytes);
        QVERIFY(fs::last_write_time(root_ / "b") == fs::last_write_time(root_ / "a"));
    }

    void moving_a_folder_takes_its_files_along() {
        QCOMPARE(make_folder(root_ / "from" / "deep"), std::string());
        QCOMPARE(replace_file(root_ / "from" / "deep" / "a", "x"), std::string());
        QCOMPARE(move_file(root_ / "from", root_ / "to"), std::string());
        QCOMPARE(content(root_ / "to" / "deep" / "a"), std::string("x"));
    }

    void a_link_stays_a_link() {
        QCOMPARE(replace_file(root_ / "a", "old"), std::string());
        fs::create_symlink("a", root_ / "link");
        QCOMPARE(replace_file(root_ / "link", "new"), std::string());
        QVERIFY(fs::is_symlink(root_ / "link"));
        QCOMPARE(content(root_ / "a"), std::string("new"));
    }

    /// What it leads to is away: a disk that is not plugged in, on which the person's names still are.
    void a_link_to_nothing_stays_a_link() {
        fs::create_directory(root_ / "disk");
        fs::create_symlink("disk/a", root_ / "link");
        fs::create_symlink("link", root_ / "farther");
        QVERIFY(copy_whole(root_ / "farther", root_ / "copy").find("is gone") != std::string::npos);
        QCOMPARE(replace_file(root_ / "farther", "new"), std::string());
        QCOMPARE(content(root_ / "disk" / "a"), std::string("new"));
        fs::remove_all(root_ / "disk");
        QVERIFY(replace_file(root_ / "farther", "x").find("there is no folder") != std::string::npos);
        QVERIFY(fs::is_symlink(root_ / "link") && fs::is_symlink(root_ / "farther"));
        QCOMPARE(files_here(), 2L);
    }

    void a_name_that_a_link_has_is_taken() {
        QCOMPARE(replace_file(root_ / "a", "mine"), std::string());
        fs::create_symlink("nowhere", root_ / "link");
        QVERIFY(copy_whole(root_ / "a", root_ / "link").find("already") != std::string::npos);
        QVERIFY(fs::is_symlink(root_ / "link"));
        QCOMPARE(files_here(), 2L);
    }

    /// As many as the system itself follows, or nearly.
    void a_long_chain_of_links_is_followed_and_a_longer_one_is_not() {
        fs::path last = root_ / "end";
        for (int i = 1; i <= 41; ++i) {
            const fs::path link = root_ / ("link" + std::to_string(i));
            fs::create_symlink(last.filename(), link);
            last = link;
        }
        QCOMPARE(replace_file(root_ / "link39", "new"), std::string());
        QCOMPARE(content(root_ / "end"), std::string("new"));
        QCOMPARE(replace_file(root_ / "link41", "newer"), reason_of(ELOOP));
        QCOMPARE(content(root_ / "end"), std::string("new"));
    }

    void links_that_lead_in_a_circle_are_left() {
        fs::create_symlink("there", root_ / "here");
        fs::create_symlink("here", root_ / "there");
        QVERIFY(!replace_file(root_ / "here", "new").empty());
        QVERIFY(fs::is_symlink(root_ / "here") && fs::is_symlink(root_ / "there"));
    }

    /// A limit on the size of files stands in for a disk that fills up half-way.
    void a_disk_that_fills_up_leaves_the_old_file() {
        QCOMPARE(replace_file(root_ / "a", "old"), std::string());
        QCOMPARE(replace_file(root_ / "large", std::string(100'000, 'l')), std::string());
        const auto previous = std::signal(SIGXFSZ, SIG_IGN);
        struct rlimit before {};
        QCOMPARE(::getrlimit(RLIMIT_FSIZE, &before), 0);
        const struct rlimit small { 4096, before.rlim_max };
        QCOMPARE(::setrlimit(RLIMIT_FSIZE, &small), 0);
        const std::string replaced = replace_file(root_ / "a", std::string(100'000, 'n'));
        const std::string copied = copy_whole(root_ / "large", root_ / "copy");
        ::setrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, previous);
        QVERIFY(!replaced.empty());
        QVERIFY(!copied.empty());
        QCOMPARE(content(root_ / "a"), std::string("old"));
        QCOMPARE(files_here(), 2L);
    }

    void what_is_no_file_is_refused() {
        QCOMPARE(::mkfifo((root_ / "pipe").c_str(), 0600), 0);
        fs::create_directory(root_ / "folder");
        for (const char* name : {"pipe", "folder", "missing"}) {
            QVERIFY2(!read_whole(root_ / name, 100).ok(), name);
            QVERIFY2(!copy_whole(root_ / name, root_ / "copy").empty(), name);
        }
        QVERIFY(!replace_file(root_ / "folder", "x").empty());
        QVERIFY(!replace_file(root_ / "missing" / "a", "x").empty());
        QVERIFY(!replace_file({}, "x").empty());
        QVERIFY(!replace_file(root_ / std::string(256, 'n'), "x").empty());
        QCOMPARE(replace_file(root_ / std::string(255, 'n'), "x"), std::string());
        QCOMPARE(make_folder(root_ / "pipe" / "below"), std::string("there is a file of that name already."));
        QCOMPARE(replace_file(root_ / "a", "x"), std::string());
        QVERIFY(copy_whole(root_ / "a", root_ / "missing" / "a").find("there is no folder") !=
                std::string::npos);
    }

    void a_name_alone_lies_where_we_are() {
        const fs::path before = fs::current_path();
        fs::current_path(root_);
        const std::string replaced = replace_file("a", "x"), copied = copy_whole("a", "b"),
                          made = make_folder("deep/er"), moved = move_file("b", "c");
        const FolderLock held(fs::path{});
        const bool alone = held.held() && !FolderLock(root_, std::chrono::milliseconds(0)).held();
        fs::current_path(before);
        for (const std::string& reason : {replaced, copied, made, moved})
            QCOMPARE(reason, std::string());
        QVERIFY(alone && fs::is_directory(root_ / "deep" / "er"));
        QCOMPARE(content(root_ / "c"), std::string("x"));
    }

    /// Asked as somebody who is not the superuser.
    void what_may_not_be_read_is_said() {
        for (const fs::path& folder : {fs::path(dir_.path().toStdString()), root_})
            fs::permissions(folder, fs::perms::group_exec | fs::perms::others_exec, fs::perm_options::add);
        fs::create_directory(root_ / "shut");
        for (const fs::path& file : {root_ / "shut" / "a", root_ / "secret"})
            QCOMPARE(replace_file(file, "x"), std::string());
        fs::permissions(root_ / "shut", fs::perms::none);
        fs::permissions(root_ / "secret", fs::perms::none);
        const pid_t child = ::fork();
        if (child == 0) {
            constexpr uid_t nobody = 65534;
            if (::geteuid() == 0 && ::seteuid(nobody) != 0)
                ::_exit(77);
            const auto said = [](const fs::path& file, const char* words) {
                return read_whole(file, 100).error().find(words) != std::string::npos;
            };
            const bool all = said(root_ / "shut" / "a", "is in a folder that you are not allowed to open.") &&
                             said(root_ / "secret", "you may not be allowed to read it.") &&
                             NewFile::beside(root_ / "shut" / "b").error() == reason_of(EACCES);
            ::_exit(all ? 7 : 1);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        fs::permissions(root_ / "shut", fs::perms::owner_all);
        if (WIFEXITED(status) && WEXITSTATUS(status) == 77)
            QSKIP("the superuser may read everything");
        QVERIFY(WIFEXITED(status));
        QCOMPARE(WEXITSTATUS(status), 7);
    }

    void too_large_is_said() {
        QCOMPARE(replace_file(root_ / "a", std::string(101, 'x')), std::string());
        QVERIFY(read_whole(root_ / "a", 101).ok());
        QVERIFY(read_whole(root_ / "a", 100).error().find("larger") != std::string::npos);
    }

    void names_are_made_readable_data() {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("shown");
        QTest::newRow("plain") << QByteArray("IMG_1.jpg") << QByteArray("IMG_1.jpg");
        QTest::newRow("German, Hebrew, emoji")
            << QByteArray("Jörg שלום 👵🏽") << QByteArray("Jörg שלום 👵🏽");
        QTest::newRow("line end") << QByteArray("a\nb\tc\x7f") << QByteArray("a b c ");
        QTest::newRow("turns the direction") << QByteArray("a\u202Egpj.exe") << QByteArray("a gpj.exe");
        QTest::newRow("Latin-1") << QByteArray("J\xF6rg") << QByteArray("J\uFFFDrg");
        QTest::newRow("cut character") << QByteArray("a\xE2\x82") << QByteArray("a\uFFFD\uFFFD");
        QTest::newRow("overlong") << QByteArray("\xC0\xAF") << QByteArray("\uFFFD\uFFFD");
        QTest::newRow("surrogate") << QByteArray("\xED\xA0\x80") << QByteArray("\uFFFD\uFFFD\uFFFD");
        QTest::newRow("beyond Unicode")
            << QByteArray("\xF4\x90\x80\x80") << QByteArray("\uFFFD\uFFFD\uFFFD\uFFFD");
    }

    void names_are_made_readable() {
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, shown);
        QCOMPARE(QByteArray::fromStdString(readable(name.toStdString())), shown);
        QCOMPARE(QByteArray::fromStdString(quoted(fs::path(name.toStdString()))), "\"" + shown + "\"");
    }

    /// The first and the last of each kind, and their neighbours.
    void what_hides_or_turns_a_name_is_a_space_and_nothing_else_is() {
        const auto shown = [](char32_t code) {
            return QString::fromStdString(readable(QString::fromUcs4(&code, 1).toStdString()));
        };
        for (const char32_t hidden : {U'\x00', U'\x1F', U'\x7F', U'\x80', U'\x9F', U'\u061C', U'\u200E',
                                      U'\u200F', U'\u2028', U'\u202E', U'\u2066', U'\u2069'})
            QCOMPARE(shown(hidden), QString(" "));
        for (const char32_t seen : {U'\x20', U'\x7E', U'\xA0', U'\u061B', U'\u061D', U'\u200D', U'\u2010',
                                    U'\u2027', U'\u202F', U'\u2065', U'\u206A'})
            QCOMPARE(shown(seen), QString::fromUcs4(&seen, 1));
    }

    void each_common_reason_has_words_of_its_own() {
        for (const int error : {EACCES, EPERM, EROFS})
            QCOMPARE(reason_of(error), std::string("you are not allowed to write there."));
        for (const int error : {ENOSPC, EDQUOT})
            QCOMPARE(reason_of(error), std::string("the disk is full."));
        QCOMPARE(reason_of(EIO), std::string("the disk reports a fault."));
        QCOMPARE(reason_of(ENAMETOOLONG), std::string("its name is too long."));
        QCOMPARE(reason_of(ENOENT), std::string("its folder is gone."));
        QCOMPARE(reason_of(EEXIST), std::string("there is a file of that name already."));
    }

    void what_cannot_be_read_is_told_apart() {
        fs::create_directory(root_ / "folder");
        QCOMPARE(::mkfifo((root_ / "pipe").c_str(), 0600), 0);
        const auto said = [&](const char* name, const char* words) {
            return read_whole(root_ / name, 100).error().find(words) != std::string::npos;
        };
        QVERIFY(said("folder", "is a folder, not a file."));
        QVERIFY(said("pipe", "is not a file."));
        QVERIFY(said("missing", "There is no file"));
        QCOMPARE(replace_file(root_ / "large", std::string(3 << 20, 'x')), std::string());
        QVERIFY(read_whole(root_ / "large", 2 << 20).error().find("larger than 2 MB") != std::string::npos);
        QVERIFY(read_whole(root_ / "large", 64 << 10).error().find("larger than 64 KB") != std::string::npos);
        QVERIFY(copy_whole(root_ / "pipe", root_ / "copy").find("is not a file.") != std::string::npos);
        QVERIFY(replace_file(root_ / "folder", "x").find("is a folder.") != std::string::npos);
        QVERIFY(replace_file(root_ / "no" / "a", "x").find("there is no folder") != std::string::npos);
        QVERIFY(name_taken(root_ / "pipe") && !name_taken(root_ / "missing"));
        fs::create_symlink("nowhere", root_ / "broken");
        QVERIFY(name_taken(root_ / "broken"));
    }

    void a_photo_is_told_by_its_ending() {
        for (const char* name : {"a.jpg", "a.JPG", "a.b.HeIc", "x.rw2", "a.tiff"})
            QVERIFY2(has_photo_ending(name), name);
        for (const char* name : {"a", "jpg", ".jpg", "a.jpg.txt", "a.gif", "a."})
            QVERIFY2(!has_photo_ending(name), name);
    }

    void reasons_end_a_sentence() {
        for (const int error : {EACCES, ENOSPC, EIO, ENAMETOOLONG, ENOENT, EEXIST, EMFILE, 0}) {
            const std::string reason = reason_of(error);
            QVERIFY2(reason.size() > 5 && reason.ends_with('.'), reason.c_str());
        }
    }
};

QTEST_GUILESS_MAIN(FilesTest)
#include "files_test.moc"
