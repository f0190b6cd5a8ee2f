// SPDX-License-Identifier: Apache-2.0
// measure_golden_set SHARED_FACES GOLDEN_SET: measures every choice of the golden set on the people held out
// of all training, and keeps the better of the file's figures and these in the file.
// What is worse by more than the margin is told, and then the program ends in 1.
#include "faces/evaluation/golden_set.hpp"

#include <cstdio>
#include <fstream>

using namespace tp;
namespace fs = std::filesystem;

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fputs("measure_golden_set ../shared/faces tests/faces/golden_set.txt\n", stderr);
        return 2;
    }
    const fs::path shared = argv[1], file = argv[2];
    const auto people =
        held_out_portraits(TP_HOLDOUT_LIST, shared / "photos/london_truth.json", shared / "photos");
    auto golden = fs::exists(file) ? read_golden_set(file) : Result<GoldenSet>(GoldenSet{});
    if (!people || !golden) {
        std::fprintf(stderr, "%s\n", (people ? golden.error() : people.error()).c_str());
        return 1;
    }
    bool worse = false;
    for (const auto& [name, choice] : golden_choices()) {
        const auto measured = measured_errors(choice, *people);
        if (!measured) {
            std::fprintf(stderr, "%s\n", measured.error().c_str());
            return 1;
        }
        const GoldenRow row = golden_row(*measured);
        const auto [kept, is_new] = golden->try_emplace(name, row);
        if (!is_new)
            kept->second = better_of(kept->second, row);
        for (const std::string& difference : differences(name, kept->second, *measured)) {
            std::printf("%s\n", difference.c_str());
            worse = true;
        }
    }
    std::ofstream stream(file);
    stream << text_of(*golden) << std::flush;
    if (!stream) {
        std::fprintf(stderr, "The file \"%s\" could not be written.\n", file.c_str());
        return 1;
    }
    return worse ? 1 : 0;
}
