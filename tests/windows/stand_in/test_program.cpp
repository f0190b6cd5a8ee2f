// SPDX-License-Identifier: Apache-2.0
#include "test_program.hpp"

#include <cstdio>

/// Runs the named tests, or all.
int main(int argc, char** argv) {
    int failed = 0;
    for (const auto& [name, run] : tp_stand_in::tests()) {
        bool wanted = argc < 2;
        for (int i = 1; i < argc; ++i)
            wanted = wanted || name == argv[i];
        if (!wanted)
            continue;
        std::printf("Test %s\n", name.c_str());
        failed += run();
    }
    return failed == 0 ? 0 : 1;
}
