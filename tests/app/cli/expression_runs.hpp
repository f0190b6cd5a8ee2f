// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "lab_process.hpp"
#include "places.hpp"

#include <QDir>
#include <QFile>
#include <QMap>
#include <QtGlobal>

/// touchphoto-lab expressions, and what it writes.
namespace expression_runs {

inline const QString samples = QString(tp::test::in_source("resources/samples"));

inline QStringList files_in(const QString& folder, const QString& pattern) {
    QStringList files;
    for (const QString& name : QDir(folder).entryList({pattern}, QDir::Files, QDir::Name))
        files << folder + "/" + name;
    return files;
}

inline QByteArray bytes_of(const QString& name) {
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// "felt sad as_angry" → percent, of every cell of expressions.csv.
using Cells = QMap<QString, double>;

/// The cells that a run with these files writes to the folder `out`; shown with the test, too.
inline Cells table(const QString& out, const QStringList& files, const QStringList& options = {}) {
    QDir(out).removeRecursively();
    const Run run = lab(QStringList{"expressions", "--out", out} + options + files);
    const QList<QByteArray> lines = bytes_of(out + "/expressions.csv").trimmed().split('\n');
    // Photographs of which the extraction is not sure are said, and counted all the same.
    if (run.code < 0 || run.code > 1 || lines.size() < 2)
        qFatal("%s", run.err.constData());
    qInfo("%s", run.out.mid(run.out.indexOf("\n\n") + 2).constData());
    Cells cells;
    const QList<QByteArray> columns = lines.first().split(',');
    for (qsizetype i = 1; i < lines.size(); ++i) {
        const QList<QByteArray> row = lines[i].split(',');
        for (qsizetype c = 2; c < columns.size(); ++c)
            cells[row.value(0) + ' ' + row.value(1) + ' ' + columns[c]] = row.value(c).toDouble();
    }
    return cells;
}

/// Mean of what is named rightly of the paper's four, percent; `measured` is "exact" or "felt".
inline double right(const Cells& cells, const char* measured) {
    double sum = 0.0;
    for (const char* shown : {"smiling", "surprised", "sad", "angry"})
        sum += cells[QStringLiteral("%1 %2 as_%2").arg(measured, shown)];
    return sum / 4.0;
}

} // namespace expression_runs
