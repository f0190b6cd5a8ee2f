// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include <cstdint>
#include <functional>
#include <memory>

namespace tp {

/// Looks again and again, on a connector's thread, for what is plugged in: while it watches, when something tells of a change, and
/// every so often. Belongs to the page's thread.
class PlugLook final : public QObject {
    Q_OBJECT
public:
    /// Done on the connector's thread, where it may wait; what it returns is done on the page's thread, and not at all where nobody
    /// watches any more.
    using Look = std::function<std::function<void()>()>;
    /// Calls on any thread when something was plugged in or out, for as long as what it returns lives.
    using OnPlug = std::function<std::shared_ptr<void>(std::function<void()> changed)>;

    /// An empty `look`: there is nothing to look for. The pool, of one thread, must outlive it. Empty `on_plug`: nothing tells.
    PlugLook(QThreadPool& pool, Look look, int every_ms, OnPlug on_plug);

    void watch(bool on);
    /// It watches, and has looked since it began to.
    bool knows() const { return knows_; }

private:
    void look();
    void look_since_something_changed();

    QThreadPool& pool_;
    Look look_;
    OnPlug on_plug_;
    QTimer timer_;
    QTimer once_more_; ///< what was plugged in is not all there at once
    bool looking_ = false;
    bool look_again_ = false; ///< something changed during a look
    bool knows_ = false;
    std::uint64_t watched_ = 0;   ///< number of the watch; what an older one saw is not told
    std::shared_ptr<void> plugs_; ///< while it watches; last: it calls from a thread of its own
};

} // namespace tp
