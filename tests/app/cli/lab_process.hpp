// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "places.hpp"

#include <QByteArray>
#include <QFile>
#include <QProcess>
#include <QStringList>

/// How touchphoto-lab ended, as a shell sees it.
struct Run {
    int code = -1;
    QByteArray out;
    QByteArray err;
};

/// Without the lines that say how far the work is: they come by the clock.
inline QByteArray without_progress(const QByteArray& err) {
    QByteArray rest;
    for (const QByteArray& line : err.split('\n'))
        if (!line.startsWith("… "))
            rest += line + '\n';
    rest.chop(1);
    return rest;
}

inline Run ended(QProcess& process) {
    const bool well = process.waitForFinished(240'000) && process.exitStatus() == QProcess::NormalExit;
    Run run{well ? process.exitCode() : -1, process.readAllStandardOutput(), {}};
    if (process.processChannelMode() == QProcess::SeparateChannels)
        run.err = without_progress(process.readAllStandardError());
    if (!well)
        run.err += "\ncrashed or hung";
    return run;
}

inline Run lab(const QStringList& words, const QByteArray& input = {}) {
    QProcess process;
    process.start(tp::test::in_build("bin/touchphoto-lab"), words);
    process.write(input);
    process.closeWriteChannel();
    return ended(process);
}

/// The file's name, now that it holds these bytes.
inline QString written(const QString& name, const QByteArray& bytes) {
    QFile file(name);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("cannot write %s", qPrintable(name));
    return name;
}

/// One sentence on one line, and nothing a person cannot read.
inline bool is_one_sentence(const QByteArray& text) {
    return text.endsWith(".\n") && text.count('\n') == 1 && text.size() > 20;
}
