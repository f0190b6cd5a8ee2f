// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/force_device.hpp"
#include "device/guard/force_guard.hpp"
#include "device/haply_2diy/homed_note.hpp"
#include "device/haply_2diy/pantograph.hpp"
#include "device/haply_2diy/serial_line.hpp"
#include "device/latest_writer.hpp"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace tp {

/// A Haply 2diy behind the port of the servo.
///
/// Each tick reads what has come without waiting and hands the next command to a writer; at most two commands
/// are on their way, so that none gets old in a line that stalls. A board that answers nothing believable for
/// 20 ms is taken to be out of step: it is set up anew, pulls nothing, and wants to be homed, because its
/// encoders only count.
class Haply2diy final : public ForceDevice {
public:
    struct Board {
        std::unique_ptr<SerialLine> line;
        std::unique_ptr<ForceGuard> guard;
        HomedNote note;
        std::string serial_number;
    };
    using Opener = std::function<Result<Board>()>;

    Haply2diy(HaplyGeneration generation, Opener opener,
              LatestWriter::Thread thread = LatestWriter::Thread::own);
    ~Haply2diy() override;
    Haply2diy(const Haply2diy&) = delete;
    Haply2diy& operator=(const Haply2diy&) = delete;

    /// A board that was homed and still answers goes on counting; any other is set up as if its arms stood in
    /// the reference pose, and pulls nothing before home(). An error where nothing answers like a board.
    Result<Capabilities> open() override;
    std::optional<DeviceState> read(double now) noexcept override;
    bool write(const SafeForce& force) noexcept override;
    void halt() noexcept override;
    void stop() noexcept override;
    bool lost() const noexcept override;
    bool motors_off() const noexcept override;
    /// The arms stand in the reference pose.
    Result<bool> home() override;
    std::string complaint() const override;

    /// Sends what the mailbox holds, if anything is new in it; for simulated time.
    void deliver() noexcept;
    /// Times since open that bytes came which are no answer, or none came in time. Any thread.
    std::uint64_t bad_answers() const noexcept { return bad_answers_.load(std::memory_order_relaxed); }

private:
    /// What the writer uses; it outlives the device where the writer hangs.
    struct Wire final : LatestWriter::Sink {
        Wire(const Pantograph& pantograph, std::shared_ptr<std::atomic<bool>> flag)
            : arms(pantograph), unguarded(std::move(flag)) {}
        bool send(std::uint64_t message) noexcept override;
        /// A sign of life to the guard, which does not let a board go on where it had to step in.
        bool beat(bool pulls) noexcept;

        Pantograph arms;
        Board board;
        std::atomic<std::uint64_t> angles{0};   ///< of the last answer, packed
        std::atomic<std::uint64_t> commands{0}; ///< sent
        std::shared_ptr<std::atomic<bool>> unguarded;
    };
    std::optional<haply::Reply> asked(std::span<const std::uint8_t> question, int wait_ms);
    bool set_up_in_reference_pose();
    void take_bytes(double now) noexcept;
    void take_answers(double now) noexcept;
    bool believable(const haply::Reply& reply, double now) const noexcept;
    void believe(const haply::Reply& reply, double now) noexcept;
    void keep_in_step(double now) noexcept;
    void bring_back(double now) noexcept;

    Pantograph arms_;
    Opener opener_;
    LatestWriter::Thread thread_;
    std::shared_ptr<Wire> wire_; ///< stays until the next open, for halt() from anywhere
    std::unique_ptr<LatestWriter> writer_;
    const std::shared_ptr<std::atomic<bool>> unguarded_ = std::make_shared<std::atomic<bool>>(false);
    std::atomic<bool> open_{false};
    std::atomic<bool> homed_{false};
    std::atomic<bool> out_of_step_{false};
    std::atomic<bool> lost_step_{false}; ///< since it was homed last
    std::atomic<bool> pulls_{false};     ///< as written last
    std::atomic<std::uint64_t> answers_{0};
    std::atomic<std::uint64_t> bad_answers_{0};

    // Only the servo's thread.
    std::array<std::uint8_t, 256> heard_{};
    std::size_t heard_size_ = 0;
    bool fresh_ = false;    ///< an answer in this read
    bool skipping_ = false; ///< bytes that are no answer were the last
    std::optional<double> believed_at_;
    haply::Reply believed_;
    std::optional<double> waiting_since_; ///< for the answer to a command that is under way
    std::optional<double> silent_since_;  ///< when a command went out after the last answer
    std::uint64_t commands_believed_ = 0; ///< that had been sent when the last answer came
    unsigned round_ = 0;
    DeviceState state_;
};

} // namespace tp
