// SPDX-License-Identifier: Apache-2.0
// What it costs to decode in another process: decoder_bench PHOTOGRAPH…. Each is decoded in this process and in
// touchphoto-decoder, by turns, as the search for faces reads it, to fit a screen, whole, and what it says of itself; the
// medians, in milliseconds of the clock on the wall.
#include "core/processes/foreign_decoder.hpp"
#include "core/processes/our_programs.hpp"
#include "faces/decode/picture.hpp"
#include "faces/exiv2/stated_metadata.hpp"

#include <opencv2/core.hpp>

#include <algorithm>
#include <array>
#include <benchmark/benchmark.h>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

using namespace tp;
namespace fs = std::filesystem;

namespace {

constexpr int turns = 25;
constexpr int searched_px = 1600; ///< as FaceExtractor asks for
const cv::Size screen{1920, 1080};

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + turns / 2, values.end());
    return values[turns / 2];
}

double ms_of(const std::function<void()>& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

/// Every pixel is looked at, as whoever asked for it does.
void look_at(const cv::Mat& picture) { benchmark::DoNotOptimize(cv::sum(picture)); }

void compare(const char* what, const fs::path& file, const std::function<void()>& work, ForeignDecoders& decoders) {
    std::vector<double> here, there;
    for (int i = 0; i < turns; ++i) {
        decode_in_helpers(nullptr);
        here.push_back(ms_of(work));
        decode_in_helpers(&decoders);
        there.push_back(ms_of(work));
    }
    const double first = median(here), second = median(there);
    std::printf("%-28s %-8s %9.2f %9.2f %+8.2f %7.2f\n", file.filename().c_str(), what, first, second,
                second - first, second / first);
}

} // namespace

int main(int count, char** words) {
    // As from the build's folder of tests.
    ForeignDecoders decoders(fs::weakly_canonical(beside_this_program("../../bin/touchphoto-decoder")));
    std::printf("%-28s %-8s %9s %9s %8s %7s\n", "photograph", "read", "here", "decoder", "more", "ratio");
    for (int i = 1; i < count; ++i) {
        const fs::path file = words[i];
        decode_in_helpers(&decoders);
        double start = 0.0;
        std::string problem;
        start = ms_of([&] { problem = read_picture(file).error(); }); // starts it, for the first of its kind
        if (!problem.empty()) {
            std::printf("%s: %s\n", file.filename().c_str(), problem.c_str());
            continue;
        }
        compare("shrunk", file, [&] { look_at(read_picture_shrunk(file, searched_px)->pixels); }, decoders);
        compare(
            "to fit", file, [&] { look_at(*read_picture_to_fit(file, screen)); }, decoders);
        compare("whole", file, [&] { look_at(*read_picture(file)); }, decoders);
        compare(
            "metadata", file, [&] { benchmark::DoNotOptimize(stated_metadata(OpenFile(file, OpenMode{}))); },
            decoders);
        std::printf("%-28s %-8s %29.1f\n", file.filename().c_str(), "first", start);
    }
}
