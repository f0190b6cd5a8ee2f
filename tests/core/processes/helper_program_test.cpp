// SPDX-License-Identifier: Apache-2.0
#include "core/processes/child_process.hpp"
#include "core/processes/our_programs.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

using namespace tp;
namespace fs = std::filesystem;

namespace {

/// A prefix where `program` is installed, with a helper beside it or where helpers are installed.
struct Prefix {
    QTemporaryDir folder;
    std::string ending = this_program().extension() == ".exe" ? ".exe" : "";
    fs::path program = in("bin/program");

    Prefix() {
        fs::create_directories(program.parent_path());
        fs::create_directories(in("libexec/program/helper").parent_path());
        fs::copy_file(beside_this_program("helper_finder"), program);
    }
    fs::path in(const char* name) const {
        return folder.filePath(name + QString::fromStdString(ending)).toStdString();
    }
    fs::path helper_at(const char* name) const { return std::ofstream(in(name)) ? in(name) : fs::path(); }
    std::string found(const std::vector<std::string>& words = {}) const {
        const std::string where = folder.filePath("found").toStdString();
        std::vector<std::string> all{where};
        all.insert(all.end(), words.begin(), words.end());
        ChildProcess::start(program, all, {}, Streams::none); // and waits until it has ended
        std::ifstream file(where);
        return {std::istreambuf_iterator<char>(file), {}};
    }
};

} // namespace

class HelperProgramTest : public QObject {
    Q_OBJECT
private slots:
    void as_built_it_lies_beside_the_program() {
        const Prefix prefix;
        QVERIFY(!prefix.helper_at("libexec/program/helper").empty());
        const fs::path beside = prefix.helper_at("bin/helper");
        QVERIFY(!beside.empty());
        QCOMPARE(prefix.found(), beside.generic_string());
    }

    void as_installed_it_lies_in_the_program_s_own_folder() {
        const Prefix prefix;
        QCOMPARE(prefix.found(), prefix.in("libexec/program/helper").generic_string());
    }

    void a_program_that_was_upgraded_while_it_runs_still_finds_it() {
        const Prefix prefix;
        QCOMPARE(prefix.found({"upgraded"}), prefix.in("libexec/program/helper").generic_string());
        QVERIFY(fs::exists(prefix.program));
    }
};

QTEST_GUILESS_MAIN(HelperProgramTest)
#include "helper_program_test.moc"
