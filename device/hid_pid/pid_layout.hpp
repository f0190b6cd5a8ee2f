// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/hid/report_bits.hpp"
#include "device/hid/report_descriptor.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace tp::hid {

inline constexpr std::size_t most_report_bytes =
    63; ///< behind the id: with it, a packet of a full-speed device

/// A report of one device; `bytes` behind its id, 0: the device has no such report.
struct ReportShape {
    std::uint8_t id = 0;
    std::size_t bytes = 0;

    bool there() const { return bytes > 0; }
};

/// One thing of several that a report can say: a number of an array, or a bit of its own.
struct Choice {
    Slot slot;
    std::int64_t value = 0;

    bool there() const { return slot.there(); }
};

/// Where a two-axis force-feedback stick of the Physical Interface Device class (USB Device Class Definition
/// for PID 1.0) has what a constant force needs. Everything that may be missing in a device is marked so.
struct PidLayout {
    bool numbered = false; ///< every report begins with its id

    struct Create { ///< feature, to the device
        ReportShape report;
        Choice constant_force;
    } create;
    struct BlockLoad { ///< feature, from the device
        ReportShape report;
        Slot block;
        Choice success, full;
    } block_load;
    struct SetEffect { ///< output
        ReportShape report;
        Slot block;
        Choice constant_force; ///< may be missing
        Slot duration;         ///< may be missing, as all below
        Slot gain;
        std::array<Slot, 2> axis_enable; ///< x, y
        Slot direction_enable;
        std::array<Slot, 2> direction;
    } effect;
    struct ConstantForce { ///< output
        ReportShape report;
        Slot block;
        Slot magnitude;
    } force;
    struct Operation { ///< output
        ReportShape report;
        Slot block;
        Choice start, stop;
        Slot loops; ///< may be missing
    } operation;
    struct BlockFree { ///< output; may be missing
        ReportShape report;
        Slot block;
    } free;
    struct Control { ///< output; may be missing, and so may each choice
        ReportShape report;
        Choice enable, disable, stop_all, reset;
    } control;
    struct Gain { ///< output; may be missing
        ReportShape report;
        Slot gain;
    } gain;
    struct State { ///< input; may be missing, and so may each value
        ReportShape report;
        Slot paused, actuators_enabled, safety_switch, actuator_power;
    } state;
    struct Stick { ///< input
        ReportShape report;
        std::array<Slot, 2> axis; ///< x, y
        std::array<Slot, 32> buttons{};
    } stick;
};

/// Whether the device can be asked for a constant force at all: what else is wrong with it is worth a word
/// then.
bool has_constant_force(const ReportDescriptor& descriptor);

/// Finds them; else what keeps the stick from being used, as the end of a sentence after a colon.
const char* find_layout(const ReportDescriptor& descriptor, PidLayout& layout);

} // namespace tp::hid
