// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QThreadPool>

#include <functional>
#include <stop_token>

namespace tp {

/// Long work beside a page, on a thread of its own, of which only the newest wish is answered. Belongs to the
/// thread that made it, which needs an event loop.
class LatestTask final : public QObject {
public:
    /// What is then done on the owner's thread.
    using Answer = std::function<void()>;
    /// What it throws ends it without an answer.
    using Work = std::function<Answer(const std::stop_token&)>;

    LatestTask();
    /// Waits for work that is under way.
    ~LatestTask() override;

    /// Does `work` as soon as what is under way has ended. Older wishes are told to stop, or not begun, and
    /// are not answered any more.
    void ask(Work work);
    /// Nothing is wanted any more.
    void cancel();
    /// An answer is still to come.
    bool busy() const { return busy_; }

private:
    quint64 newest_ = 0; ///< number of the newest wish
    bool busy_ = false;
    std::stop_source stop_; ///< of the newest wish
    QThreadPool pool_;      ///< last: it ends before what its work is for
};

} // namespace tp
