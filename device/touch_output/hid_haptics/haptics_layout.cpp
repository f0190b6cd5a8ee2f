// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/hid_haptics/haptics_layout.hpp"

#include "device/hid/field_slot.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace tp::haptics {

namespace {

using hid::Field;
using hid::ReportDescriptor;
using hid::ReportKind;
using hid::Slot;
using hid::slot_of;

constexpr std::uint32_t haptics_page(std::uint32_t id) { return hid::usage_of(0x0E, id); }
constexpr std::uint32_t digitizer(std::uint32_t id) { return hid::usage_of(0x0D, id); }
constexpr std::uint32_t desktop(std::uint32_t id) { return hid::usage_of(0x01, id); }

constexpr std::uint32_t simple_haptics_controller = haptics_page(0x01);
constexpr std::uint32_t waveform_list = haptics_page(0x10);
constexpr std::uint32_t manual_trigger = haptics_page(0x21);
constexpr std::uint32_t intensity = haptics_page(0x23);
constexpr std::uint32_t ordinal_page = 0x0A;

constexpr std::uint32_t touch_pad = digitizer(0x05);
constexpr std::uint32_t finger = digitizer(0x22);
constexpr std::uint32_t tip_switch = digitizer(0x42);
constexpr std::uint32_t contact_id = digitizer(0x51);
constexpr std::uint32_t axis_x = desktop(0x30);
constexpr std::uint32_t axis_y = desktop(0x31);
constexpr std::uint32_t main_button = hid::usage_of(0x09, 1);

void find_trigger(const ReportDescriptor& descriptor, TriggerReport& trigger) {
    for (const Field& field : descriptor.fields) {
        if (field.kind != ReportKind::output || field.array || field.constant ||
            !descriptor.within(field.collection, simple_haptics_controller))
            continue;
        const std::int64_t at = field.index_of(manual_trigger);
        if (at < 0 || trigger.ordinal.there())
            continue;
        trigger.id = field.report_id;
        trigger.bytes = descriptor.bytes(ReportKind::output, field.report_id);
        trigger.ordinal = slot_of(field, static_cast<std::uint32_t>(at));
    }
    for (const Field& field : descriptor.fields)
        if (field.kind == ReportKind::output && field.report_id == trigger.id && !field.array &&
            !field.constant && field.index_of(intensity) >= 0 && !trigger.intensity.there())
            trigger.intensity = slot_of(field, static_cast<std::uint32_t>(field.index_of(intensity)));
}

void find_waveforms(const ReportDescriptor& descriptor, std::vector<WaveformEntry>& entries) {
    for (const Field& field : descriptor.fields) {
        if (field.kind != ReportKind::feature || field.array ||
            !descriptor.within(field.collection, waveform_list) ||
            !descriptor.within(field.collection, simple_haptics_controller))
            continue;
        for (std::uint32_t i = 0; i < std::min<std::uint32_t>(field.count, most_waveforms); ++i) {
            const std::uint32_t usage = field.usage_at(i);
            const Slot slot = slot_of(field, i);
            if (usage >> 16u != ordinal_page || !slot.there() || entries.size() >= most_waveforms)
                continue;
            entries.push_back({usage & 0xFFFFu, field.report_id,
                               descriptor.bytes(ReportKind::feature, field.report_id), slot,
                               field.logical_min, field.logical_max, field.physical_min, field.physical_max});
        }
    }
}

/// mm of an axis from end to end; 0 where its unit is no length.
double length_mm(const Field& field) {
    const std::uint32_t system = field.unit & 0xFu;
    const bool length = (field.unit >> 4u & 0xFu) == 1 && field.unit >> 8u == 0;
    const double unit_mm = system == 1 ? 10.0 : system == 3 ? 25.4 : 0.0; // centimetres, inches
    const auto way = static_cast<double>(field.physical_max - field.physical_min);
    // Divided, for 10⁻² is no number that a double holds.
    const double scale = std::pow(10.0, std::abs(field.unit_exponent));
    const double mm = field.unit_exponent < 0 ? way * unit_mm / scale : way * unit_mm * scale;
    return length && mm >= 10.0 && mm <= 1000.0 ? mm : 0.0; // no pad is smaller or larger
}

std::optional<TouchPad> find_pad(const ReportDescriptor& descriptor) {
    TouchPad pad;
    std::optional<int> of_finger; // the collection of the finger that is being read
    for (const Field& field : descriptor.fields) {
        if (field.kind != ReportKind::input || field.array || field.constant || field.relative ||
            !descriptor.within(field.collection, touch_pad))
            continue;
        if (!pad.fingers.empty() && field.report_id != pad.report_id)
            continue;
        for (std::uint32_t i = 0; i < std::min<std::uint32_t>(field.count, 8); ++i) {
            const std::uint32_t usage = field.usage_at(i);
            if (usage == main_button && !pad.button.there()) {
                pad.button = slot_of(field, i);
            } else if (descriptor.within(field.collection, finger)) {
                if (field.collection != of_finger && pad.fingers.size() >= most_fingers)
                    continue;
                if (field.collection != of_finger) {
                    of_finger = field.collection;
                    pad.fingers.emplace_back();
                    pad.report_id = field.report_id;
                }
                FingerSlots& slots = pad.fingers.back();
                Slot* const found = usage == tip_switch   ? &slots.tip
                                    : usage == contact_id ? &slots.contact
                                    : usage == axis_x     ? &slots.x
                                    : usage == axis_y     ? &slots.y
                                                          : nullptr;
                if (found != nullptr)
                    *found = slot_of(field, i);
                if (usage == axis_x && pad.size.x == 0.0)
                    pad.size.x = length_mm(field);
                if (usage == axis_y && pad.size.y == 0.0)
                    pad.size.y = length_mm(field);
            }
        }
    }
    std::erase_if(pad.fingers, [](const FingerSlots& slots) {
        return !slots.tip.there() || !slots.x.there() || !slots.y.there();
    });
    if (pad.fingers.empty() || pad.size.x == 0.0 || pad.size.y == 0.0)
        return std::nullopt;
    return pad;
}

} // namespace

