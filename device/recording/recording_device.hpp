// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/force_device.hpp"
#include "device/recording/touch_recording.hpp"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <thread>

namespace tp {

/// A device that passes everything on to another and writes down what passed (FORMAT.md), a tick at each
/// write. The servo's thread puts ticks into a ring and waits for nothing; another thread, or the same in
/// simulated time, calls flush() at least every few seconds.
class RecordingDevice final : public ForceDevice {
public:
    /// The device must outlive it. `file` is made new; an existing one is refused by open().
    RecordingDevice(ForceDevice& device, std::filesystem::path file);
    ~RecordingDevice() override;
    RecordingDevice(const RecordingDevice&) = delete;
    RecordingDevice& operator=(const RecordingDevice&) = delete;

    Result<Capabilities> open() override;
    std::optional<DeviceState> read(double now) noexcept override;
    bool write(const SafeForce& force) noexcept override;
    void halt() noexcept override { device_.halt(); }
    void stop() noexcept override { device_.stop(); }
    bool lost() const noexcept override { return device_.lost(); }
    bool motors_off() const noexcept override { return device_.motors_off(); }

    /// Appends what the ring holds to the file. One thread at a time, never the servo's own while it ticks in
    /// real time. False where the file could not be written, or ticks were lost because this came too late:
    /// the recording then ends before them.
    bool flush();

private:
    static constexpr std::size_t ring_size = 16384; ///< ticks: 16 s at 1 kHz

    ForceDevice& device_;
    std::filesystem::path path_;
    std::ofstream file_;
    std::array<RecordedTick, ring_size> ring_{};
    std::atomic<std::uint64_t> made_{0};    ///< ticks; only the servo's thread adds
    std::atomic<std::uint64_t> written_{0}; ///< only flush() adds
    std::atomic<bool> overrun_{false};
    /// Whose reads and writes are the ticks: what the watchdog writes from its own thread is passed on only.
    std::atomic<std::thread::id> servo_{};
    RecordedTick tick_;    ///< only the servo's thread
    bool ticking_ = false; ///< a read came, its write not yet; only the servo's thread
};

} // namespace tp
