// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/usb/usb_devices.hpp"

#include <atomic>
#include <functional>
#include <thread>

namespace tp {

/// Tells when something was plugged in to the USB or out of it, where libusb can tell (libusb_hotplug,
/// libusb 1.0.16); elsewhere it is silent. A device's other faces, such as its HID node, may come some
/// milliseconds later than it.
class PlugWatch {
public:
    /// `changed` is called on a thread of the watch's own, once for what happens together.
    explicit PlugWatch(std::function<void()> changed);
    /// `changed` is not called any more afterwards.
    ~PlugWatch();
    /// What happens from now on is told. Any thread.
    bool listens() const noexcept { return waits_in_.load() != nullptr; }
    PlugWatch(const PlugWatch&) = delete;
    PlugWatch& operator=(const PlugWatch&) = delete;

private:
    void watch();

    std::function<void()> changed_;
    UsbContext context_; ///< made by the thread, since that may take a while; it outlives the thread
    std::atomic<libusb_context*> waits_in_{nullptr};
    std::atomic<bool> ends_{false};
    std::thread thread_;
};

} // namespace tp
