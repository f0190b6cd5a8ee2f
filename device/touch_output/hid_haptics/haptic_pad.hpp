// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/touch/touch_output.hpp"
#include "device/latest_writer.hpp"
#include "device/touch_output/hid_haptics/haptics_transport.hpp"
#include "device/touch_output/writer_watch.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace tp {

/// A touch pad, or another device, that takes ticks by the haptics page of HID. Nothing of it is known in advance but what its
/// report descriptor says. Of several fingers the one that came first counts.
///
/// Reading never waits, and sending is a LatestWriter's. Only waveforms that end by themselves are played, once each.
class HapticPad final : public TouchOutput {
public:
    using Opener = std::function<Result<std::unique_ptr<HapticsTransport>>()>;
    static constexpr double delay_s = 0.015; ///< from a tick that is told to one that is felt; an estimate
    struct Identity {
        std::string product;
        std::string serial_number;
    };

    HapticPad(Opener opener, Identity identity, LatestWriter::Thread thread = LatestWriter::Thread::own);
    ~HapticPad() override;
    HapticPad(const HapticPad&) = delete;
    HapticPad& operator=(const HapticPad&) = delete;

    Result<TouchCapabilities> open() override;
    std::optional<PadTouch> read(double now) noexcept override;
    /// It has only ticks.
    bool resist(double) noexcept override { return open_ && !lost(); }
    bool tick(const Tick& tick) noexcept override;
    void halt() noexcept override;
    /// Waits a second at most for a writer that hangs in the system.
    void stop() noexcept override;
    bool lost() const noexcept override { return writer_ && writer_->lost(); }
    std::string complaint() const override;

    /// The writer's step, for LatestWriter::Thread::caller.
    void deliver() noexcept;

private:
    /// What the writer shares with the rest.
    struct Line final : LatestWriter::Sink {
        std::unique_ptr<HapticsTransport> transport;
        haptics::Layout layout;
        std::atomic<bool> refuses{false};
        std::atomic<std::uint32_t> sent{0}; ///< messages
        std::uint8_t posted = 0;            ///< number of the last tick; only the caller
        std::uint8_t played = 0;            ///< number of the last tick; only the writer

        bool send(std::uint64_t message) noexcept override;
    };
    void take(const haptics::Fingers& fingers, double now) noexcept;

    Opener opener_;
    Identity identity_;
    LatestWriter::Thread thread_;
    std::shared_ptr<Line> line_;
    std::unique_ptr<LatestWriter> writer_; ///< stays until the next open, for halt() from anywhere
    haptics::Ordinals ordinals_;
    bool open_ = false;
    std::atomic<bool> unplugged_{false};
    std::atomic<bool> refuses_{false};
    WriterWatch watch_;

    // Only the caller's thread.
    PadTouch touch_;
    std::optional<std::int64_t> contact_; ///< of the finger that counts
};

} // namespace tp
