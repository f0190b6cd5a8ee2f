// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/guard/simulated_guard.hpp"
#include "device/hid_pid/model_joystick.hpp"
#include "device/hid_pid/pid_transport.hpp"
#include "device/simulated/report_cable.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace tp {

struct JoystickLinkTroubles : CableTroubles {
    bool no_guard = false;
    bool no_input_now = false; ///< it does not tell how it is when it is asked
    int block_load_late = 0;   ///< answers that fail before one that does not
};

/// A cable to a model stick, in simulated time. The stick must outlive it.
class SimulatedJoystickLink final : public PidTransport {
public:
    /// `delay_ms` is how many milliseconds a report takes each way.
    explicit SimulatedJoystickLink(ModelJoystick& stick, unsigned delay_ms = 0, std::uint32_t seed = 1)
        : joystick_(stick), cable_(delay_ms, seed) {}

    /// A millisecond of the stick.
    void advance();
    /// Milliseconds since the stick was last reached by a force, or for which one of its effects has lacked
    /// one that did not reach it.
    unsigned silent_ms() const;

    std::vector<std::uint8_t> descriptor() override;
    /// A wait passes in simulated time too.
    Got read(hid::Report& report, int wait_ms) noexcept override;
    Got input_now(hid::Report& report) noexcept override;
    bool write(const hid::Report& report) noexcept override;
    void write_from_signal(const hid::Report& report) noexcept override { write(report); }
    bool set_feature(const hid::Report& report) noexcept override;
    bool get_feature(hid::Report& report) noexcept override;
    Result<std::unique_ptr<ForceGuard>> guard(std::span<const hid::Report> no_force,
                                              std::span<const hid::Report> at_the_end) override;

    JoystickLinkTroubles troubles;
    GuardDiary diary;                          ///< of its guard
    std::vector<hid::Report> guard_takes_away; ///< what its guard would write
    std::vector<hid::Report> guard_leaves;     ///< and then, were the program gone

private:
    bool is_force(std::span<const std::uint8_t> report) const;

    ModelJoystick& joystick_;
    ReportCable cable_;
    unsigned silent_ms_ = 0;               ///< since any effect's force arrived
    std::array<unsigned, 256> lacks_ms_{}; ///< of each effect, one that was lost; 0: none
};

} // namespace tp
