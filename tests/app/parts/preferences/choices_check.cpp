// SPDX-License-Identifier: Apache-2.0
#include "choices_check.hpp"

#include "app/parts/preferences/choices.hpp"

namespace tp::test {

std::string complaint_about_choices(std::string_view bytes) {
    const Choices read =
        choices_from(QByteArray(bytes.data(), static_cast<qsizetype>(bytes.size())), Choices{});
    if (!(read.text_scale >= 1.0 && read.text_scale <= 2.0) ||
        !(read.max_force_n >= 0.1 && read.max_force_n <= 1.5) ||
        !(read.playback_speed >= 0.5 && read.playback_speed <= 2.0))
        return "a number beyond its bounds";
    for (const double latency : read.touch_latencies_s)
        if (!(latency >= 0.0 && latency <= 0.15))
            return "a latency beyond its bounds";
    if (const double rate = speech_rate(read.rate); !(rate >= -1.0 && rate <= 1.0))
        return "a rate that no voice has";
    return choices_from(json_of(read), Choices{}) == read ? "" : "written and read they are others";
}

} // namespace tp::test
