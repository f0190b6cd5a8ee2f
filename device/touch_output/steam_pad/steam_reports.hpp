// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"
#include "core/touch/tick.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

/// The reports of Valve's controllers with two touch pads, as bytes and back. Facts, not measured by us, from Linux
/// drivers/hid/hid-steam.c (6.18) and SDL 2.30 src/joystick/hidapi/SDL_hidapi_steam.c and SDL_hidapi_steamdeck.c.
namespace tp::steam {

inline constexpr std::uint16_t vendor = 0x28DE;

enum class Kind : std::uint8_t {
    deck,       ///< the controller built into a Steam Deck
    controller, ///< a Steam Controller of 2015 on its cable
    receiver    ///< what such a controller is joined to by radio
};
/// What has a product id of Valve's; nothing for another one.
std::optional<Kind> kind_of(std::uint16_t product);

enum class Side : std::uint8_t { left, right };

inline constexpr std::size_t input_bytes = 64;
/// A feature report as hidapi takes it: the report's number, 0, leads. Shorter ones are not taken by the device.
using Feature = std::array<std::uint8_t, 65>;

/// A pad is 40 mm wide and round on the 2015 controller (hid-steam.c: 1638 units to the millimetre), and 32.5 mm and square on a
/// Steam Deck (Valve's technical specifications).
double pad_width_mm(Kind kind);

struct Pad {
    bool touched = false;
    bool pressed = false;
    /// mm, x right, y up as the controller is held, origin in the middle; nothing where this report does not tell.
    std::optional<Vec2> place;
};

/// What one input report tells.
struct News {
    bool pads_told = false;
    std::array<Pad, 2> pads;       ///< by Side
    std::optional<bool> connected; ///< of a controller on the radio
};
/// Of any bytes; nothing is told by those that are no report of such a device.
News news_of(std::span<const std::uint8_t> report);

/// `count` times `on_us` of push and `off_us` of none: over after at most Tick::longest_s.
struct Pulses {
    std::uint16_t on_us = 0;
    std::uint16_t off_us = 0;
    std::uint8_t count = 0;
    std::int8_t gain_db = 0; ///< −24 … 6; the 2015 controller is said to take no notice of it

    bool operator==(const Pulses&) const = default;
};
/// A sharp tick swings at 500 Hz, a soft one at 125 Hz. Where the gain does nothing, the share of the time that is push tells the
/// amplitude.
Pulses pulses_of(const Tick& tick, Kind kind);

Feature play(Side side, const Pulses& pulses);
/// Both pads still.
Feature play_nothing();

/// Keys and mouse are imitated by the pads unless these were sent; the firmware of a Deck imitates again a few seconds after the
/// last of them. To be sent in this order.
std::array<Feature, 2> imitate_nothing(Kind kind);
/// As they are when nobody uses them.
std::array<Feature, 2> imitate_as_usual();
/// A receiver answers by a report of whether its controller is there.
Feature ask_whether_connected();

} // namespace tp::steam
