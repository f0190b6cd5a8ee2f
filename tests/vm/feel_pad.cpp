// SPDX-License-Identifier: Apache-2.0
// vm_feel_pad OUTPUT LOG: what TouchPhoto does with a touch output that is a pad, without its pages: it waits for the output in the
// registry, opens it, reads it each millisecond, ticks where the finger crosses one of the upright lines, and begins anew when
// the pad is lost. Ends with the standard input.
#include "core/servo/clock.hpp"
#include "device/touch_output/touch_registry.hpp"
#include "pad_reading.hpp"
#include "shared_log.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <poll.h>
#include <string>
#include <sys/mman.h>
#include <unistd.h>
#include <utility>

using namespace tp;

namespace {

/// The standard input has ended, which it may do for `wait_ms` yet.
bool told_to_end(int wait_ms) {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    return ::poll(&input, 1, wait_ms) > 0;
}

/// The output as soon as it is there and open; nothing when it is time to end.
std::unique_ptr<TouchOutput> awaited(const std::string& name) {
    std::string said;
    while (!told_to_end(20)) {
        auto made = touch_output_named(name);
        if (!made)
            continue;
        const auto can = (*made)->open();
        if (can)
            return std::move(made).value();
        if (can.error() != said)
            std::fprintf(stderr, "%s\n", can.error().c_str());
        said = can.error();
    }
    return nullptr;
}

/// True where the pad was lost.
bool feel(TouchOutput& pad, vm::SharedLog<vm::PadReading>& log) {
    SteadyClock clock;
    vm::PadReading seen;
    if (log.size() > 0)
        seen.ticks = log[log.size() - 1].ticks;
    double due = clock.now();
    long line = 0;
    bool known = false;
    for (int ticks = 0; !pad.lost() && (ticks % 8 != 0 || !told_to_end(0)); ++ticks) {
        due += 0.001;
        clock.sleep_until(due);
        const double began = clock.now();
        if (const auto touch = pad.read(began)) {
            seen.place = touch->place;
            seen.touched = touch->touched;
        }
        const long now_in = std::lround(std::floor(seen.place.x / vm::line_every_mm));
        if (known && seen.touched && now_in != line)
            seen.ticks += pad.tick(Tick(0.8, 1.0, 0.01)) ? 1 : 0;
        known = seen.touched;
        line = now_in;
        seen.time = clock.now();
        seen.longest_call_s = std::max(seen.longest_call_s, seen.time - began);
        log.append(seen);
    }
    const bool lost = pad.lost();
    if (lost) {
        std::fprintf(stderr, "%s\n", pad.complaint().c_str());
        seen.lost = true;
        log.append(seen);
    }
    pad.stop();
    return lost;
}

} // namespace

int main(int count, char** words) {
    if (count != 3) {
        std::fputs("vm_feel_pad OUTPUT LOG\n", stderr);
        return 2;
    }
    vm::SharedLog<vm::PadReading> log(words[2]);
    // The programs lie on another machine's disk, from which no page may come in mid-touch.
    if (!log.good() || ::mlockall(MCL_CURRENT | MCL_FUTURE) != 0) {
        std::fputs("The touch cannot begin.\n", stderr);
        return 2;
    }
    while (const auto pad = awaited(words[1]))
        if (!feel(*pad, log))
            break;
    return 0;
}
