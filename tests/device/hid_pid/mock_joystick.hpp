// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../force_pad/mock_hidraw.hpp"
#include "../mocked_node.hpp"
#include "joystick_bench.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <poll.h>
#include <span>
#include <string>
#include <thread>
#include <umockdev-1.0/umockdev.h>
#include <unistd.h>
#include <vector>

namespace tp::mock {

/// A force stick made by umockdev: its /sys and /dev are those of a HID device, once plugged in; its node is
/// a pseudo-terminal, and behind it a thread runs the model stick.
class JoystickBed {
public:
    explicit JoystickBed(const JoystickWire& wire = plain_controller(),
                         std::span<const std::uint8_t> other_descriptor = {}, const HandlePlant& plant = {})
        : bed_(umockdev_testbed_new()), model_(wire, plant),
          descriptor_(other_descriptor.empty() ? wire.descriptor : other_descriptor) {
        ioctls_ = UMOCKDEV_IOCTL_BASE(g_object_new(umockdev_ioctl_base_get_type(), nullptr));
        g_signal_connect(ioctls_, "handle-ioctl", G_CALLBACK(&JoystickBed::answer_of), this);
        model_.place_grip({10.0, 3.0});
    }
    ~JoystickBed() {
        quit_.store(true);
        if (device_.joinable())
            device_.join();
        if (file_ >= 0)
            ::close(file_);
        g_object_unref(ioctls_);
        g_object_unref(bed_);
    }
    JoystickBed(const JoystickBed&) = delete;
    JoystickBed& operator=(const JoystickBed&) = delete;

    bool plug_in() {
        const HidrawDevice shown{"force stick", "FS-0001", descriptor_, "045e", "001b"};
        const std::string description = usb_description(shown) + hidraw_description(shown);
        file_ = plugged_in(bed_, description, hidraw_node, ioctls_);
        if (file_ < 0)
            return false;
        device_ = std::thread([this] { be_a_joystick(); });
        return true;
    }
    void unplug() { unplug_.store(true); }
    /// Forces from the computer that were taken.
    long taken() const { return taken_.load(); }
    std::size_t effects() {
        const std::lock_guard lock(mutex_);
        return model_.effects();
    }
    Vec2 force() {
        const std::lock_guard lock(mutex_);
        return model_.force();
    }
    bool motors_on() {
        const std::lock_guard lock(mutex_);
        return model_.motors_on();
    }
    /// Reports of commands to the whole device that were taken.
    long commands() const { return commands_.load(); }
    /// Nobody has its node open.
    bool hung_up() const { return hung_up_.load(); }
    std::string root() const {
        char* folder = umockdev_testbed_get_root_dir(bed_);
        std::string copy = folder;
        g_free(folder);
        return copy;
    }

private:
    static gboolean answer_of(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
        return static_cast<JoystickBed*>(self)->answer(client);
    }
    gboolean answer(UMockdevIoctlClient* client) {
        return answer_hid_class(client, [this](gulong request, std::span<std::uint8_t> data) {
            constexpr unsigned set_feature = 0x06;
            constexpr unsigned get_feature = 0x07;
            constexpr unsigned get_input = 0x0A;
            // On a bus a request comes after what was written before it; here they go different ways. The
            // gain is the last that is written, after commands, before an effect is asked for.
            while (_IOC_NR(request) == set_feature && !gain_taken_.load() && !quit_.load())
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            const std::lock_guard lock(mutex_);
            std::vector<std::uint8_t> told;
            if (_IOC_NR(request) == set_feature)
                return model_.set_feature(data) ? static_cast<int>(data.size()) : -1;
            if (_IOC_NR(request) == get_feature && !model_.get_feature(data[0], told))
                return -1;
            if (_IOC_NR(request) == get_input && data[0] == model_.wire().axes)
                told = model_.axes_report();
            if (told.empty())
                return descriptor_answer(request, data, descriptor_);
            std::copy_n(told.begin(), std::min(told.size(), data.size()), data.begin());
            return static_cast<int>(std::min(told.size(), data.size()));
        });
    }
    /// Bytes of an output report with its id; the node is a stream and keeps no borders.
    std::size_t size_of(std::uint8_t id) const {
        const JoystickWire& wire = model_.wire();
        return id == wire.set_effect                               ? 1 + wire.effect_bytes
               : id == wire.constant_force || id == wire.operation ? 4
                                                                   : 2;
    }
    void be_a_joystick() {
        std::vector<std::uint8_t> waiting;
        while (!quit_.load()) {
            if (unplug_.load()) {
                umockdev_testbed_uevent(bed_, hidraw_sys_path, "remove");
                ::close(file_);
                file_ = -1;
                return;
            }
            pollfd ready{file_, POLLIN, 0};
            if (::poll(&ready, 1, 5) <= 0)
                continue;
            std::uint8_t bytes[4096];
            const ssize_t count = ::read(file_, bytes, sizeof bytes);
            hung_up_.store(count <= 0);
            if (count <= 0) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
                continue;
            }
            waiting.insert(waiting.end(), bytes, bytes + count);
            while (!waiting.empty() && waiting.size() >= size_of(waiting[0])) {
                const auto size = static_cast<std::ptrdiff_t>(size_of(waiting[0]));
                take({waiting.begin(), waiting.begin() + size});
                waiting.erase(waiting.begin(), waiting.begin() + size);
            }
        }
    }
    void take(const std::vector<std::uint8_t>& report) {
        std::vector<std::uint8_t> told;
        {
            const std::lock_guard lock(mutex_);
            model_.receive(report);
            model_.step();
            while (model_.report(told)) {
            }
        }
        if (!told.empty() && ::write(file_, told.data(), told.size()) != static_cast<ssize_t>(told.size()))
            return;
        constexpr std::uint8_t gain = 0x0D;
        if (report[0] == gain)
            gain_taken_.store(true);
        if (report[0] == model_.wire().control) {
            gain_taken_.store(false);
            commands_.fetch_add(1);
        }
        if (report[0] == model_.wire().constant_force)
            taken_.fetch_add(1);
    }

    UMockdevTestbed* bed_;
    UMockdevIoctlBase* ioctls_ = nullptr;
    std::thread device_;
    int file_ = -1;
    std::atomic<bool> quit_{false};
    std::atomic<bool> unplug_{false};
    std::atomic<bool> gain_taken_{false};
    std::atomic<long> taken_{0};
    std::atomic<long> commands_{0};
    std::atomic<bool> hung_up_{false};
    std::mutex mutex_; ///< of the model
    ModelJoystick model_;
    std::span<const std::uint8_t> descriptor_;
};

} // namespace tp::mock
