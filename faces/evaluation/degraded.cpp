// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/degraded.hpp"

#include "core/geometry/flatten.hpp"
#include "faces/decode/picture.hpp"
#include "faces/evaluation/contour_error.hpp"

#include <opencv2/imgproc.hpp>
#include <turbojpeg.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

namespace tp {
namespace {

using Map = std::function<Vec2(Vec2)>;

std::string said(const char* what, double how_much, const char* unit) {
    std::string number = std::to_string(std::lround(how_much));
    return std::string(what) + " " + number + unit;
}

/// Every vertex mapped: for truth of straight pieces, placed by hand.
std::vector<Contour> mapped_all(const std::vector<Contour>& truth, const Map& map) {
    std::vector<Contour> result;
    for (const Contour& contour : truth)
        result.push_back(mapped(contour, map));
    return result;
}

Rect extent_of(const std::vector<Contour>& truth, std::string_view name) {
    const Contour* contour = contour_named(truth, name);
    return contour ? bounds_of(flatten(*contour).points) : Rect{};
}

cv::Mat covered(cv::Mat picture, Rect area, double margin, cv::Scalar colour) {
    const auto px = [](double v) { return static_cast<int>(std::lround(v)); };
    cv::Rect box(px(area.min.x - margin), px(area.min.y - margin), px(area.width() + 2 * margin),
                 px(area.height() + 2 * margin));
    box &= cv::Rect(0, 0, picture.cols, picture.rows);
    picture = picture.clone();
    picture(box).setTo(colour);
    return picture;
}

/// Compressed to a JPEG file and read again. Throws std::runtime_error where TurboJPEG has no memory.
cv::Mat through_jpeg(const cv::Mat& picture, int quality) {
    unsigned char* file = nullptr;
    unsigned long size = 0;
    tjhandle handle = tjInitCompress();
    const bool good = handle && tjCompress2(handle, picture.data, picture.cols,
                                            static_cast<int>(picture.step), picture.rows, TJPF_BGR, &file,
                                            &size, TJSAMP_420, quality, TJFLAG_ACCURATEDCT) == 0;
    const Bytes bytes(file, file + (good ? size : 0));
    tjFree(file);
    if (handle)
        tjDestroy(handle);
    const Result<cv::Mat> read = decode_picture(bytes);
    if (!read)
        throw std::runtime_error(read.error());
    return *read;
}

} // namespace

std::vector<Degraded> degraded(const cv::Mat& portrait, const std::vector<Contour>& truth, unsigned seed) {
    const double unit = outer_inter_ocular_distance(truth);
    cv::RNG random(seed + 1);
    std::vector<Degraded> all{{"as it is", portrait, truth}};
    const auto add = [&](std::string how, cv::Mat picture) {
        all.push_back({std::move(how), std::move(picture), truth});
    };
    for (double percent : {1.5, 3.0, 5.0}) {
        cv::Mat soft;
        cv::GaussianBlur(portrait, soft, {}, percent * unit / 100.0);
        add(said("blur", 10 * percent, " ‰"), soft);
    }
    for (double px : {80.0, 40.0, 25.0, 18.0}) {
        cv::Mat small;
        const double scale = px / unit;
        cv::resize(portrait, small, {}, scale, scale, cv::INTER_AREA);
        const Vec2 zoom(static_cast<double>(small.cols) / portrait.cols,
                        static_cast<double>(small.rows) / portrait.rows);
        all.push_back(
            {said("eyes apart", px, " px"), small, mapped_all(truth, [=](Vec2 p) { return p * zoom; })});
    }
    for (double sigma : {20.0, 45.0}) {
        cv::Mat grain(portrait.size(), CV_16SC3), noisy;
        random.fill(grain, cv::RNG::NORMAL, 0.0, sigma);
        cv::add(portrait, grain, noisy, cv::noArray(), CV_8U);
        add(said("noise", sigma, ""), noisy);
    }
    {
        cv::Mat small, blocky;
        cv::resize(portrait, small, {}, 0.4, 0.4, cv::INTER_AREA);
        cv::resize(through_jpeg(small, 8), blocky, portrait.size(), 0, 0, cv::INTER_LINEAR);
        add("jpeg 8", blocky);
    }
    {
        cv::Mat lit = portrait.clone();
        const Rect face = extent_of(truth, feature::outline);
        lit.forEach<cv::Vec3b>([&](cv::Vec3b& p, const int* at) {
            const double t = (at[1] - face.min.x) / std::max(face.width(), 1.0);
            const double light = std::clamp(0.12 + 1.1 * t, 0.08, 1.4);
            for (int c = 0; c < 3; ++c)
                p[c] = cv::saturate_cast<uchar>(light * p[c]);
        });
        add("side light", lit);
    }
    const char* eye = random.uniform(0, 2) ? feature::right_eye : feature::left_eye;
    const cv::Scalar dark(30, 30, 30),
        skin = cv::mean(portrait(cv::Rect(portrait.cols / 2 - 10, portrait.rows / 2, 20, 20)));
    add("eye covered dark", covered(portrait, extent_of(truth, eye), 0.06 * unit, dark));
    add("eye covered like skin", covered(portrait, extent_of(truth, eye), 0.06 * unit, skin));
    add("mouth covered", covered(portrait, extent_of(truth, feature::outer_lip), 0.08 * unit,
                                 random.uniform(0, 2) ? dark : skin));
    {
        Rect half = extent_of(truth, feature::outline);
        (random.uniform(0, 2) ? half.min.x : half.max.x) = half.centre().x;
        add("half covered", covered(portrait, half, 0.1 * unit, cv::Scalar(120, 110, 100)));
    }
    for (double degrees : {20.0, 40.0}) {
        const double angle = (random.uniform(0, 2) ? 1.0 : -1.0) * degrees * std::numbers::pi / 180.0;
        const double c = std::cos(angle), s = std::sin(angle);
        const Vec2 centre = extent_of(truth, feature::outline).centre();
        const Map turn = [=](Vec2 p) {
            const Vec2 d = p - centre;
            return centre + Vec2(c * d.x - s * d.y, s * d.x + c * d.y);
        };
        const Vec2 o = turn(Vec2(0.5)) - 0.5;
        cv::Mat turned;
        cv::warpAffine(portrait, turned, cv::Matx23d(c, -s, o.x, s, c, o.y), portrait.size(),
                       cv::INTER_LINEAR, cv::BORDER_REPLICATE);
        all.push_back({said("rolled", degrees, "°"), turned, mapped_all(truth, turn)});
    }
    for (double depth : {0.25, 0.45, 0.6}) {
        // A cylinder that turns: x becomes sin(asin(x) + yaw), normalised to the face's width.
        const Rect face = extent_of(truth, feature::outline);
        const double radius = 0.62 * face.width(), middle = face.centre().x;
        const double yaw = (random.uniform(0, 2) ? 1.0 : -1.0) * depth;
        const auto seen = [=](double x) {
            const double t = (x - middle) / radius;
            return middle + radius * (std::abs(t) < 0.95
                                          ? std::sin(std::asin(t) + yaw) - std::sin(yaw)
                                          : t + (std::sin(std::asin(std::copysign(0.95, t)) + yaw) -
                                                 std::sin(yaw) - std::copysign(0.95, t)));
        };
        const auto shown =
            [=](double x) { // the inverse, by bisection: seen() rises where the face is visible
                double low = middle - 3.0 * radius, high = middle + 3.0 * radius;
                for (int i = 0; i < 40; ++i) {
                    const double half = 0.5 * (low + high);
                    (seen(half) < x ? low : high) = half;
                }
                return 0.5 * (low + high);
            };
        cv::Mat columns(1, portrait.cols, CV_32F), map_x, map_y(portrait.size(), CV_32F), turned;
        for (int x = 0; x < portrait.cols; ++x)
            columns.at<float>(x) = static_cast<float>(shown(x + 0.5) - 0.5);
        cv::repeat(columns, portrait.rows, 1, map_x);
        for (int y = 0; y < portrait.rows; ++y)
            map_y.row(y).setTo(y);
        cv::remap(portrait, turned, map_x, map_y, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
        all.push_back({said("turned", 100 * depth, " % rad"), turned,
                       mapped_all(truth, [=](Vec2 p) { return Vec2(seen(p.x), p.y); })});
    }
    return all;
}

} // namespace tp
