// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/devices/device_access.hpp"
#include "app/parts/devices/device_drive.hpp"
#include "app/parts/devices/plug_look.hpp"
#include "core/geometry/calibration.hpp"

#include <QObject>
#include <QString>
#include <QThreadPool>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace tp {

/// A device just opened; nothing ticks yet.
struct OpenDevice {
    ListedDevice listed;
    std::unique_ptr<ForceDevice> device;
    Capabilities can;
    std::optional<Calibration> calibration; ///< device frame → screen frame, where it was calibrated once
};

/// Finds, opens and gives back force devices for one page, on a thread of its own and one thing after the other. Belongs
/// to the page's thread.
class DeviceConnector final : public QObject {
    Q_OBJECT
public:
    explicit DeviceConnector(DeviceAccess access);
    /// Waits for what is under way.
    ~DeviceConnector() override;

    /// The real devices that were there at the last look.
    const std::vector<ListedDevice>& there() const { return there_; }
    /// Looks now and again from now on, or no longer.
    void watch(bool on) { plugs_.watch(on); }
    /// It watches, and has looked since it began to.
    bool knows() const { return plugs_.knows(); }
    /// Opens it; `opened` or `refused` follows. One that is being opened already is not wanted any more.
    void open(const ListedDevice& device);
    /// Opens it, homes it (ForceDevice::home) and gives it back; `homed` or `refused` follows.
    void home(const ListedDevice& device);
    /// What is being opened is not wanted any more.
    void cancel();
    bool opening() const { return opening_; }
    /// Ends it without letting the page wait, and before anything is opened again.
    void release(std::unique_ptr<DeviceDrive> drive);

signals:
    /// There was a look, and `there` is new.
    void looked();
    void opened(std::shared_ptr<tp::OpenDevice> device);
    void homed();
    /// A sentence for a person, with what to do.
    void refused(const QString& sentence);

private:
    PlugLook::Look look();
    void begin(const ListedDevice& device, bool homes);

    DeviceAccess access_;
    std::vector<ListedDevice> there_;
    bool opening_ = false;
    std::uint64_t wish_ = 0; ///< number of the newest wish to open
    QThreadPool pool_;       ///< late: its work ends before what it uses
    PlugLook plugs_;         ///< last: it calls from a thread of its own
};

} // namespace tp
