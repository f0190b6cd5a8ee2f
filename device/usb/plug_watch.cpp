// SPDX-License-Identifier: Apache-2.0
#include "device/usb/plug_watch.hpp"

#include <utility>

namespace tp {

namespace {

/// Comes for each device within libusb's handling of events, where little may be done.
int LIBUSB_CALL note_change(libusb_context*, libusb_device*, libusb_hotplug_event, void* changed) {
    *static_cast<bool*>(changed) = true;
    return 0; // go on
}

} // namespace

PlugWatch::PlugWatch(std::function<void()> changed)
    : changed_(std::move(changed)), thread_([this] { watch(); }) {}

PlugWatch::~PlugWatch() {
    ends_.store(true);
    if (libusb_context* const context = waits_in_.load())
        libusb_interrupt_event_handler(context);
    thread_.join();
}

void PlugWatch::watch() {
    context_ = usb_context();
    bool changed = false;
    if (!context_ || libusb_has_capability(LIBUSB_CAP_HAS_HOTPLUG) == 0 ||
        libusb_hotplug_register_callback(
            context_.get(), LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED | LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT, 0,
            LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY, note_change,
            &changed, nullptr) != 0)
        return;
    waits_in_.store(context_.get());
    while (!ends_.load()) {
        if (libusb_handle_events_completed(context_.get(), nullptr) != 0)
            return;
        if (std::exchange(changed, false) && !ends_.load())
            changed_();
    }
}

} // namespace tp
