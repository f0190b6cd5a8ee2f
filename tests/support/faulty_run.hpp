// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QProcess>
#include <QProcessEnvironment>
#include <QString>
#include <QStringList>

#include <filesystem>
#include <fstream>

namespace tp::test {

/// What a program writes to stdout while `library` (failing_files.cpp) breaks its way to the disk below `below`: "kill@12",
/// "ENOSPC@3", "none@1". `count`: a file for the number of its calls. Ends the test where the program hangs.
inline QByteArray faulty_run(const char* library, const QString& program, const QStringList& arguments,
                             const std::filesystem::path& below, const QByteArray& fault,
                             const std::filesystem::path& count) {
    QProcess worker;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("LD_PRELOAD", library);
    environment.insert("TP_FAULT_BELOW", QString::fromStdString(below.string()));
    environment.insert("TP_FAULT", QString::fromLatin1(fault));
    environment.insert("TP_FAULT_COUNT", QString::fromStdString(count.string()));
    worker.setProcessEnvironment(environment);
    worker.start(program, arguments);
    if (!worker.waitForFinished(240'000))
        qFatal("the worker hangs");
    return worker.readAllStandardOutput();
}

/// The number that it wrote there.
inline long calls_in(const std::filesystem::path& count) {
    long calls = 0;
    std::ifstream(count) >> calls;
    return calls;
}

} // namespace tp::test
