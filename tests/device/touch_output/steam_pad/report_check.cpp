// SPDX-License-Identifier: Apache-2.0
#include "report_check.hpp"

#include "device/touch_output/steam_pad/steam_reports.hpp"

#include <cmath>
#include <cstdint>
#include <span>

namespace tp::test {

std::string complaint_about_steam_report(std::string_view bytes) {
    const std::span report(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    const steam::News news = steam::news_of(report);
    if (report.size() != steam::input_bytes && (news.pads_told || news.connected))
        return "a report of another length tells something";
    if (news.pads_told && news.connected)
        return "one report tells two things";
    for (const steam::Pad& pad : news.pads) {
        if (!news.pads_told && (pad.touched || pad.pressed || pad.place))
            return "a pad is told of by what is no report of pads";
        if (pad.place && !(std::abs(pad.place->x) <= 20.0 && std::abs(pad.place->y) <= 20.0))
            return "a thumb lies beside its pad";
    }
    return {};
}

} // namespace tp::test
