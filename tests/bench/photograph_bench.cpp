// SPDX-License-Identifier: Apache-2.0
// How long a person waits for "taken": photograph_bench [FOLDER [TIMES]]. Of a burst of eight frames of 12 megapixel with a face and
// a camera's grain the best is chosen, kept in an album in FOLDER (default: a temporary one, which may lie in memory) as JPEG with
// its sidecar, brought to the disk, looked at and put into words, as after the shutter; one burst after the other.
#include "app/album/keeper/album_keeper.hpp"
#include "app/capture/shutter/burst.hpp"
#include "app/capture/shutter/photograph_store.hpp"
#include "app/capture/shutter/taken_look.hpp"
#include "app/photo/words/description.hpp"
#include "faces/decode/picture.hpp"
#include "faces/extract/quick_faces.hpp"

#include <QTemporaryDir>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <sys/resource.h>
#include <vector>

using namespace tp;

namespace {

/// A drawn portrait, as large as a camera's picture, with grain, about 3 MB as JPEG: what a coder has to do depends on both.
std::vector<CameraFrame> burst_of(const cv::Mat& portrait, std::uint64_t seed) {
    cv::RNG random(seed);
    std::vector<CameraFrame> frames;
    for (std::size_t i = 0; i < Burst::most_frames; ++i) {
        cv::Mat grain(portrait.size(), CV_8SC3), pixels;
        random.fill(grain, cv::RNG::NORMAL, 0, 5);
        cv::add(portrait, grain, pixels, cv::noArray(), CV_8U);
        frames.push_back({pixels, 0.1 * static_cast<double>(i), {}, {}});
    }
    return frames;
}

double now_ms() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

void print(const char* what, std::vector<double> ms) {
    std::sort(ms.begin(), ms.end());
    const auto share = [&ms](double of_all) {
        return ms[static_cast<std::size_t>(of_all * static_cast<double>(ms.size() - 1))];
    };
    std::printf("%s, ms: p50 %.0f, p95 %.0f, most %.0f\n", what, share(0.5), share(0.95), ms.back());
}

} // namespace

int main(int argc, char** argv) {
    const QTemporaryDir temporary;
    const std::filesystem::path album =
        argc > 1 ? std::filesystem::path(argv[1]) : std::filesystem::path(temporary.path().toStdString());
    const int times = std::max(2, argc > 2 ? std::atoi(argv[2]) : 40);
    const auto portrait = read_picture(TOUCHPHOTO_SOURCE "/resources/samples/anna_smiling.jpg");
    if (!portrait) {
        std::fprintf(stderr, "%s\n", portrait.error().c_str());
        return 1;
    }
    cv::Mat upright, large;
    cv::resize(*portrait, upright, {2250, 3000}, 0.0, 0.0, cv::INTER_CUBIC);
    cv::copyMakeBorder(upright, large, 0, 0, 875, 875, cv::BORDER_REPLICATE);
    AlbumKeeper keeper(album);
    PhotographStore store(keeper, album);
    QuickFaces faces;
    TakenLook look;
    enum Part { chosen, kept, told, all, parts };
    std::array<std::vector<double>, parts> took;
    double bytes = 0.0;
    std::clock_t processor = 0;
    for (int i = 0; i <= times; ++i) {
        const Burst burst(burst_of(large, static_cast<std::uint64_t>(i) + 1), {}, 0.7);
        PhotographFacts facts;
        facts.taken = QDateTime::currentDateTime();
        const std::clock_t processor_begin = std::clock();
        std::array<double, parts> at{now_ms()};
        const cv::Mat best = burst.picture(burst.choose(faces).frames.front());
        at[1] = now_ms();
        const auto photograph = store.keep(best, facts, {{0.5, 0.5, 0.2, 0.2, "Anna"}});
        at[2] = now_ms();
        const QString words = taken_words(taken_view(look.see(best), QLocale::English), QLocale::English);
        at[3] = now_ms();
        if (!photograph || !photograph->warning.empty() || !words.startsWith("Taken: one person")) {
            std::fprintf(stderr, "%s %s\n", (photograph ? photograph->warning : photograph.error()).c_str(),
                         qPrintable(words));
            return 1;
        }
        if (i == 0) // the nets are loaded
            continue;
        for (const Part part : {chosen, kept, told})
            took[part].push_back(at[part + 1U] - at[part]);
        took[all].push_back(at[3] - at[0]);
        processor += std::clock() - processor_begin;
        bytes += static_cast<double>(std::filesystem::file_size(photograph->photo));
    }
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    std::printf("%d bursts, %.1f MB a photograph, processor %.0f ms, most memory %ld MB\n", times,
                bytes / times / 1e6, 1e3 * static_cast<double>(processor) / CLOCKS_PER_SEC / times,
                used.ru_maxrss / 1000);
    print("the best of eight chosen", took[chosen]);
    print("kept, on the disk", took[kept]);
    print("looked at, in words", took[told]);
    print("from the shutter until \"taken\" is said", took[all]);
}
