// SPDX-License-Identifier: Apache-2.0
#include "core/svg/contour_sheet.hpp"
#include "test_program.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <csignal>
#include <fstream>
#include <sys/resource.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace sheet_file_test {

using namespace tp;
namespace fs = std::filesystem;

namespace {

ContourSheet sheet_with(std::size_t points) {
    std::vector<Vec2> line;
    for (std::size_t i = 0; i < points; ++i)
        line.emplace_back(static_cast<double>(i), static_cast<double>(i % 7));
    return {100, 100, ContourSheet::Unit::millimetre, {contour_through("line", line, false)}};
}

std::size_t files_in(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

} // namespace

class SheetFileTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    fs::path root_;

private slots:
    void init() {
        root_ = fs::path(folder_.path().toStdString()) / QTest::currentTestFunction();
        fs::create_directory(root_);
    }

    void written_is_read() {
        const fs::path file = root_ / "IMG_1.jpg.contours.svg";
        const auto written = write_sheet(file, sheet_with(5));
        QVERIFY2(written.ok(), written.error().c_str());
        QCOMPARE(*written, file);
        const auto sheet = read_sheet(file);
        QVERIFY2(sheet.ok(), sheet.error().c_str());
        QCOMPARE(sheet->contours[0].pieces.size(), std::size_t{4});
        QCOMPARE(files_in(root_), std::size_t{1});
    }

    void relative_name_in_the_current_folder() {
        const fs::path before = fs::current_path();
        fs::current_path(root_);
        const auto written = write_sheet("a.svg", sheet_with(5));
        const auto sheet = read_sheet("a.svg");
        fs::current_path(before);
        QVERIFY2(written.ok(), written.error().c_str());
        QVERIFY2(sheet.ok(), sheet.error().c_str());
    }

    void names_of_any_letters_and_any_length() {
        for (const std::string& name : {std::string("할머니 👵 %20;'.svg"), std::string(250, 'x')}) {
            QVERIFY(write_sheet(root_ / name, sheet_with(3)).ok());
            QVERIFY(read_sheet(root_ / name).ok());
        }
        const auto too_long = write_sheet(root_ / std::string(300, 'x'), sheet_with(3));
        QVERIFY(!too_long.ok());
        QCOMPARE(files_in(root_), std::size_t{2});
    }

    void replacing_keeps_permissions_and_links() {
        const fs::path file = root_ / "shared.svg";
        const fs::path link = root_ / "link.svg";
        QVERIFY(write_sheet(file, sheet_with(3)).ok());
        fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
        const auto before = fs::status(file).permissions();
        fs::create_symlink("shared.svg", link);
        QVERIFY(write_sheet(link, sheet_with(9)).ok());
        QVERIFY(fs::is_symlink(link));
        QCOMPARE(read_sheet(file)->contours[0].pieces.size(), std::size_t{8});
        QVERIFY(fs::status(file).permissions() == before);
    }

    void a_reader_never_sees_half_a_file() {
        const fs::path file = root_ / "a.svg";
        QVERIFY(write_sheet(file, sheet_with(2)).ok());
        std::atomic<bool> done{false};
        std::thread writer([&] {
            for (std::size_t i = 0; i < 60; ++i)
                static_cast<void>(write_sheet(file, sheet_with(i % 2 == 0 ? 2 : 3000)));
            done = true;
        });
        std::size_t halves = 0;
        while (!done) {
            const auto sheet = read_sheet(file);
            const std::size_t pieces = sheet.ok() ? sheet->contours.at(0).pieces.size() : 0;
            halves += pieces == 1 || pieces == 2999 ? 0 : 1;
        }
        writer.join();
        QCOMPARE(halves, std::size_t{0});
    }

    void folder_that_does_not_exist() {
        const auto written = write_sheet(root_ / "nowhere" / "a.svg", sheet_with(3));
        QVERIFY(!written.ok());
        QVERIFY2(written.error().find("nowhere") != std::string::npos, written.error().c_str());
    }

