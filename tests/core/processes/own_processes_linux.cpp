// SPDX-License-Identifier: Apache-2.0
#include "own_processes.hpp"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace tp::test {
namespace {

std::vector<pid_t> listed(std::ifstream list) {
    std::vector<pid_t> processes;
    for (pid_t process = 0; list >> process;)
        processes.push_back(process);
    return processes;
}

std::ifstream list() { return std::ifstream("/proc/self/task/" + std::to_string(getpid()) + "/children"); }

} // namespace

const bool in_wine = false;

int own_processes() { return list() ? static_cast<int>(listed(list()).size()) : -1; }

int kill_own_processes() {
    const std::vector<pid_t> processes = listed(list());
    for (const pid_t process : processes) {
        ::kill(process, SIGKILL);
        siginfo_t ended{};
        ::waitid(P_PID, static_cast<id_t>(process), &ended, WEXITED | WNOWAIT);
    }
    return static_cast<int>(processes.size());
}

} // namespace tp::test
