// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QProcess>
#include <QStringList>

namespace tp::test {

/// touchphoto-lab as a shell sees it.
struct Run {
    int code = -1;
    QByteArray out;
    QByteArray err;
};

inline Run lab(const QStringList& words, const QByteArray& input = {}) {
    QProcess process;
    process.start(QStringLiteral(TP_LAB), words);
    process.write(input);
    process.closeWriteChannel();
    if (!process.waitForFinished(240'000) || process.exitStatus() != QProcess::NormalExit)
        return {-1, process.readAllStandardOutput(), process.readAllStandardError() + "\ncrashed or hung"};
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

} // namespace tp::test
