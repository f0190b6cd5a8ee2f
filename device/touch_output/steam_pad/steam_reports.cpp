// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/steam_pad/steam_reports.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace tp::steam {

namespace {

enum Command : std::uint8_t {
    clear_mappings = 0x81,
    default_mappings = 0x85,
    write_settings = 0x87,
    default_settings = 0x8E,
    haptic_pulse = 0x8F,
    wireless_state = 0xB4,
};
enum Setting : std::uint8_t {
    left_pad_mode = 7,
    right_pad_mode = 8,
    smooth_mouse = 24, ///< on the 2015 controller also the margin of its right pad
    left_click_pressure = 52,
    right_click_pressure = 53,
};
constexpr std::uint16_t pad_mode_none = 7;
constexpr std::uint16_t never_clicks = 0xFFFF;

enum InputKind : std::uint8_t { controller_state = 1, wireless = 3, deck_state = 9 };

/// The axes of the 2015 controller's pads lie turned towards each other (SDL: 15°).
constexpr double turned_by = 0.261799;

struct Setter {
    std::uint8_t setting;
    std::uint16_t value;
};

Feature command(std::uint8_t what) {
    Feature report{};
    report[1] = what;
    return report;
}

Feature settings(std::initializer_list<Setter> all) {
    Feature report = command(write_settings);
    report[2] = static_cast<std::uint8_t>(3 * all.size());
    std::size_t at = 3;
    for (const Setter& one : all) {
        report[at++] = one.setting;
        report[at++] = static_cast<std::uint8_t>(one.value & 0xFFu);
        report[at++] = static_cast<std::uint8_t>(one.value >> 8u);
    }
    return report;
}

double axis(std::span<const std::uint8_t> report, std::size_t at) {
    const auto bits = static_cast<std::uint16_t>(report[at] | report[at + 1] << 8u);
    return static_cast<double>(static_cast<std::int16_t>(bits)) / 32768.0;
}

Vec2 place_at(std::span<const std::uint8_t> report, std::size_t at, double turn, double width) {
    const Vec2 told(axis(report, at), axis(report, at + 2));
    const Vec2 place(std::cos(turn) * told.x - std::sin(turn) * told.y,
                     std::sin(turn) * told.x + std::cos(turn) * told.y);
    return 0.5 * width * glm::clamp(place, Vec2(-1.0), Vec2(1.0));
}

std::array<Pad, 2> deck_pads(std::span<const std::uint8_t> report) {
    const double width = pad_width_mm(Kind::deck);
    const std::uint8_t buttons = report[10];
    return {Pad{(buttons & 0x08u) != 0, (buttons & 0x02u) != 0, place_at(report, 16, 0.0, width)},
            Pad{(buttons & 0x10u) != 0, (buttons & 0x04u) != 0, place_at(report, 20, 0.0, width)}};
}

std::array<Pad, 2> controller_pads(std::span<const std::uint8_t> report) {
    const double width = pad_width_mm(Kind::controller);
    const std::uint8_t buttons = report[10];
    // The left pad and the stick share their bytes; while both are used they take turns.
    const bool pad_told = (buttons & 0x08u) != 0;
    const bool touched = pad_told || (buttons & 0x80u) != 0;
    Pad left{touched, touched && (buttons & 0x02u) != 0, std::nullopt};
    if (pad_told)
        left.place = place_at(report, 16, -turned_by, width);
    return {left,
            Pad{(buttons & 0x10u) != 0, (buttons & 0x04u) != 0, place_at(report, 20, turned_by, width)}};
}

} // namespace

std::optional<Kind> kind_of(std::uint16_t product) {
    switch (product) {
    case 0x1205:
        return Kind::deck;
    case 0x1102:
        return Kind::controller;
    case 0x1142:
        return Kind::receiver;
    default:
        return std::nullopt;
    }
}

double pad_width_mm(Kind kind) { return kind == Kind::deck ? 32.5 : 40.0; }

News news_of(std::span<const std::uint8_t> report) {
    News news;
    if (report.size() != input_bytes || report[0] != 1 || report[1] != 0)
        return news;
    if (report[2] == deck_state || report[2] == controller_state) {
        news.pads_told = true;
        news.pads = report[2] == deck_state ? deck_pads(report) : controller_pads(report);
    } else if (report[2] == wireless && (report[4] == 1 || report[4] == 2)) {
        news.connected = report[4] == 2;
    }
    return news;
}

Pulses pulses_of(const Tick& tick, Kind kind) {
    if (tick.empty())
        return {};
    const double period = 8000.0 - 6000.0 * tick.sharpness(); // µs
    const double count = std::max(1.0, std::floor(1e6 * tick.seconds() / period));
    const bool gain_works = kind == Kind::deck;
    const double push = 0.5 * period * (gain_works ? 1.0 : tick.amplitude());
    constexpr double least_push = 20.0;
    Pulses pulses;
    pulses.on_us = static_cast<std::uint16_t>(std::max(least_push, push));
    pulses.off_us = static_cast<std::uint16_t>(period - pulses.on_us);
    pulses.count = static_cast<std::uint8_t>(count);
    if (gain_works)
        pulses.gain_db =
            static_cast<std::int8_t>(std::clamp(6.0 + 20.0 * std::log10(tick.amplitude()), -24.0, 6.0));
    return pulses;
}

Feature play(Side side, const Pulses& pulses) {
    Feature report = command(haptic_pulse);
    report[2] = 8;
    report[3] = side == Side::right ? 0 : 1; // swapped, says hid-steam.c, for legacy reasons
    report[4] = static_cast<std::uint8_t>(pulses.on_us & 0xFFu);
    report[5] = static_cast<std::uint8_t>(pulses.on_us >> 8u);
    report[6] = static_cast<std::uint8_t>(pulses.off_us & 0xFFu);
    report[7] = static_cast<std::uint8_t>(pulses.off_us >> 8u);
    report[8] = pulses.count;
    report[10] = static_cast<std::uint8_t>(pulses.gain_db);
    return report;
}

Feature play_nothing() {
    Feature report = command(haptic_pulse);
    report[2] = 8;
    report[3] = 2; // both
    return report;
}

std::array<Feature, 2> imitate_nothing(Kind kind) {
    if (kind == Kind::deck)
        return {command(clear_mappings), settings({{smooth_mouse, 0},
                                                   {left_pad_mode, pad_mode_none},
                                                   {right_pad_mode, pad_mode_none},
                                                   {left_click_pressure, never_clicks},
                                                   {right_click_pressure, never_clicks}})};
    return {command(clear_mappings),
            settings({{smooth_mouse, 0}, {left_pad_mode, pad_mode_none}, {right_pad_mode, pad_mode_none}})};
}

std::array<Feature, 2> imitate_as_usual() { return {command(default_mappings), command(default_settings)}; }

Feature ask_whether_connected() { return command(wireless_state); }

} // namespace tp::steam
