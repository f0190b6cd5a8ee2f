// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"
#include "device/hid_pid/pid_layout.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

/// The reports that pass between a computer and a stick of one layout, as bytes and back.
namespace tp::hid {

/// As the system takes it: the report id leads, 0 where the device does not number its reports.
struct Report {
    std::array<std::uint8_t, 1 + most_report_bytes> bytes{};
    std::size_t size = 0;

    std::span<const std::uint8_t> all() const { return std::span(bytes).first(size); }
};

/// The direction that an effect pulls along.
enum class Along : std::uint8_t { x, y };

/// The whole of a stick's force is `full_share`; the other way round, its negative.
inline constexpr int full_share = 32767;

Report create_report(const PidLayout& layout);
/// Empty, but for the id: what a feature report is asked for with.
Report asking_for(const ReportShape& shape);
/// For ever, with all of the force: an effect of angle 90° or 0° where the device turns its effects, of one
/// axis elsewhere.
Report effect_report(const PidLayout& layout, std::uint8_t block, Along along);
/// Rounded towards zero, so that it never grows.
Report force_report(const PidLayout& layout, std::uint8_t block, int share);
Report start_report(const PidLayout& layout, std::uint8_t block);
Report stop_report(const PidLayout& layout, std::uint8_t block);
Report free_report(const PidLayout& layout, std::uint8_t block);
/// One of the layout's control choices.
Report control_report(const PidLayout& layout, const Choice& what);
Report full_gain_report(const PidLayout& layout);

struct LoadedBlock {
    enum class Status : std::uint8_t { success, full, refused } status = Status::refused;
    std::uint8_t block = 0; ///< where it succeeded; 1 … 255
};
/// Of a feature report as the system gives it: its id leads, 0 where reports are not numbered.
LoadedBlock loaded_block(const PidLayout& layout, std::span<const std::uint8_t> report);

/// What an input report tells.
struct JoystickNews {
    std::optional<Vec2> axes; ///< −1 … 1 each, x to the right, y towards the person
    std::uint32_t buttons = 0;
    std::optional<bool> motors_on; ///< by all that the device tells of itself
    bool safety_switch_off = false;
};
/// Of an input report as the system gives it: its id leads only where reports are numbered. Nothing, where it
/// is another, or too short for what it should hold.
JoystickNews joystick_news(const PidLayout& layout, std::span<const std::uint8_t> report);

} // namespace tp::hid
