// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QProcess>
#include <QString>

#include <csignal>

namespace tp::vm {

/// A program that tells ticks to the output of this name, which it waits for.
class TickingProgram {
public:
    explicit TickingProgram(const QString& name) {
        program_.start(QCoreApplication::applicationDirPath() + "/vm_tell_ticks", {name});
        program_.waitForStarted(-1);
    }
    ~TickingProgram() {
        if (program_.state() == QProcess::Running)
            go_on(); // one that is held would never end
        end();
    }
    TickingProgram(const TickingProgram&) = delete;
    TickingProgram& operator=(const TickingProgram&) = delete;

    /// Waits until it tells ticks; false where it ended before.
    bool ticks() {
        while (!program_.canReadLine())
            if (!program_.waitForReadyRead(-1))
                return false;
        return true;
    }
    void kill() {
        program_.kill();
        program_.waitForFinished(-1);
    }
    /// Until it is told to go on.
    void hold() { ::kill(static_cast<pid_t>(program_.processId()), SIGSTOP); }
    void go_on() { ::kill(static_cast<pid_t>(program_.processId()), SIGCONT); }
    /// Tells it to end, and waits for it; its exit status.
    int end() {
        program_.closeWriteChannel();
        return ended();
    }
    /// The same of one that ends by itself.
    int ended() {
        program_.waitForFinished(-1);
        return program_.exitCode();
    }
    QString said() { return QString::fromUtf8(program_.readAllStandardError()); }

private:
    QProcess program_;
};

} // namespace tp::vm
