// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QThread>

#include <atomic>
#include <functional>
#include <stop_token>

namespace tp {

/// Long work on a thread of its own, of which only the newest is wanted. Belongs to the thread that made it,
/// which needs an event loop.
class NewestTask final : public QObject {
    Q_OBJECT
public:
    /// On its own thread; returns what is then done on the owner's. What it throws ends it without an answer.
    using Work = std::function<std::function<void()>(const std::stop_token&)>;

    explicit NewestTask(const QString& thread_name);
    ~NewestTask() override;

    /// Work asked for before is stopped, or not begun, and not answered.
    void start(Work work);
    void cancel();
    bool busy() const { return busy_; }

private:
    QThread thread_;
    QObject* worker_; ///< the place on thread_ where work is done; thread_ deletes it
    std::atomic<quint64> newest_{0};
    std::stop_source stop_;
    bool busy_ = false;
};

} // namespace tp
