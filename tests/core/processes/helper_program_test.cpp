// SPDX-License-Identifier: Apache-2.0
#include "core/processes/child_process_posix.hpp"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

using namespace tp;

namespace {

/// A prefix where `program` is installed, with a helper beside it or where helpers are installed.
struct Prefix {
    QTemporaryDir folder;
    QString program = in("bin/program");

    Prefix() {
        QDir(folder.path()).mkpath("bin");
        QDir(folder.path()).mkpath("libexec/program");
        QFile::copy(QString::fromStdString(beside_this_program("helper_finder").string()), program);
    }
    QString in(const char* name) const { return folder.filePath(name); }
    QString helper_at(const char* name) const {
        QFile file(in(name));
        return file.open(QIODevice::WriteOnly) ? in(name) : QString();
    }
    QString found(const QStringList& words = {}) const {
        QProcess finder;
        finder.start(program, words);
        return finder.waitForFinished() ? QString::fromUtf8(finder.readAll()).trimmed() : QString();
    }
};

} // namespace

class HelperProgramTest : public QObject {
    Q_OBJECT
private slots:
    void as_built_it_lies_beside_the_program() {
        const Prefix prefix;
        QVERIFY(!prefix.helper_at("libexec/program/helper").isEmpty());
        const QString beside = prefix.helper_at("bin/helper");
        QVERIFY(!beside.isEmpty());
        QCOMPARE(prefix.found(), beside);
    }

    void as_installed_it_lies_in_the_program_s_own_folder() {
        const Prefix prefix;
        QCOMPARE(prefix.found(), prefix.in("libexec/program/helper"));
    }

    void a_program_that_was_upgraded_while_it_runs_still_finds_it() {
        const Prefix prefix;
        QCOMPARE(prefix.found({"upgraded"}), prefix.in("libexec/program/helper"));
    }
};

QTEST_MAIN(HelperProgramTest)
#include "helper_program_test.moc"
