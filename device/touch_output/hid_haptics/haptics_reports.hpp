// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/touch_output/hid_haptics/haptics_layout.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tp::haptics {

/// The waveforms that end by themselves (HID Usage Tables 1.5).
enum class Waveform : std::uint16_t { click = 0x1003, press = 0x1006, hover = 0x1008 };

/// The ordinals by which they are played on one device; 0 for one that it has not.
struct Ordinals {
    std::uint8_t click = 0, press = 0, hover = 0;

    bool any() const { return click != 0 || press != 0 || hover != 0; }
    /// For a sharpness of 0 (hover) … 1 (click): the nearest that there is.
    std::uint8_t of(double sharpness) const;
};

/// Reads the list of waveforms: `report_of` gives a feature report by its id and its bytes behind the id, empty where the device
/// does not answer.
template <typename ReportOf>
Ordinals read_ordinals(const Layout& layout, ReportOf report_of);
/// Notes what one entry's report says.
void note(const Layout& layout, const WaveformEntry& entry, std::span<const std::uint8_t> report,
          Ordinals& found);

/// An output report; its id leads, 0 where the device does not number its reports.
struct Output {
    std::array<std::uint8_t, 1 + most_output_bytes> bytes{};
    std::size_t size = 0;

    std::span<const std::uint8_t> all() const { return std::span(bytes).first(size); }
};
/// Plays once, `amplitude` 0 … 1 of its strongest.
Output trigger(const Layout& layout, std::uint8_t ordinal, double amplitude);
/// Whatever plays is over.
Output stop(const Layout& layout);

struct Finger {
    bool there = false;
    std::int64_t contact = 0;
    Vec2 place{0.0}; ///< mm, x right, y up, origin in the pad's middle
};
struct Fingers {
    std::array<Finger, most_fingers> fingers;
    bool pressed = false;
};
/// What an input report tells of the pad, as the system gives it (its id in front where the device numbers them); nothing where it is
/// another report, or too short.
std::optional<Fingers> fingers_in(const Layout& layout, std::span<const std::uint8_t> report);

template <typename ReportOf>
Ordinals read_ordinals(const Layout& layout, ReportOf report_of) {
    Ordinals found;
    std::vector<std::uint8_t> report;
    std::optional<std::uint8_t> had;
    for (const WaveformEntry& entry : layout.waveforms) {
        if (had != entry.report_id)
            report = report_of(entry.report_id, entry.report_bytes);
        had = entry.report_id;
        note(layout, entry, report, found);
    }
    return found;
}

} // namespace tp::haptics
