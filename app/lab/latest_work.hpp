// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QThreadPool>

#include <atomic>
#include <functional>
#include <stop_token>

namespace tp {

/// Work on a thread of its own, of which only the newest wish is answered. Belongs to the thread that made it, which
/// needs an event loop.
class LatestWork final : public QObject {
public:
    /// What is then done on the owner's thread.
    using Done = std::function<void()>;
    using Work = std::function<Done(const std::stop_token&)>;

    LatestWork();
    /// Waits for work that is under way.
    ~LatestWork() override;

    /// Does `work` as soon as what is under way has ended; older wishes are not answered any more.
    void ask(Work work);
    /// Nothing is wanted any more.
    void cancel();
    /// An answer is still to come.
    bool busy() const { return busy_; }

private:
    std::atomic<quint64> newest_{0};
    bool busy_ = false;
    std::stop_source stop_; ///< of the newest wish
    QThreadPool pool_;      ///< last: it ends before what its work is for
};

} // namespace tp
