// SPDX-License-Identifier: Apache-2.0
#include "port.hpp"
#include "shared_log.hpp"

#include <cstdio>
#include <ctime>
#include <poll.h>
#include <sched.h>
#include <string>
#include <sys/mman.h>
#include <unistd.h>

namespace tp::vm {

namespace {

constexpr long long period_ns = 1'000'000;
constexpr long long second_ns = 1'000'000'000;

long long now_ns() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return second_ns * now.tv_sec + now.tv_nsec;
}

/// A real device is hardware: no program of the computer delays it, and it is not paged out.
bool be_as_prompt_as_hardware() {
    sched_param priority{};
    priority.sched_priority = 50;
    return sched_setscheduler(0, SCHED_FIFO, &priority) == 0 && mlockall(MCL_CURRENT | MCL_FUTURE) == 0;
}

/// Does what a letter asks for; false where the port refuses.
bool obey(char letter, VirtualDevice& device, Port& port) {
    switch (letter) {
    case 'p':
        return port.file() >= 0 || port.plug_in();
    case 'u':
        port.unplug();
        return true;
    case 's':
    case 't':
        device.silence(letter == 's');
        return true;
    default:
        return true;
    }
}

} // namespace

int serve(VirtualDevice& device, Port& port, const std::string& log_file) {
    SharedLog<DeviceSample> log(log_file);
    if (!log.good() || !be_as_prompt_as_hardware()) {
        std::perror("The virtual device cannot begin");
        return 1;
    }
    long long due = now_ns() + period_ns;
    while (true) {
        const long long left = due - now_ns();
        if (left <= 0) {
            DeviceSample sample = device.step();
            sample.time = static_cast<double>(due) / static_cast<double>(second_ns);
            sample.plugged = port.file() >= 0;
            log.append(sample);
            if (sample.plugged && !port.pass_on())
                return 1;
            due += period_ns;
            continue;
        }
        pollfd files[] = {{STDIN_FILENO, POLLIN, 0}, {port.file(), POLLIN, 0}};
        const timespec wait{0, static_cast<long>(left)};
        if (::ppoll(files, 2, &wait, nullptr) <= 0)
            continue;
        if (files[0].revents != 0) {
            char letter = 0;
            if (::read(STDIN_FILENO, &letter, 1) != 1)
                break;
            if (!obey(letter, device, port))
                return 1;
        } else if (files[1].revents != 0 && !port.take_in()) {
            return 1;
        }
    }
    port.unplug();
    return 0;
}

} // namespace tp::vm
