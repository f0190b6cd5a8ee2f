// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/devices/plug_look.hpp"
#include "app/parts/devices/touch_access.hpp"
#include "app/parts/devices/touch_drive.hpp"

#include <QObject>
#include <QString>
#include <QThreadPool>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace tp {

/// An output for a bare finger just opened; nothing ticks yet.
struct OpenTouch {
    ListedTouchOutput listed;
    std::unique_ptr<TouchOutput> output;
    TouchCapabilities can;
};

/// Finds, opens and gives back outputs for a bare finger for one page, as DeviceConnector does force devices.
class TouchConnector final : public QObject {
    Q_OBJECT
public:
    explicit TouchConnector(TouchAccess access);
    /// Waits for what is under way.
    ~TouchConnector() override;

    /// Those that were there at the last look.
    const std::vector<ListedTouchOutput>& there() const { return there_; }
    /// Looks now and again from now on, or no longer.
    void watch(bool on) { plugs_.watch(on); }
    /// It watches, and has looked since it began to.
    bool knows() const { return plugs_.knows(); }
    /// Opens it, once pages before have let go of theirs; `opened` or `refused` follows. One that is being opened already is not wanted any more.
    void open(const ListedTouchOutput& output);
    /// What is being opened is not wanted any more.
    void cancel();
    bool opening() const { return opening_; }
    /// Ends it without letting the page wait, and before anything is opened again.
    void release(std::unique_ptr<TouchDrive> drive);
    /// The same of one that nothing drives.
    void release(std::unique_ptr<TouchOutput> output);

signals:
    /// There was a look, and `there` is new.
    void looked();
    void opened(std::shared_ptr<tp::OpenTouch> output);
    /// A sentence for a person, with what to do.
    void refused(const QString& sentence);

private:
    PlugLook::Look look();
    void give_back(std::function<void()> let_go);

    TouchAccess access_;
    std::vector<ListedTouchOutput> there_;
    bool opening_ = false;
    std::uint64_t wish_ = 0; ///< number of the newest wish to open
    QThreadPool pool_;       ///< late: its work ends before what it uses
    PlugLook plugs_;         ///< last: it calls from a thread of its own
};

} // namespace tp
