// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/force_device.hpp"
#include "device/force_pad/report_transport.hpp"
#include "device/latest_writer.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace tp {

/// A force pad (PROTOCOL.md) behind the port of the servo.
///
/// Reading never waits: what has arrived is drained and the newest state kept, with the pad's own clock for a
/// stamp. Writing hands the force to a LatestWriter.
class ForcePad final : public ForceDevice {
public:
    using Opener = std::function<Result<std::unique_ptr<ReportTransport>>()>;

    explicit ForcePad(Opener opener, LatestWriter::Thread thread = LatestWriter::Thread::own);
    ~ForcePad() override;
    ForcePad(const ForcePad&) = delete;
    ForcePad& operator=(const ForcePad&) = delete;

    /// Asks the pad who it is and what it can do; an error where it does not answer like a force pad.
    Result<Capabilities> open() override;
    std::optional<DeviceState> read(double now) noexcept override;
    bool write(const SafeForce& force) noexcept override;
    void halt() noexcept override;
    /// Waits a second at most for a writer that hangs in the system; it is then left to end by itself.
    void stop() noexcept override;
    bool lost() const noexcept override;
    bool motors_off() const noexcept override;

    Result<bool> home() override;
    /// The writer's step, for LatestWriter::Thread::caller.
    void deliver() noexcept;
    std::string complaint() const override;
    /// Frames since open that were broken, repeated or older than one before. Any thread.
    std::uint64_t bad_frames() const noexcept { return bad_frames_.load(std::memory_order_relaxed); }

private:
    /// What the writer shares with the rest.
    struct Line final : LatestWriter::Sink {
        std::unique_ptr<ReportTransport> transport;
        std::uint16_t sequence = 0;

        bool send(std::uint64_t message) noexcept override;
    };
    void take(const pad::Frame& frame) noexcept;
    bool counts(std::uint16_t sequence) noexcept;
    template <typename Answer>
    bool ask(const pad::Frame& question, Answer& answer);

    Opener opener_;
    LatestWriter::Thread thread_;
    std::shared_ptr<Line> line_;
    std::unique_ptr<LatestWriter> writer_; ///< stays until the next open, for halt() from anywhere
    bool open_ = false;
    std::atomic<std::uint16_t> status_{0};
    std::atomic<std::uint64_t> bad_frames_{0};

    // Only the servo's thread.
    bool heard_ = false; ///< a state since open
    bool fresh_ = false; ///< a state in this read
    unsigned older_ = 0; ///< states in a row that were older, and each newer than the one before it
    std::uint16_t older_sequence_ = 0; ///< of the last of them
    std::uint16_t sequence_ = 0;
    std::uint32_t clock_us_ = 0; ///< the pad's, as it said last
    std::int64_t time_us_ = 0;   ///< the same without its wraps
    DeviceState state_;
};

} // namespace tp
