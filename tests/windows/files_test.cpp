// SPDX-License-Identifier: Apache-2.0
// What files, libraries and real time need of Windows.
#include "core/files/durable_file.hpp"
#include "core/files/file_system.hpp"
#include "core/files/file_words.hpp"
#include "core/files/folder_lock.hpp"
#include "core/files/growing_file.hpp"
#include "core/files/new_file.hpp"
#include "core/files/open_folder.hpp"
#include "core/files/whole_file.hpp"
#include "core/libraries/loaded_library.hpp"
#include "core/servo/real_time.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <string>
#include <thread>

using namespace tp;
namespace fs = std::filesystem;

class FilesTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    fs::path root_ = std::string(folder_.path());

    std::string content(const fs::path& file) const { return read_whole(file, 1 << 20).value(); }
    std::size_t count() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(root_), {}));
    }

private slots:
    void init() {
        for (const auto& one : fs::directory_iterator(root_))
            fs::remove_all(one.path());
    }

    void a_file_is_replaced_as_a_whole_and_nothing_is_left_beside_it() {
        QCOMPARE(replace_file(root_ / "a", "one"), std::string());
        QCOMPARE(replace_file(root_ / "a", "another\r\n\x1A!"), std::string());
        QCOMPARE(content(root_ / "a"), std::string("another\r\n\x1A!"));
        QCOMPARE(count(), std::size_t{1});
    }

    void a_folder_on_a_disk_that_is_not_there_is_refused() {
        QVERIFY(!make_folder("Y:\\").empty());
        QVERIFY(!make_folder("Y:\\a\\b").empty());
    }

    void a_name_in_any_script_is_a_name() {
        const fs::path file = root_ / fs::path(u8"J\u00f6rg \uc544\uae30 \u05e9.jpg");
        QCOMPARE(replace_file(file, "x"), std::string());
        QVERIFY(facts_of(file).has_value());
        QCOMPARE(quoted(file.filename()),
                 std::string("\"J\xC3\xB6rg \xEC\x95\x84\xEA\xB8\xB0 \xD7\xA9.jpg\""));
    }

    void a_new_file_leaves_nothing_when_it_does_not_take_its_place() {
        {
            auto file = NewFile::beside(root_ / "a");
            QVERIFY(file.ok());
            QVERIFY(is_temporary(file->temporary()));
            QCOMPARE(file->write("half"), std::string());
            QCOMPARE(count(), std::size_t{1});
        }
        QCOMPARE(count(), std::size_t{0});
    }

    void what_has_the_name_is_kept_where_that_was_asked_for() {
        QCOMPARE(replace_file(root_ / "a", "old"), std::string());
        auto file = NewFile::beside(root_ / "a");
        QCOMPARE(file->write("new"), std::string());
        QCOMPARE(file->take_place(Existing::kept), std::string("there is a file of that name already."));
        QCOMPARE(content(root_ / "a"), std::string("old"));
    }

    void files_cannot_be_swapped_and_are_replaced() {
        QCOMPARE(replace_file(root_ / "a", "old"), std::string());
        auto file = NewFile::beside(root_ / "a");
        QCOMPARE(file->write("new"), std::string());
        QCOMPARE(file->take_place(Existing::swapped), std::string());
        QVERIFY(file->temporary().empty());
        QCOMPARE(content(root_ / "a"), std::string("new"));
    }

    void a_swap_with_nothing_says_that_its_folder_is_gone() {
        auto file = NewFile::beside(root_ / "a");
        QCOMPARE(file->take_place(Existing::swapped), std::string("its folder is gone."));
    }

    void a_file_that_another_reads_is_replaced_all_the_same() {
        QCOMPARE(replace_file(root_ / "a", "old"), std::string());
        OpenFile reader(root_ / "a", {});
        QVERIFY(reader.ok());
        const std::string reason = replace_file(root_ / "a", "new");
        if (!reason.empty()) // a Windows that knows no POSIX renaming keeps the old one, whole
            QCOMPARE(content(root_ / "a"), std::string("old"));
        else
            QCOMPARE(content(root_ / "a"), std::string("new"));
    }

    void a_file_and_a_folder_are_moved_to_names_that_are_free() {
        QCOMPARE(make_folder(root_ / "b" / "c", Readers::owner_only), std::string());
        QCOMPARE(replace_file(root_ / "a", "x"), std::string());
        QCOMPARE(move_file(root_ / "a", root_ / "b" / "a"), std::string());
        QCOMPARE(move_file(root_ / "b", root_ / "d"), std::string());
        QCOMPARE(content(root_ / "d" / "a"), std::string("x"));
        QCOMPARE(replace_file(root_ / "e", "y"), std::string());
        QCOMPARE(move_file(root_ / "e", root_ / "d" / "a"),
                 std::string("there is a file of that name already."));
        QCOMPARE(content(root_ / "e"), std::string("y"));
    }

    void a_copy_has_the_bytes_and_the_time() {
        QCOMPARE(replace_file(root_ / "a", std::string(300'000, 'x')), std::string());
        fs::last_write_time(root_ / "a", fs::last_write_time(root_ / "a") - std::chrono::hours(48));
        QCOMPARE(copy_whole(root_ / "a", root_ / "b"), std::string());
        QCOMPARE(content(root_ / "b"), std::string(300'000, 'x'));
        QCOMPARE(facts_of(root_ / "b")->written_ns, facts_of(root_ / "a")->written_ns);
        QCOMPARE(copy_whole(root_, root_ / "c"), quoted(root_) + " is not a file.");
    }

    void a_table_grows_and_is_cut() {
        QCOMPARE(replace_file(root_ / "t", "a\r\n"), std::string());
        QCOMPARE(append_to_file(root_ / "t", 3, "b\n"), std::string());
        QCOMPARE(content(root_ / "t"), std::string("a\r\nb\n"));
        QCOMPARE(append_to_file(root_ / "t", 3, "c\n"), std::string(changed_meanwhile));
        QCOMPARE(cut_file(root_ / "t", 3), std::string());
        QCOMPARE(content(root_ / "t"), std::string("a\r\n"));
        QCOMPARE(append_to_file(root_ / "nothing", 0, "c\n"), std::string("it is gone."));
    }

    void a_folder_is_locked_by_one_at_a_time() {
        {
            const FolderLock first(root_);
            QVERIFY(first.held());
            const FolderLock second(root_, std::chrono::milliseconds(0));
            QVERIFY(!second.held());
            const FolderLock other(root_.parent_path(), std::chrono::milliseconds(0));
            QVERIFY(other.held());
        }
        const FolderLock again(root_, std::chrono::milliseconds(0));
        QVERIFY(again.held());
        QCOMPARE(count(), std::size_t{0});
    }

    void whoever_waits_for_a_folder_gets_it() {
        auto first = std::make_unique<FolderLock>(root_);
        bool held = false;
        std::thread waiting([&] { held = FolderLock(root_).held(); });
        first.reset();
        waiting.join();
        QVERIFY(held);
    }

    void a_file_is_locked_by_one_opening_and_can_be_read_by_all() {
        QCOMPARE(replace_file(root_ / "a", "words"), std::string());
        OpenFile one(root_ / "a", {.write = true});
        OpenFile other(root_ / "a", {.write = true});
        QVERIFY(one.lock());
        QVERIFY(!other.lock());
        QCOMPARE(errno, EWOULDBLOCK);
        QCOMPARE(content(root_ / "a"), std::string("words"));
        one.close();
        QVERIFY(other.wait_for_lock());
    }

    void bytes_are_read_and_written_at_their_places() {
        OpenFile file(root_ / "a", {.write = true, .make = true, .only_new = true});
        QVERIFY(file.ok());
        QVERIFY(!OpenFile(root_ / "a", {.write = true, .make = true, .only_new = true}).ok());
        QCOMPARE(errno, EEXIST);
        QCOMPARE(file.write("0123456789").error, 0);
        QCOMPARE(file.write_at(3, "abc").count, std::size_t{3});
        std::string bytes(20, '.');
        QCOMPARE(file.read_at(2, bytes), std::size_t{8});
        QCOMPARE(bytes.substr(0, 8), std::string("2abc6789"));
        QCOMPARE(file.go_to(-2, SEEK_END), std::int64_t{8});
        QCOMPARE(file.read(bytes), std::int64_t{2});
        QCOMPARE(file.facts()->bytes, std::uint64_t{10});
        QCOMPARE(file.to_disk(), 0);
    }

    void what_is_written_at_the_end_stays_there() {
        QCOMPARE(replace_file(root_ / "a", "one "), std::string());
        OpenFile file(root_ / "a", {.write = true, .at_end = true});
        QCOMPARE(file.go_to(0, SEEK_SET), std::int64_t{0});
        QCOMPARE(file.write("two").error, 0);
        QCOMPARE(content(root_ / "a"), std::string("one two"));
        OpenFile emptied(root_ / "a", {.write = true, .emptied = true});
        QCOMPARE(emptied.facts()->bytes, std::uint64_t{0});
    }

    void what_is_not_there_is_told_as_on_other_systems() {
        QVERIFY(!OpenFile(root_ / "none", {}).ok());
        QCOMPARE(errno, ENOENT);
        QVERIFY(!OpenFile(root_, {.write = true}).ok());
        QCOMPARE(errno, EISDIR);
        QVERIFY(OpenFile(root_, {}).facts()->kind == FileFacts::Kind::folder);
        QVERIFY(!facts_of(root_ / "none" / "at all"));
        QCOMPARE(make_directory(root_, Readers::as_usual), EEXIST);
        QCOMPARE(remove_name(root_ / "none"), ENOENT);
    }

    void one_file_has_one_identity() {
        QCOMPARE(replace_file(root_ / "a", "x"), std::string());
        QCOMPARE(replace_file(root_ / "b", "x"), std::string());
        QVERIFY(facts_of(root_ / "a")->identity == facts_of(root_ / "." / "a")->identity);
        QVERIFY(facts_of(root_ / "a")->identity != facts_of(root_ / "b")->identity);
        QVERIFY(facts_of(root_)->kind == FileFacts::Kind::folder);
    }

    void a_folder_tells_what_is_in_it() {
        QCOMPARE(replace_file(root_ / "b.jpg", "12345"), std::string());
        QCOMPARE(make_folder(root_ / "a"), std::string());
        QCOMPARE(replace_file(root_ / ".hidden", ""), std::string());
        const OpenFolder folder(root_);
        int error = 0;
        const auto entries =
            folder.entries([](std::string_view name) { return !name.starts_with('.'); }, error);
        QCOMPARE(error, 0);
        QCOMPARE(entries.size(), std::size_t{2});
        QCOMPARE(entries[0].name, std::string("a"));
        QVERIFY(entries[0].facts.kind == FileFacts::Kind::folder);
        QCOMPARE(entries[1].facts.bytes, std::uint64_t{5});
        QVERIFY(std::abs(entries[1].facts.written_ns - file_clock_ns()) < 600'000'000'000);
        QVERIFY(!OpenFolder(root_ / "none").ok());
    }

    void this_process_lives() {
        QVERIFY(process_lives(this_process()));
        QVERIFY(!process_lives(0x7FFFFFF0));
    }

    void a_library_is_loaded_with_its_functions() {
        const LoadedLibrary library("kernel32.dll");
        unsigned long (*number)() = nullptr;
        QVERIFY(library.find(number, "GetCurrentProcessId"));
        QCOMPARE(static_cast<long>(number()), this_process());
        QVERIFY(!library.find(number, "no_such_function"));
        QVERIFY(!LoadedLibrary("no_such_library.dll").find(number, "GetCurrentProcessId"));
    }

    void the_servo_gets_its_priority_and_its_memory() {
        QVERIFY(prefer_real_time(1));
        int data = 0;
        QVERIFY(lock_memory(&data, sizeof data));
        forget_memory(&data, sizeof data);
    }
};

QTEST_GUILESS_MAIN(FilesTest)
#include "files_test.moc"
