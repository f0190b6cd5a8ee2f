// SPDX-License-Identifier: Apache-2.0
// How long a person waits for "taken": photograph_bench [FOLDER [TIMES]]. A picture of 12 megapixel with a camera's grain is kept in an
// album in FOLDER (default: a temporary one, which may lie in memory), as JPEG with its sidecar, brought to the disk; one after the
// other.
#include "app/album/keeper/album_keeper.hpp"
#include "app/capture/shutter/photograph_store.hpp"

#include <QTemporaryDir>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <vector>

using namespace tp;

namespace {

/// Soft shapes with grain, about 5 MB as JPEG: what a coder has to do depends on both.
cv::Mat picture(std::uint64_t seed) {
    cv::RNG random(seed);
    cv::Mat shapes(30, 40, CV_8UC3), large, grain(3000, 4000, CV_8SC3);
    random.fill(shapes, cv::RNG::UNIFORM, 30, 220);
    cv::resize(shapes, large, {4000, 3000}, 0.0, 0.0, cv::INTER_CUBIC);
    random.fill(grain, cv::RNG::NORMAL, 0, 5);
    cv::add(large, grain, large, cv::noArray(), CV_8U);
    return large;
}

} // namespace

int main(int argc, char** argv) {
    const QTemporaryDir temporary;
    const std::filesystem::path album =
        argc > 1 ? std::filesystem::path(argv[1]) : std::filesystem::path(temporary.path().toStdString());
    const int times = std::max(2, argc > 2 ? std::atoi(argv[2]) : 40);
    AlbumKeeper keeper(album);
    PhotographStore store(keeper, album);
    std::vector<double> took;
    double bytes = 0.0;
    std::clock_t processor = 0;
    for (int i = 0; i < times; ++i) {
        const cv::Mat taken = picture(static_cast<std::uint64_t>(i) + 1);
        PhotographFacts facts;
        facts.taken = QDateTime::currentDateTime();
        const std::clock_t processor_begin = std::clock();
        const auto begin = std::chrono::steady_clock::now();
        const auto kept = store.keep(taken, facts, {{0.5, 0.5, 0.2, 0.2, "Anna"}});
        took.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
        processor += std::clock() - processor_begin;
        if (!kept || !kept->warning.empty()) {
            std::fprintf(stderr, "%s\n", (kept ? kept->warning : kept.error()).c_str());
            return 1;
        }
        bytes += static_cast<double>(std::filesystem::file_size(kept->photo));
    }
    const double processor_ms = 1e3 * static_cast<double>(processor) / CLOCKS_PER_SEC / times;
    std::sort(took.begin(), took.end());
    const auto share = [&took](double of_all) {
        return took[static_cast<std::size_t>(of_all * static_cast<double>(took.size() - 1))];
    };
    std::printf("ms until it is kept, %d times %.1f MB: p50 %.0f, p95 %.0f, most %.0f; processor %.0f\n",
                times, bytes / times / 1e6, share(0.5), share(0.95), took.back(), processor_ms);
}