std::int64_t WaveformEntry::usage_of(std::int64_t value) const {
    if ((physical_min == 0 && physical_max == 0) ||
        (physical_min == logical_min && physical_max == logical_max))
        return value;
    if (logical_max <= logical_min)
        return physical_min;
    const std::int64_t held = std::clamp(value, logical_min, logical_max);
    const double share =
        static_cast<double>(held - logical_min) / static_cast<double>(logical_max - logical_min);
    return physical_min + std::llround(share * static_cast<double>(physical_max - physical_min));
}

bool has_haptics(const ReportDescriptor& descriptor) {
    return std::any_of(descriptor.collections.begin(), descriptor.collections.end(),
                       [](const hid::Collection& one) { return one.usage == simple_haptics_controller; });
}

const char* find_layout(const ReportDescriptor& descriptor, Layout& layout) {
    layout = Layout{};
    layout.numbered = descriptor.numbered;
    find_trigger(descriptor, layout.trigger);
    if (!layout.trigger.ordinal.there())
        return "it ticks by itself only and takes no ticks from a program";
    // From 2, which stops, to at least the first of the list.
    const Slot& ordinal = layout.trigger.ordinal;
    if (layout.trigger.bytes > most_output_bytes || ordinal.least < 0 || ordinal.least > 2 ||
        ordinal.most < 3)
        return "what it says of its ticks cannot be right";
    find_waveforms(descriptor, layout.waveforms);
    if (layout.waveforms.empty())
        return "it does not say which ticks it has";
    layout.pad = find_pad(descriptor);
    return nullptr;
}

} // namespace tp::haptics
