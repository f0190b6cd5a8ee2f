// SPDX-License-Identifier: Apache-2.0
#include "app/cli/touch_trial.hpp"

#include "app/cli/command_line.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/terminal.hpp"
#include "app/parts/feedbackd/touch_outputs.hpp"

#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

namespace tp {

namespace {

using Steady = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr double rest_s = 0.4; ///< from one tick to the next

void tell(const TouchCapabilities& can) {
    print("output      %s\nserial      %s\nmeans       %s\ndelay       %g s\nrate        %g "
          "Hz\nshortest    %g s\n",
          can.name.c_str(), can.serial_number.c_str(), word_of(can.means), can.delay, can.rate,
          can.shortest_s);
}

/// One tick, or as long a friction, and a rest; friction is told again as often as it must be. False where it was not delivered.
bool feel(TouchOutput& output, TouchMeans means, const Tick& tick) {
    constexpr std::chrono::milliseconds step{10};
    bool delivered = means == TouchMeans::friction || output.tick(tick);
    for (const auto begun = Steady::now(); delivered && !LongWork::stop_asked();) {
        const double past = Seconds(Steady::now() - begun).count();
        if (past > rest_s)
            break;
        if (means == TouchMeans::friction)
            delivered = output.resist(past < 0.5 * rest_s ? tick.amplitude() : 0.0);
        std::this_thread::sleep_for(step);
        delivered = delivered && !output.lost();
    }
    return delivered;
}

} // namespace

const char* word_of(TouchMeans means) {
    switch (means) {
    case TouchMeans::friction:
        return "friction";
    case TouchMeans::ticks:
        return "ticks";
    case TouchMeans::rumble:
        break;
    }
    return "rumble";
}

int tick_touch_output(const QStringList& words) {
    VerbLine line(
        "devices tick",
        "Makes a touch output tick a few times, from soft to sharp, or hold a moving finger back: what it\n"
        "reports of itself, and what is wrong.");
    line.argument("name", "The output's name, as devices lists it.", "NAME");
    line.option("count", "How many ticks.", "N", "5");
    line.option("strength", "Of the strongest it has, 0 to 1.", "S", "1");
    if (const auto ended = line.parse(words, 1, 1))
        return *ended;
    const auto count = line.whole("count", 1, 1000);
    const auto strength = line.positive("strength");
    if (!count || !strength)
        return wrong_usage("devices tick", count ? strength.error() : count.error());
    auto made = touch_output_here(line.arguments().first().toStdString());
    if (!made)
        return refused(made.error());
    TouchOutput& output = *made.value();
    const auto can = output.open();
    if (!can)
        return refused(can.error());
    tell(*can);
    LongWork::step("trying " + can->name);
    std::string complaint;
    for (int i = 0; i < *count && complaint.empty() && !LongWork::stop_asked(); ++i) {
        LongWork::share(static_cast<double>(i) / *count);
        const double sharpness = *count > 1 ? static_cast<double>(i) / (*count - 1) : 1.0;
        const bool delivered = feel(output, can->means, Tick(*strength, sharpness, 0.02));
        complaint = output.complaint();
        if (!delivered && complaint.empty())
            complaint = "The " + can->name + " does not tick any more. Unplug it and plug it in again.";
    }
    output.stop();
    if (!complaint.empty())
        return refused(complaint);
    return LongWork::stop_asked() ? LongWork::stop_code() : int{exit_done};
}

} // namespace tp
