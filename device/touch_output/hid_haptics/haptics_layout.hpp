// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"
#include "device/hid/report_bits.hpp"
#include "device/hid/report_descriptor.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

/// What a device says of its haptics (HID Usage Tables 1.5, page 0x0E) and of its touch pad (page 0x0D), as Microsoft's guides for
/// makers of input devices with haptics and of touch pads ask for it.
namespace tp::haptics {

inline constexpr std::size_t most_output_bytes = 64;
inline constexpr std::size_t most_waveforms = 32;
inline constexpr std::size_t most_fingers = 8;

/// One entry of the list of waveforms. The feature report has the waveform's usage, or a number that stands for it.
struct WaveformEntry {
    std::uint32_t ordinal = 0;
    std::uint8_t report_id = 0;
    std::size_t report_bytes = 0; ///< behind the id
    hid::Slot slot;
    std::int64_t logical_min = 0, logical_max = 0;
    std::int64_t physical_min = 0, physical_max = 0; ///< both 0: the same as the logical ones

    /// The usage that a value in the report stands for.
    std::int64_t usage_of(std::int64_t value) const;
};

struct TriggerReport {
    std::uint8_t id = 0;
    std::size_t bytes = 0; ///< behind the id
    hid::Slot ordinal;
    hid::Slot intensity; ///< may be missing
};

struct FingerSlots {
    hid::Slot tip;
    hid::Slot contact; ///< may be missing
    hid::Slot x, y;
};

struct TouchPad {
    std::uint8_t report_id = 0;
    std::vector<FingerSlots> fingers; ///< of one report; at least one
    hid::Slot button;                 ///< may be missing
    Vec2 size{0.0};                   ///< mm
};

struct Layout {
    bool numbered = false; ///< every report begins with its id
    TriggerReport trigger;
    std::vector<WaveformEntry> waveforms;
    std::optional<TouchPad> pad; ///< one whose size is told
};

/// Whether a descriptor is of a device with haptics.
bool has_haptics(const hid::ReportDescriptor& descriptor);
/// Fills `layout`, or says what keeps the device from being used, as the end of a sentence.
const char* find_layout(const hid::ReportDescriptor& descriptor, Layout& layout);

} // namespace tp::haptics
