// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <malloc.h>

namespace tp::test {

/// What this process holds of the machine (Linux, proc(5)).
struct ProcessLoad {
    double memory_mb = 0.0; ///< its own, without files that are mapped; what is free goes back to the system first
    std::size_t handles = 0;
    std::size_t threads = 0;

    static ProcessLoad now() {
        ::malloc_trim(0);
        const auto count = [](const char* folder) {
            return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
        };
        return {kilobytes("RssAnon:") / 1024.0, count("/proc/self/fd"), count("/proc/self/task")};
    }

private:
    static double kilobytes(const std::string& what) {
        std::ifstream status("/proc/self/status");
        for (std::string word; status >> word;)
            if (double kb = 0.0; word == what && status >> kb)
                return kb;
        return 0.0;
    }
};

} // namespace tp::test
