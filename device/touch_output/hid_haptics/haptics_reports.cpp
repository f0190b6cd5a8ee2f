// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/hid_haptics/haptics_reports.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace tp::haptics {

namespace {

constexpr std::uint8_t ordinal_of_stop = 2; ///< and 1 of no waveform; both without an entry
constexpr std::int64_t page_of_haptics = 0x0E;

Output empty_output(const Layout& layout) {
    Output report;
    report.bytes[0] = layout.trigger.id;
    report.size = 1 + layout.trigger.bytes;
    return report;
}

std::span<std::uint8_t> behind_id(Output& report) {
    return std::span(report.bytes).subspan(1, report.size - 1);
}

double share_of(std::span<const std::uint8_t> report, const hid::Slot& slot) {
    const auto value = static_cast<double>(hid::value_in(report, slot) - slot.least);
    return std::clamp(value / static_cast<double>(slot.most - slot.least), 0.0, 1.0);
}

} // namespace

std::uint8_t Ordinals::of(double sharpness) const {
    const auto first = [](std::initializer_list<std::uint8_t> wanted) {
        for (const std::uint8_t ordinal : wanted)
            if (ordinal != 0)
                return ordinal;
        return std::uint8_t{0};
    };
    if (sharpness > 2.0 / 3.0)
        return first({click, press, hover});
    return sharpness > 1.0 / 3.0 ? first({press, click, hover}) : first({hover, press, click});
}

void note(const Layout& layout, const WaveformEntry& entry, std::span<const std::uint8_t> report,
          Ordinals& found) {
    if (std::size_t{entry.slot.bit} + entry.slot.size > 8 * report.size() ||
        entry.ordinal <= ordinal_of_stop || entry.ordinal > 0xFF ||
        entry.ordinal > layout.trigger.ordinal.most)
        return;
    const std::int64_t usage = entry.usage_of(hid::value_in(report, entry.slot));
    if (usage >> 16u != 0 && usage >> 16u != page_of_haptics)
        return;
    const auto ordinal = static_cast<std::uint8_t>(entry.ordinal);
    switch (static_cast<Waveform>(usage & 0xFFFF)) {
    case Waveform::click:
        found.click = ordinal;
        break;
    case Waveform::press:
        found.press = ordinal;
        break;
    case Waveform::hover:
        found.hover = ordinal;
        break;
    }
}

Output trigger(const Layout& layout, std::uint8_t ordinal, double amplitude) {
    Output report = empty_output(layout);
    hid::put_value(behind_id(report), layout.trigger.ordinal, ordinal);
    const hid::Slot& intensity = layout.trigger.intensity;
    if (intensity.there())
        hid::put_value(behind_id(report), intensity,
                       intensity.least +
                           std::llround(amplitude * static_cast<double>(intensity.most - intensity.least)));
    return report;
}

Output stop(const Layout& layout) {
    Output report = empty_output(layout);
    hid::put_value(behind_id(report), layout.trigger.ordinal, ordinal_of_stop);
    return report;
}

std::optional<Fingers> fingers_in(const Layout& layout, std::span<const std::uint8_t> report) {
    if (!layout.pad || (layout.numbered && (report.empty() || report[0] != layout.pad->report_id)))
        return std::nullopt;
    const std::span<const std::uint8_t> values = layout.numbered ? report.subspan(1) : report;
    const auto lies_in = [values](const hid::Slot& slot) {
        return std::size_t{slot.bit} + slot.size <= 8 * values.size();
    };
    Fingers found;
    std::size_t number = 0;
    for (const FingerSlots& slots : layout.pad->fingers) {
        if (!lies_in(slots.tip) || !lies_in(slots.x) || !lies_in(slots.y) || !lies_in(slots.contact))
            return std::nullopt;
        Finger& finger = found.fingers[number];
        finger.there = hid::value_in(values, slots.tip) != 0;
        finger.contact =
            slots.contact.there() ? hid::value_in(values, slots.contact) : static_cast<std::int64_t>(number);
        const Vec2 share(share_of(values, slots.x), share_of(values, slots.y));
        finger.place = layout.pad->size * (Vec2(share.x, 1.0 - share.y) - 0.5); // a pad's y goes down
        ++number;
    }
    found.pressed = hid::value_in(values, layout.pad->button) != 0;
    return found;
}

} // namespace tp::haptics
