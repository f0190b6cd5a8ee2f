// SPDX-License-Identifier: Apache-2.0
// What becomes of files that are being written when a process ends, and of their names.
#include "core/files/durable_file.hpp"
#include "core/files/whole_file.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <fcntl.h>
#include <filesystem>
#include <iterator>
#include <memory>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>

using namespace tp;
namespace fs = std::filesystem;

class NewFileTest : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;
    fs::path root_;

    std::string content(const char* name) const {
        const auto bytes = read_whole(root_ / name, 1 << 20);
        return bytes ? *bytes : "error: " + bytes.error();
    }
    long files_here() const { return std::distance(fs::directory_iterator(root_), fs::directory_iterator()); }

private slots:
    void init() {
        root_ = fs::path(dir_.path().toStdString()) / QTest::currentTestFunction();
        fs::create_directory(root_);
        for (const char* name : {"a", "b"})
            QCOMPARE(replace_file(root_ / name, name), std::string());
    }

    /// A process that ends in the middle of its writing leaves no half a file, and begins none.
    void a_process_that_gives_up_leaves_what_was_there() {
        const pid_t child = ::fork();
        if (child == 0) {
            ::alarm(20);
            auto made = NewFile::beside(root_ / "a");
            auto other = NewFile::beside(root_ / "fresh");
            auto placed = NewFile::beside(root_ / "b");
            auto done = std::make_unique<NewFile>(std::move(*placed));
            const bool written = made->write("half").empty() && other->write("half").empty() &&
                                 done->write("whole").empty() && done->take_place().empty();
            NewFile::give_up_all();
            done.reset(); // has its place, and waits for nobody
            std::atomic<bool> begun{false};
            std::thread late([&] { static_cast<void>(made->take_place()); }); // waits for the end
            std::thread later([&] { begun = NewFile::beside(root_ / "later").ok(); });
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            ::_exit(written && !begun ? 7 : 1);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        QVERIFY(WIFEXITED(status));
        QCOMPARE(WEXITSTATUS(status), 7);
        QCOMPARE(content("a"), std::string("a"));
        QCOMPARE(content("b"), std::string("whole"));
        QCOMPARE(files_here(), 2L);
    }

    void what_is_made_together_goes_or_stays_together_data() {
        QTest::addColumn<bool>("list"), QTest::addColumn<bool>("ended"), QTest::addColumn<bool>("stays");
        QTest::newRow("before the list has its place") << false << false << false;
        QTest::newRow("when the list has its place") << true << false << true;
        QTest::newRow("where nothing lists it") << false << true << true;
    }
    void what_is_made_together_goes_or_stays_together() {
        QFETCH(bool, list);
        QFETCH(bool, ended);
        QFETCH(bool, stays);
        fs::remove(root_ / "sound");
        const pid_t child = ::fork();
        if (child == 0) {
            ::alarm(20);
            auto together = std::make_unique<MadeTogether>();
            auto made = NewFile::beside(root_ / "sound");
            bool done = made->write("whole").empty() && made->take_place(Existing::kept).empty();
            if (list) {
                together->next_completes();
                auto listed = NewFile::beside(root_ / "a");
                done = done && listed->write("list").empty() && listed->take_place(Existing::swapped).empty();
            }
            if (ended)
                together.reset();
            NewFile::give_up_all();
            ::_exit(done ? 7 : 1);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        QVERIFY(WIFEXITED(status));
        QCOMPARE(WEXITSTATUS(status), 7);
        QCOMPARE(fs::exists(root_ / "sound"), stays);
        QCOMPARE(content("a"), std::string(list ? "list" : "a"));
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
};

QTEST_GUILESS_MAIN(NewFileTest)
#include "new_file_test.moc"
