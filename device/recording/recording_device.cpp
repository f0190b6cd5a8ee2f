// SPDX-License-Identifier: Apache-2.0
#include "device/recording/recording_device.hpp"

#include <cmath>
#include <system_error>
#include <utility>

namespace tp {

RecordingDevice::RecordingDevice(ForceDevice& device, std::filesystem::path file)
    : device_(device), path_(std::move(file)) {}

RecordingDevice::~RecordingDevice() { flush(); }

Result<Capabilities> RecordingDevice::open() {
    std::error_code unused;
    if (std::filesystem::exists(path_, unused))
        return Error{"There is a file " + path_.string() +
                     " already. Choose another name for the recording."};
    Result<Capabilities> can = device_.open();
    if (!can.ok())
        return can;
    file_.open(path_, std::ios::binary | std::ios::app);
    const std::string header = recording_header(can.value());
    file_.write(header.data(), static_cast<std::streamsize>(header.size()));
    file_.flush();
    if (!file_) {
        device_.stop();
        return Error{"The recording " + path_.string() +
                     " could not be written. Choose a folder that you may write to."};
    }
    return can;
}

std::optional<DeviceState> RecordingDevice::read(double now) noexcept {
    const std::optional<DeviceState> reading = device_.read(now);
    servo_.store(std::this_thread::get_id(), std::memory_order_relaxed);
    ticking_ = true;
    tick_ = {};
    tick_.now = now;
    tick_.fresh = reading && std::isfinite(reading->time); // without a stamp it is none to the servo either
    if (tick_.fresh)
        tick_.reading = *reading;
    return reading;
}

bool RecordingDevice::write(const SafeForce& force) noexcept {
    if (servo_.load(std::memory_order_relaxed) != std::this_thread::get_id() || !ticking_)
        return device_.write(force);
    ticking_ = false;
    tick_.lost = device_.lost();
    tick_.motors_off = device_.motors_off();
    const bool taken = device_.write(force);
    tick_.refused = !taken;
    tick_.force = force.newtons();
    const std::uint64_t number = made_.load(std::memory_order_relaxed);
    if (number - written_.load(std::memory_order_acquire) >= ring_size) {
        overrun_.store(true, std::memory_order_relaxed);
        return taken;
    }
    if (!overrun_.load(std::memory_order_relaxed)) {
        ring_[number % ring_size] = tick_;
        made_.store(number + 1, std::memory_order_release);
    }
    return taken;
}

bool RecordingDevice::flush() {
    if (!file_.is_open())
        return false;
    const std::uint64_t until = made_.load(std::memory_order_acquire);
    for (std::uint64_t i = written_.load(std::memory_order_relaxed); i < until; ++i) {
        const auto bytes = recorded_bytes(ring_[i % ring_size], static_cast<std::uint32_t>(i));
        file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        written_.store(i + 1, std::memory_order_release);
    }
    file_.flush();
    return file_.good() && !overrun_.load(std::memory_order_relaxed);
}

} // namespace tp
