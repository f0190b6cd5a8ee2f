// SPDX-License-Identifier: Apache-2.0
// How long a person waits for the next photograph: next_photo_bench [FOLDER]. Twenty-four JPEGs of 12 megapixel are made
// in FOLDER (default: a temporary one) and shown at 1080p one after the other, with reading ahead and without, at
// several paces. The time is that from the wish to the picture in memory, ready to be drawn.
#include "app/photo/picture/picture_ahead.hpp"

#include <QCoreApplication>
#include <QEventLoop>
#include <QTemporaryDir>
#include <QTimer>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

using namespace tp;
namespace fs = std::filesystem;

namespace {

constexpr int photos = 24, width_px = 4000, height_px = 3000;
constexpr std::size_t ahead_count = 3;

/// Soft shapes with the grain of a camera, about 5 MB at quality 92: what a decoder has to do depends on both.
void write_photo(const fs::path& file, int number) {
    cv::RNG random(static_cast<std::uint64_t>(number) + 1);
    cv::Mat shapes(height_px / 100, width_px / 100, CV_8UC3), picture, grain(height_px, width_px, CV_8SC3);
    random.fill(shapes, cv::RNG::UNIFORM, 30, 220);
    cv::resize(shapes, picture, {width_px, height_px}, 0, 0, cv::INTER_CUBIC);
    random.fill(grain, cv::RNG::NORMAL, 0, 5);
    cv::add(picture, grain, picture, cv::noArray(), CV_8U);
    cv::imwrite(file.string(), picture, {cv::IMWRITE_JPEG_QUALITY, 92});
}

std::vector<fs::path> photographs(const fs::path& folder) {
    std::vector<fs::path> files;
    fs::create_directories(folder);
    for (int i = 0; i < photos; ++i) {
        files.push_back(folder / ("next_" + std::to_string(i) + ".jpg"));
        if (!fs::exists(files.back()))
            write_photo(files.back(), i);
    }
    return files;
}

void pass(int ms) {
    QEventLoop loop;
    QTimer::singleShot(ms, &loop, &QEventLoop::quit);
    loop.exec();
}

/// Milliseconds of waiting for each photograph but the first.
std::vector<double> waits(const std::vector<fs::path>& files, std::size_t next, int pace_ms) {
    PictureAhead ahead(QSize(1920, 1080));
    std::vector<double> result;
    for (std::size_t i = 0; i < files.size(); ++i) {
        QEventLoop loop;
        bool there = false;
        const auto connection = QObject::connect(&ahead, &PictureAhead::ready, [&](const auto& picture) {
            if (picture->image.isNull())
                std::exit(1);
            there = true;
            loop.quit();
        });
        const auto after = files.begin() + static_cast<std::ptrdiff_t>(i) + 1;
        const auto begin = std::chrono::steady_clock::now();
        ahead.show(files[i], {after, after + std::min<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(next), files.end() - after)});
        if (!there)
            loop.exec();
        if (i > 0)
            result.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
        QObject::disconnect(connection);
        pass(pace_ms);
    }
    std::sort(result.begin(), result.end());
    return result;
}

double share(const std::vector<double>& sorted, double of_all) {
    return sorted[static_cast<std::size_t>(of_all * static_cast<double>(sorted.size() - 1))];
}

} // namespace

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    const QTemporaryDir temporary;
    const auto files = photographs(argc > 1 ? fs::path(argv[1]) : fs::path(temporary.path().toStdString()));
    std::printf("%-34s%10s%10s%10s%10s%10s%10s%12s\n", "ms until the next photograph", "p50", "p95", "max", "alone p50",
                "p95", "max", "p95 ratio");
    for (const int pace_ms : {0, 100, 300, 1000}) {
        const auto with = waits(files, ahead_count, pace_ms), alone = waits(files, 0, pace_ms);
        std::printf("%-34s", ("after " + std::to_string(pace_ms) + " ms").c_str());
        for (const auto& one : {with, alone})
            std::printf("%10.1f%10.1f%10.1f", share(one, 0.5), share(one, 0.95), one.back());
        std::printf("%12.2f\n", share(with, 0.95) / share(alone, 0.95));
    }
}
