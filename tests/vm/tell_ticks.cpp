// SPDX-License-Identifier: Apache-2.0
// vm_tell_ticks NAME: what TouchPhoto does with a touch output, without its pages: it waits for the output in the registry,
// opens it and tells it the strongest tick every 30 ms, so that it never is still. Says "ticks" once it does. Ends with the
// standard input, or in 3, with a sentence, when the output is lost.
#include "device/touch_output/touch_registry.hpp"

#include <cstdio>
#include <memory>
#include <poll.h>
#include <string>
#include <sys/mman.h>
#include <unistd.h>
#include <utility>

using namespace tp;

namespace {

constexpr int pause_ms = 30;
constexpr int lost = 3;

/// The standard input has ended, which it may do for `wait_ms` yet.
bool told_to_end(int wait_ms) {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    return ::poll(&input, 1, wait_ms) > 0;
}

/// The output as soon as it is there; nothing when it is time to end.
std::unique_ptr<TouchOutput> awaited(const std::string& name) {
    while (!told_to_end(20))
        for (const ListedTouchOutput& listed : list_touch_outputs())
            if (listed.name == name || listed.about == name)
                if (auto made = touch_output_named(listed.name))
                    return std::move(made).value();
    return nullptr;
}

} // namespace

int main(int count, char** words) {
    if (count != 2) {
        std::fputs("vm_tell_ticks NAME\n", stderr);
        return 2;
    }
    const std::unique_ptr<TouchOutput> output = awaited(words[1]);
    if (!output)
        return 0;
    if (const auto can = output->open(); !can) {
        std::fprintf(stderr, "%s\n", can.error().c_str());
        return 1;
    }
    mlockall(MCL_CURRENT | MCL_FUTURE);
    for (bool said = false; !told_to_end(pause_ms);) {
        if (!output->tick(Tick(1.0, 0.0, Tick::longest_s))) {
            std::fprintf(stderr, "%s\n", output->complaint().c_str());
            return lost;
        }
        if (!std::exchange(said, true)) {
            std::puts("ticks");
            std::fflush(stdout);
        }
    }
    output->stop();
    return 0;
}
