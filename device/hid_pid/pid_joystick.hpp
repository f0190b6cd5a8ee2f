// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/force_device.hpp"
#include "device/guard/guarded_pull.hpp"
#include "device/hid_pid/joystick_scale.hpp"
#include "device/hid_pid/pid_transport.hpp"
#include "device/hid_pid/report_stamps.hpp"
#include "device/latest_writer.hpp"

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// A two-axis force-feedback stick of the Physical Interface Device class behind the port of the servo.
///
/// Two constant effects play for as long as it is open, one along each axis, and only their magnitudes are
/// sent. They are started anew every 30 s of the servo's time, because many devices end an "infinite" effect
/// after 65.5 s (16 bits of milliseconds).
///
/// Silence of a stick that reports only changes counts as standing still for as long as the stick takes what is
/// sent to it (ReportStamps).
///
/// It has no watchdog: what was sent last pulls until something else is sent. So a guard stands beside it,
/// without which it is not opened; where that has stepped in the stick pulls again only after it was given no
/// force.
class PidJoystick final : public ForceDevice {
public:
    using Opener = std::function<Result<std::unique_ptr<PidTransport>>()>;
    /// As the bus shows it.
    struct Identity {
        std::string product;
        std::string serial_number;
    };

    /// mm from the middle to either end of an axis, at the grip: 20° of a lever of 0.17 m, as of sticks on a
    /// desk.
    static constexpr double lever_mm = 60.0;
    static constexpr double most_newtons = 20.0; ///< of a measured stick
    static constexpr double most_newtons_unmeasured = 2.0;

    PidJoystick(Opener opener, Identity identity, const JoystickScale& scale = {},
                LatestWriter::Thread thread = LatestWriter::Thread::own);
    ~PidJoystick() override;
    PidJoystick(const PidJoystick&) = delete;
    PidJoystick& operator=(const PidJoystick&) = delete;

    /// Puts the effects on the device and starts them; the error says what keeps it from being used.
    Result<Capabilities> open() override;
    std::optional<DeviceState> read(double now) noexcept override;
    bool write(const SafeForce& force) noexcept override;
    bool assume(double newtons_at_full, Vec2 sign) noexcept override;
    void halt() noexcept override;
    /// Waits a second at most for a writer that hangs in the system; it is then left to end by itself.
    void stop() noexcept override;
    bool lost() const noexcept override;
    bool motors_off() const noexcept override;
    std::string complaint() const override;

    /// Sends what the mailbox holds, if anything is new in it; for LatestWriter::Thread::caller.
    void deliver() noexcept;

private:
    enum class Trouble : std::uint8_t { none, actuators_off, safety_switch, takes_nothing, unguarded };

    /// A message to the writer: the share of each axis, and how often each effect was to be started anew and
    /// the actuators to be enabled, of which only a change counts.
    struct JoystickMessage {
        std::array<int, 2> share{};
        std::array<unsigned, 2> starts{};
        unsigned enables = 0;

        bool pulls() const { return share != std::array<int, 2>{}; }
        std::uint64_t word() const;
        static JoystickMessage of(std::uint64_t word);
    };

    /// What the writer shares with the rest; it outlives the stick where the writer hangs.
    struct Line final : LatestWriter::Sink {
        std::unique_ptr<PidTransport> transport;
        hid::PidLayout layout;
        std::array<std::uint8_t, 2> block{}; ///< of the effect along x and along y; 0: none
        std::atomic<std::uint32_t> taken{0}; ///< counts the messages that the device took
        std::optional<GuardedPull> pull;     ///< once it is guarded

        // Only the writer.
        std::array<int, 2> share{};
        std::array<unsigned, 2> starts{};
        unsigned enables = 0;
        std::array<unsigned, 2> untold{}; ///< messages since each effect was told its force

        bool send(std::uint64_t message) noexcept override;
        bool write(const JoystickMessage& message) noexcept;
    };

    /// Empty where it could be done.
    std::string put_effects_on_it();
    /// What leaves the stick as it was, behind no force.
    std::vector<hid::Report> effects_away() const;
    void take_effects_away() noexcept;
    /// Empty where a guard watches from now on.
    std::string begin_to_guard();
    enum class Loading : std::uint8_t { done, full, refused };
    Loading load_effect(hid::Along along);
    bool control(const hid::Choice& what);
    /// True where it says where the grip is.
    bool take(const hid::Report& report) noexcept;
    /// False where older reports may still wait in the system.
    bool take_reports() noexcept;
    void post(Vec2 share) noexcept;
    void keep_the_effects_alive(bool given_no_force) noexcept;
    void watch_the_writer() noexcept;

    Opener opener_;
    Identity identity_;
    JoystickScale scale_;                                 ///< as it was made
    std::array<std::atomic<double>, 2> share_per_newton_; ///< of each axis, signed
    LatestWriter::Thread thread_;
    std::shared_ptr<Line> line_;
    std::unique_ptr<LatestWriter> writer_; ///< stays until the next open, for halt() from anywhere
    std::array<hid::Report, 2> no_force_;  ///< of each effect
    std::atomic<PidTransport*> halting_{nullptr};
    bool open_ = false;
    std::atomic<Trouble> trouble_{Trouble::none};

    // Only the servo's thread.
    double now_ = 0.0;
    bool ticked_ = false;
    bool heard_ = false; ///< where it is, since open
    ReportStamps stamps_;
    bool motors_on_ = true;
    bool safety_switch_off_ = false;
    bool stuck_ = false; ///< the writer
    bool off_ =
        false; ///< one of these or the guard's doing, and since then it was given some force all the time
    std::uint32_t taken_ = 0;
    double taken_at_ = 0.0;
    std::array<double, 2> started_at_{};
    std::array<unsigned, 2> starts_{};
    double enabled_at_ = 0.0;
    unsigned enables_ = 0;
    DeviceState state_;
};

} // namespace tp