    void folder_that_may_not_be_written() {
        const fs::path above = folder_.path().toStdString();
        const auto all_may_look = fs::perms::owner_all | fs::perms::others_read | fs::perms::others_exec;
        fs::permissions(above, all_may_look);
        fs::permissions(root_, all_may_look & ~fs::perms::owner_write);
        const bool superuser = ::geteuid() == 0;
        constexpr uid_t nobody = 65534;
        if (superuser && ::seteuid(nobody) != 0)
            QSKIP("the superuser may write everywhere");
        const auto written = write_sheet(root_ / "a.svg", sheet_with(3));
        if (superuser)
            QCOMPARE(::seteuid(0), 0);
        fs::permissions(root_, fs::perms::none);
        if (superuser)
            QCOMPARE(::seteuid(nobody), 0);
        const auto behind_a_door = write_sheet(root_ / "inner" / "a.svg", sheet_with(3));
        const auto read_behind_a_door = read_sheet(root_ / "inner" / "a.svg");
        if (superuser)
            QCOMPARE(::seteuid(0), 0);
        fs::permissions(root_, fs::perms::owner_all);
        QVERIFY(!behind_a_door.ok());
        QVERIFY2(behind_a_door.error().find("not allowed") != std::string::npos,
                 behind_a_door.error().c_str());
        QVERIFY(!read_behind_a_door.ok());
        QVERIFY2(read_behind_a_door.error().find("allowed") != std::string::npos,
                 read_behind_a_door.error().c_str());
        QVERIFY(!written.ok());
        QVERIFY2(written.error().find("not allowed") != std::string::npos, written.error().c_str());
    }

    void a_folder_in_the_file_s_place() {
        fs::create_directory(root_ / "a.svg");
        const auto written = write_sheet(root_ / "a.svg", sheet_with(3));
        QVERIFY(!written.ok());
        QVERIFY2(written.error().find("is a folder") != std::string::npos, written.error().c_str());
        QVERIFY(!read_sheet(root_ / "a.svg").ok());
        QVERIFY(!write_sheet({}, sheet_with(3)).ok());
    }

    /// A limit on the size of files stands in for a disk that fills up half-way.
    void a_write_that_fails_half_way_leaves_the_old_drawing() {
        const fs::path file = root_ / "a.svg";
        QVERIFY(write_sheet(file, sheet_with(4)).ok());
        const auto previous = std::signal(SIGXFSZ, SIG_IGN);
        struct rlimit before {};
        QCOMPARE(::getrlimit(RLIMIT_FSIZE, &before), 0);
        const struct rlimit small { 4096, before.rlim_max };
        QCOMPARE(::setrlimit(RLIMIT_FSIZE, &small), 0);
        const auto written = write_sheet(file, sheet_with(10'000));
        ::setrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, previous);
        QVERIFY(!written.ok());
        QCOMPARE(read_sheet(file)->contours[0].pieces.size(), std::size_t{3});
        QCOMPARE(files_in(root_), std::size_t{1});
    }

    void a_sheet_without_size_replaces_nothing() {
        const fs::path file = root_ / "a.svg";
        QVERIFY(write_sheet(file, sheet_with(4)).ok());
        QVERIFY(!write_sheet(file, {0, 10, ContourSheet::Unit::millimetre, {}}).ok());
        QCOMPARE(read_sheet(file)->contours[0].pieces.size(), std::size_t{3});
    }

    void what_is_no_drawing() {
        QVERIFY(!read_sheet(root_ / "missing.svg").ok());
        QVERIFY(read_sheet(root_ / "missing.svg").error().find("missing.svg") != std::string::npos);
        std::ofstream(root_ / "empty.svg").close();
        QVERIFY(!read_sheet(root_ / "empty.svg").ok());
        QVERIFY(!read_sheet(root_).ok());
        QVERIFY(!read_sheet({}).ok());
        const fs::path pipe = root_ / "pipe.svg";
        QCOMPARE(::mkfifo(pipe.c_str(), 0600), 0);
        QVERIFY(!read_sheet(pipe).ok());
        QVERIFY(!read_sheet("/dev/zero").ok());
    }

    void a_file_of_more_than_64_mib() {
        const fs::path file = root_ / "huge.svg";
        std::ofstream(file).close();
        fs::resize_file(file, (std::uintmax_t{64} << 20) + 1);
        const auto sheet = read_sheet(file);
        QVERIFY(!sheet.ok());
        QVERIFY2(sheet.error().find("64 MB") != std::string::npos, sheet.error().c_str());
    }
};

} // namespace sheet_file_test

TP_TEST(sheet_file_test, SheetFileTest, event_loop)
#include "sheet_file_test.moc"
