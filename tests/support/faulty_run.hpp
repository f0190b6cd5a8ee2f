// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "places.hpp"

#include <QByteArray>
#include <QProcess>
#include <QProcessEnvironment>
#include <QString>
#include <QStringList>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <vector>

namespace tp::test {

/// What a program writes to stdout while failing_files.cpp breaks its way to the disk below `below`: "kill@12",
/// "ENOSPC@3", "none@1". `count`: a file for the number of its calls. Ends the test where the program hangs.
inline QByteArray faulty_run(const QString& program, const QStringList& arguments,
                             const std::filesystem::path& below, const QByteArray& fault,
                             const std::filesystem::path& count,
                             QProcessEnvironment environment = QProcessEnvironment::systemEnvironment()) {
    QProcess worker;
    // By its folder: the name of a library that is preloaded ends at a blank.
    environment.insert("LD_LIBRARY_PATH", QString(in_build("tests/app/album/keeper")) + QLatin1Char(':') +
                                              environment.value("LD_LIBRARY_PATH"));
    environment.insert("LD_PRELOAD", "libfailing_files.so");
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

/// Faults of these kinds by turns, each at a random one of so many calls; as many as TP_MOMENTS in the environment says, and
/// `usually` without it. The same seed gives the same ones.
inline std::vector<QByteArray> random_faults(int usually, long calls, const std::vector<QByteArray>& kinds,
                                             std::uint32_t seed) {
    const int count = std::max(1, qEnvironmentVariable("TP_MOMENTS", QString::number(usually)).toInt());
    std::mt19937 random(seed);
    std::vector<QByteArray> faults;
    for (int i = 0; i < count; ++i) {
        const long at = 1 + static_cast<long>(random() % static_cast<unsigned long>(calls));
        faults.push_back(kinds[static_cast<std::size_t>(i) % kinds.size()] +
                         QByteArray::number(qlonglong{at}));
    }
    return faults;
}

/// A kill at three in seven, half a write at one, a disk that fails from then on at three.
inline const std::vector<QByteArray> mostly_kills{"kill@",   "kill@", "kill@", "half@",
                                                  "ENOSPC@", "EIO@",  "EROFS@"};

} // namespace tp::test
