// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/force_device.hpp"
#include "device/falcon/falcon_frame.hpp"
#include "device/falcon/falcon_link.hpp"
#include "device/falcon/plane_force.hpp"
#include "device/falcon/stamper.hpp"
#include "device/guard/guarded_pull.hpp"
#include "device/latest_writer.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// A Novint Falcon behind the port of the servo. A face is felt in the upright plane before the person: the
/// port's x and y are the Falcon's, its z is kept by a Pane, whose force is let in and out with the safety
/// chain's (SafeForce::share).
///
/// Each write sends one command and each command brings one reply, which a later read finds without waiting.
/// The Falcon itself knows no safe state that anybody has described: it may keep its last command when the
/// computer falls silent. So a guard stands beside it, without which it is not opened; and its motors are off
/// here, whatever is asked, until all arms are homed and the servo has sent no force once since, and since
/// the guard has stepped in; and where no place came for `most_unanswered` writes.
class Falcon final : public ForceDevice {
public:
    using Opener = std::function<Result<std::unique_ptr<FalconLink>>()>;
    /// The firmware to load where none runs; empty where the person has given none.
    using Firmware = std::function<Result<std::vector<std::uint8_t>>()>;

    Falcon(Opener opener, Firmware firmware, std::string serial_number,
           LatestWriter::Thread thread = LatestWriter::Thread::own);
    ~Falcon() override;
    Falcon(const Falcon&) = delete;
    Falcon& operator=(const Falcon&) = delete;

    /// Loads its firmware where it does not run, which takes seconds. Its newtons are not calibrated.
    Result<Capabilities> open() override;
    std::optional<DeviceState> read(double now) noexcept override;
    bool write(const SafeForce& force) noexcept override;
    void halt() noexcept override;
    /// Waits a second at most for a writer that hangs in the system; it is then left to end by itself.
    void stop() noexcept override;
    bool lost() const noexcept override;
    bool motors_off() const noexcept override;
    /// Waits for a person to pull the grip out and push it in, for at most `homing_exchanges`; its light is
    /// blue.
    Result<bool> home() override;
    std::string complaint() const override;

    /// Sends what was written last, if anything is new; for LatestWriter::Thread::caller.
    void deliver() noexcept;
    /// Bytes that were no packet and places that no Falcon can be at, since open. Any thread.
    std::uint64_t bad_readings() const noexcept { return bad_readings_.load(std::memory_order_relaxed); }

    static constexpr int homing_exchanges = 20000; ///< some 20 s or more
    /// A place farther from the one before, for each write since, is none: no hand is as quick, and a reply
    /// has no checksum. Where that many come one after the other, the grip is there.
    static constexpr double quickest = 0.003; ///< m
    static constexpr int leaps_of_a_new_place = 8;
    static constexpr int most_unanswered = 50; ///< the chain has let go long before
    static constexpr double max_force = 2.0; ///< N in the plane; with the pane 2.5 N of some 9 N that it has

private:
    /// What the writer shares with the rest; it outlives the Falcon where the writer hangs.
    struct Line final : LatestWriter::Sink {
        std::unique_ptr<FalconLink> link;
        std::optional<GuardedPull> pull; ///< once it is guarded
        bool send(std::uint64_t message) noexcept override;
    };
    std::string start();
    /// Empty where a guard watches from now on.
    std::string begin_to_guard();
    std::optional<falcon::Reply> exchange(const falcon::Command& command);
    void take(const UsbPacket& packet) noexcept;
    bool locate(const falcon::Reply& reply, double now) noexcept;
    bool take_place(const falcon::Reply& reply, double now) noexcept;
    bool homed() const noexcept { return homed_.load(std::memory_order_relaxed); }

    Opener opener_;
    Firmware firmware_;
    std::string serial_number_;
    LatestWriter::Thread thread_;
    std::shared_ptr<Line> line_;           ///< stays until the next open
    std::unique_ptr<LatestWriter> writer_; ///< stays until the next open, for halt() from anywhere
    bool open_ = false;
    std::atomic<bool> homed_{false};
    std::atomic<bool> unguarded_{false};
    std::atomic<std::uint64_t> bad_readings_{0};

    /// What has been heard and sent since it was opened. Only the servo's thread.
    struct Touch {
        falcon::PacketStream stream;
        std::optional<falcon::Reply> reply; ///< the newest of this read
        falcon::Place place = falcon::middle;
        std::optional<glm::dmat3> jacobian; ///< where the place is known
        falcon::Pane pane;
        bool armed = false;
        int unanswered = 0; ///< writes since the last place
        int leaps = 0;      ///< places in a row that were too far
        DeviceState state;
    };
    Touch touch_;
};

} // namespace tp
