// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../until.hpp"
#include "pty_board.hpp"

#include <QFile>
#include <QProcess>

#include <string>

namespace tp::testing {

/// board_puller as this environment has it: TP_BOARD_PULLER is its command, words apart by ';'. Under Wine
/// (TP_WINE_PREFIX is its folder) a pseudo-terminal is a COM port.
inline QStringList puller_command() { return qEnvironmentVariable("TP_BOARD_PULLER").split(';'); }

inline QString port_name(const std::string& path) {
    const QString prefix = qEnvironmentVariable("TP_WINE_PREFIX");
    if (prefix.isEmpty())
        return QString::fromStdString(path);
    static int count = 9; // its own devices have the first names
    const QString number = QString::number(++count);
    QFile::remove(prefix + "/dosdevices/com" + number);
    QFile::link(QString::fromStdString(path), prefix + "/dosdevices/com" + number);
    return "COM" + number;
}

inline void start_puller(QProcess& process, const QStringList& words) {
    QStringList command = puller_command();
    const QString program = command.takeFirst();
    process.start(program, command + words);
    process.waitForStarted(-1);
}

/// A board_puller that pulls on a board.
struct Puller {
    static constexpr int most_attempts = 20;
    QProcess process;
    bool pulled = false; ///< once at least: on a busy machine the guard may have stepped in since

    explicit Puller(PtyBoard& board) {
        process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        const QString port = port_name(board.path());
        // On a busy machine the board may answer too late for a program that opens it.
        for (int attempt = 0; attempt < most_attempts && !pulled; ++attempt) {
            until([&] { return board.heard() == 0 || board.hung_up(); });
            start_puller(process, {"pull", port, qEnvironmentVariable("TP_FORCE_GUARD")});
            until([&] {
                pulled = board.pulls();
                return pulled || process.state() == QProcess::NotRunning || process.waitForFinished(0);
            });
        }
    }
};

} // namespace tp::testing
