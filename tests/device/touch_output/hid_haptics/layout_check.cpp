// SPDX-License-Identifier: Apache-2.0
#include "layout_check.hpp"

#include "device/hid/report_bits.hpp"
#include "device/hid/report_descriptor.hpp"
#include "device/touch_output/hid_haptics/haptics_reports.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace tp::test {

namespace {

using namespace tp::haptics;

std::string complaint_about_outputs(const Layout& layout, const Ordinals& ordinals) {
    for (const double sharpness : {0.0, 0.5, 1.0}) {
        const std::uint8_t ordinal = ordinals.of(sharpness);
        if (ordinals.any() != (ordinal != 0))
            return "a waveform is chosen that is not there";
        if (ordinal == 1 || ordinal == 2)
            return "no waveform is played as one";
        double weaker = -1e300;
        for (const double amplitude : {0.0, 0.4, 1.0}) {
            const Output report = trigger(layout, ordinal, amplitude);
            if (report.size != 1 + layout.trigger.bytes || report.size > report.bytes.size())
                return "a report is not as long as it should be";
            const auto values = report.all().subspan(1);
            if (ordinal != 0 && hid::value_in(values, layout.trigger.ordinal) != ordinal)
                return "another waveform is played";
            const auto strength = static_cast<double>(hid::value_in(values, layout.trigger.intensity));
            if (strength < weaker)
                return "a stronger tick is weaker";
            weaker = strength;
        }
    }
    if (hid::value_in(stop(layout).all().subspan(1), layout.trigger.ordinal) != 2)
        return "it is not stopped";
    return {};
}

std::string complaint_about_input(const Layout& layout, std::span<const std::uint8_t> report) {
    const auto fingers = fingers_in(layout, report);
    if (!fingers)
        return {};
    if (!layout.pad)
        return "a finger lies on no pad";
    for (const Finger& finger : fingers->fingers)
        if (!(std::abs(finger.place.x) <= 0.5 * layout.pad->size.x &&
              std::abs(finger.place.y) <= 0.5 * layout.pad->size.y))
            return "a finger lies beside the pad";
    return {};
}

} // namespace

std::string complaint_about_haptics(std::string_view bytes) {
    const std::span all(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    if (all.empty())
        return {};
    const std::size_t described = std::min<std::size_t>(4u * all[0], all.size() - 1);
    const std::span descriptor_bytes = all.subspan(1, described);
    const std::span report = all.subspan(1 + described);
    hid::ReportDescriptor descriptor;
    Layout layout;
    if (hid::parse_report_descriptor(descriptor_bytes, descriptor) != hid::DescriptorFault::none ||
        find_layout(descriptor, layout) != nullptr)
        return {};
    if (!has_haptics(descriptor))
        return "a device without haptics is used";
    if (layout.waveforms.size() > most_waveforms || (layout.pad && layout.pad->fingers.size() > most_fingers))
        return "there is more of something than there may be";
    if (layout.pad && !(layout.pad->size.x >= 10.0 && layout.pad->size.x <= 1000.0 &&
                        layout.pad->size.y >= 10.0 && layout.pad->size.y <= 1000.0))
        return "a pad is of no possible size";
    const Ordinals ordinals = read_ordinals(layout, [report](std::uint8_t, std::size_t count) {
        return std::vector<std::uint8_t>(
            report.begin(), report.begin() + static_cast<std::ptrdiff_t>(std::min(count, report.size())));
    });
    if (std::string words = complaint_about_outputs(layout, ordinals); !words.empty())
        return words;
    return complaint_about_input(layout, report);
}

} // namespace tp::test
