// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include <memory>

namespace tp {

/// While one lives, the first SIGTERM, SIGINT or SIGHUP (a person logs out, the computer is shut down, the terminal is closed) is
/// told as `asked` in the event loop of the thread that made it, so that the program ends in good order; the second one ends it.
/// One at a time in a process. Where a system has no such signals, nothing is ever told.
class EndSignals final : public QObject {
    Q_OBJECT
public:
    EndSignals();
    ~EndSignals() override;

signals:
    void asked();

private:
    struct Heeded;
    std::unique_ptr<Heeded> heeded_;
};

} // namespace tp
