// SPDX-License-Identifier: Apache-2.0
// Names on the disk, what is in a folder, and which process is meant.
#include "core/files/durable_file.hpp"
#include "core/files/file_system.hpp"
#include "core/files/open_folder.hpp"
#include "core/files/whole_file.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

using namespace tp;
namespace fs = std::filesystem;
using Kind = FileFacts::Kind;

class NamesTest : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;
    fs::path root_;

    std::string content(const char* name) const { return *read_whole(root_ / name, 1000); }
    static auto open_files() {
        return std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator());
    }

private slots:
    void init() {
        root_ = fs::path(dir_.path().toStdString()) / QTest::currentTestFunction();
        fs::create_directory(root_);
        for (const char* name : {"a", "b"})
            QCOMPARE(replace_file(root_ / name, name), std::string());
    }

    void a_link_has_a_name_and_what_it_leads_to_another() {
        fs::create_symlink("a", root_ / "link");
        fs::create_symlink("nowhere", root_ / "broken");
        QVERIFY(facts_of(root_ / "link")->kind == Kind::file);
        QVERIFY(facts_of(root_ / "link")->identity == facts_of(root_ / "a")->identity);
        QVERIFY(facts_of_name(root_ / "link")->kind == Kind::link);
        QVERIFY(facts_of_name(root_ / "broken")->kind == Kind::link);
        QVERIFY(facts_of_name(root_)->kind == Kind::folder);
        QVERIFY(!facts_of(root_ / "broken"));
        QCOMPARE(errno, ENOENT);
        QVERIFY(!facts_of_name(root_ / "missing"));
    }

    void only_a_free_name_is_given_where_that_was_meant() {
        QCOMPARE(rename_to_free(root_ / "a", root_ / "b"), EEXIST);
        QCOMPARE(move_to_free(root_ / "a", root_ / "b"), EEXIST);
        QCOMPARE(content("b"), std::string("b"));
        QCOMPARE(swap_names(root_ / "a", root_ / "b"), 0);
        QCOMPARE(content("a") + content("b"), std::string("ba"));
        QCOMPARE(swap_names(root_ / "a", root_ / "missing"), ENOENT);
        QCOMPARE(rename_over(root_ / "a", root_ / "b"), 0);
        QCOMPARE(content("b"), std::string("b"));
        QCOMPARE(rename_over(root_ / "a", root_ / "b"), ENOENT);
        QCOMPARE(rename_to_free(root_ / "b", root_ / "c"), 0);
        QCOMPARE(move_to_free(root_ / "c", root_ / "d"), 0);
        QCOMPARE(content("d"), std::string("b"));
        QCOMPARE(remove_name(root_ / "d"), 0);
        QCOMPARE(remove_name(root_ / "d"), ENOENT);
        QVERIFY(fs::is_empty(root_));
    }

    void a_folder_is_made_once() {
        QCOMPARE(make_directory(root_ / "folder", Readers::as_usual), 0);
        QCOMPARE(make_directory(root_ / "folder", Readers::as_usual), EEXIST);
        QCOMPARE(make_directory(root_ / "a", Readers::as_usual), EEXIST);
        QCOMPARE(names_to_disk(root_ / "folder"), 0);
        QCOMPARE(names_to_disk(root_ / "a"), ENOTDIR);
    }

    /// In the order of their names' bytes, with what links lead to, and only what is wanted.
    void what_is_in_a_folder() {
        fs::create_directory(root_ / "Z");
        fs::create_symlink("Z", root_ / "link");
        fs::create_symlink("nowhere", root_ / "broken");
        const OpenFolder folder(root_);
        QVERIFY(folder.ok());
        QVERIFY(folder.facts()->kind == Kind::folder);
        QVERIFY(folder.facts()->identity == facts_of(root_)->identity);
        int error = -1;
        const auto wanted = [](std::string_view name) { return name != "b" && !name.starts_with('.'); };
        const std::vector<FolderEntry> entries = folder.entries(wanted, error);
        QCOMPARE(error, 0);
        std::string names;
        for (const FolderEntry& entry : entries)
            names += entry.name + (entry.link ? "> " : " ");
        QCOMPARE(names, std::string("Z a link> "));
        QVERIFY(entries[0].facts.kind == Kind::folder && entries[2].facts.kind == Kind::folder);
        QVERIFY(entries[1].facts.kind == Kind::file);
        QCOMPARE(entries[1].facts.bytes, std::uint64_t(1));
        QVERIFY(entries[2].facts.identity == facts_of(root_ / "Z")->identity);
    }

    /// It has no names any more, and that is no fault.
    void a_folder_that_has_just_gone_is_empty() {
        fs::create_directory(root_ / "gone");
        const OpenFolder folder(root_ / "gone");
        fs::remove(root_ / "gone");
        int error = -1;
        errno = EIO; // of before
        QVERIFY(folder.entries([](std::string_view) { return true; }, error).empty());
        QCOMPARE(error, 0);
    }

    void the_times_of_what_is_not_open_are_nobodys() {
        QCOMPARE(copy_times(OpenFile(), root_ / "a"), EBADF);
        QCOMPARE(copy_times(OpenFile(root_ / "a", {}), root_ / "missing"), ENOENT);
        QCOMPARE(copy_times(OpenFile(root_ / "a", {}), root_ / "b"), 0);
        QCOMPARE(facts_of(root_ / "b")->written_ns, facts_of(root_ / "a")->written_ns);
    }

    void what_is_no_folder_is_not_opened_and_none_is_left_open() {
        const auto before = open_files();
        QVERIFY(!OpenFolder(root_ / "missing").ok());
        QCOMPARE(errno, ENOENT);
        QVERIFY(!OpenFolder(root_ / "a").ok());
        {
            OpenFolder folder(root_);
            QCOMPARE(open_files(), before + 1);
            const OpenFolder moved(std::move(folder));
            QVERIFY(moved.ok());
        }
        QCOMPARE(open_files(), before);
    }

    void now_is_when_a_file_that_is_written_now_was_written() {
        const std::int64_t before = file_clock_ns();
        QCOMPARE(replace_file(root_ / "now", "x"), std::string());
        const std::int64_t written = facts_of(root_ / "now")->written_ns;
        QVERIFY(before <= written);
        // A system may stamp files more finely than that clock tells, whose steps are 10 ms at most (100 Hz).
        QVERIFY(written <= file_clock_ns() + 10'000'000);
    }

    void a_process_lives_until_it_has_ended() {
        QCOMPARE(this_process(), static_cast<long>(::getpid()));
        QVERIFY(process_lives(this_process()));
        QVERIFY(process_lives(1)); // another's, too
        const pid_t child = ::fork();
        if (child == 0)
            ::_exit(0);
        ::waitpid(child, nullptr, 0);
        QVERIFY(!process_lives(child));
    }
};

QTEST_GUILESS_MAIN(NamesTest)
#include "names_test.moc"
