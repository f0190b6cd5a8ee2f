// SPDX-License-Identifier: Apache-2.0
#include "descriptor_check.hpp"

#include "device/hid/report_bits.hpp"
#include "device/hid/report_descriptor.hpp"
#include "device/hid_pid/pid_layout.hpp"
#include "device/hid_pid/pid_reports.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

namespace tp::test {

using namespace tp::hid;

namespace {

std::string complaint_about_fields(const ReportDescriptor& found, std::size_t bytes) {
    if (found.fields.size() + found.collections.size() > bytes)
        return "there is more in it than bytes";
    std::array<std::array<std::uint32_t, 256>, 3> filled{};
    for (const Field& field : found.fields) {
        std::uint32_t& from = filled[static_cast<std::size_t>(field.kind)][field.report_id];
        if (field.bit_offset < from)
            return "two fields lie on each other";
        from = field.bit_offset + field.bit_size * field.count;
        if (from > found.bits[static_cast<std::size_t>(field.kind)][field.report_id])
            return "a field lies outside its report";
        if (field.collection >= static_cast<int>(found.collections.size()))
            return "a field is in a collection that is none";
        if (field.index_of(field.usage_at(0)) != (field.usages.empty() ? -1 : 0))
            return "the first usage is not the first";
    }
    for (std::size_t i = 0; i < found.collections.size(); ++i)
        if (found.collections[i].parent >= static_cast<int>(i))
            return "a collection is in one that comes after it";
    return {};
}

/// What is put into a slot comes out of it, and nothing else changes.
std::string complaint_about_slot(const Slot& slot, std::size_t bytes) {
    if (!slot.there())
        return {};
    if (slot.bit + slot.size > 8 * bytes || slot.size > 32 || slot.most <= slot.least)
        return "a value lies outside its report";
    for (const std::int64_t value : {slot.least, slot.most, (slot.least + slot.most) / 2}) {
        for (const std::uint8_t background : {std::uint8_t{0x00}, std::uint8_t{0xFF}}) {
            std::vector<std::uint8_t> report(bytes, background);
            put_value(report, slot, value);
            if (value_in(report, slot) != value)
                return "a value is not given back as it was put";
            put_bits(report, slot, background == 0 ? 0 : ~std::uint64_t{0});
            if (std::any_of(report.begin(), report.end(),
                            [background](std::uint8_t byte) { return byte != background; }))
                return "putting a value changes another";
        }
        std::vector<std::uint8_t> cut(bytes - 1);
        if (slot.bit + slot.size > 8 * cut.size() && value_in(cut, slot) != 0)
            return "a value is read behind the end of its report";
    }
    return {};
}

std::string complaint_about_reports(const PidLayout& layout) {
    const Slot& magnitude = layout.force.magnitude;
    for (const int share : {-full_share, -1, 0, 1, full_share}) {
        const Report report = force_report(layout, 1, share);
        if (report.size != 1 + layout.force.report.bytes)
            return "a report is not as long as it should be";
        const std::int64_t value = value_in(report.all().subspan(1), magnitude);
        if (std::abs(value) > std::abs(std::int64_t{share} * magnitude.most / full_share) ||
            (value > 0) != (share > 0 && value != 0))
            return "a force grows on its way";
    }
    for (const Along along : {Along::x, Along::y})
        if (effect_report(layout, 1, along).size > 1 + most_report_bytes)
            return "an effect's report is too long";
    std::array<std::uint8_t, 1 + most_report_bytes> noise{};
    for (std::size_t i = 0; i < noise.size(); ++i)
        noise[i] = static_cast<std::uint8_t>(0x5A + 37 * i);
    for (std::size_t size = 0; size <= noise.size(); ++size) {
        noise[0] = layout.stick.report.id;
        const JoystickNews news = joystick_news(layout, std::span(noise).first(size));
        if (news.axes && (std::abs(news.axes->x) > 1.0 || std::abs(news.axes->y) > 1.0))
            return "an axis goes farther than its end";
        loaded_block(layout, std::span(noise).first(size));
    }
    return {};
}

std::string complaint_about_layout(const PidLayout& layout) {
    const std::pair<const ReportShape&, std::vector<Slot>> reports[] = {
        {layout.create.report, {layout.create.constant_force.slot}},
        {layout.block_load.report,
         {layout.block_load.block, layout.block_load.success.slot, layout.block_load.full.slot}},
        {layout.effect.report,
         {layout.effect.block, layout.effect.duration, layout.effect.gain, layout.effect.axis_enable[0],
          layout.effect.axis_enable[1], layout.effect.direction_enable, layout.effect.direction[0],
          layout.effect.direction[1]}},
        {layout.force.report, {layout.force.block, layout.force.magnitude}},
        {layout.operation.report,
         {layout.operation.block, layout.operation.start.slot, layout.operation.stop.slot}},
        {layout.free.report, {layout.free.block}},
        {layout.control.report, {layout.control.enable.slot, layout.control.reset.slot}},
        {layout.state.report, {layout.state.actuators_enabled, layout.state.safety_switch}},
        {layout.stick.report, {layout.stick.axis[0], layout.stick.axis[1], layout.stick.buttons[0]}},
    };
    for (const auto& [report, values] : reports)
        for (const Slot& slot : values)
            if (std::string words = complaint_about_slot(slot, report.bytes); !words.empty())
                return words;
    return complaint_about_reports(layout);
}

} // namespace

std::string complaint_about_descriptor(std::string_view bytes) {
    ReportDescriptor found;
    const auto* const data = reinterpret_cast<const std::uint8_t*>(bytes.data());
    if (parse_report_descriptor(std::span(data, bytes.size()), found) != DescriptorFault::none)
        return found.fields.empty() && found.collections.empty() ? std::string()
                                                                 : "something is left of a broken descriptor";
    if (std::string words = complaint_about_fields(found, bytes.size()); !words.empty())
        return words;
    PidLayout layout;
    return find_layout(found, layout) == nullptr ? complaint_about_layout(layout) : std::string();
}

} // namespace tp::test
