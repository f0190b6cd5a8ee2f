// SPDX-License-Identifier: Apache-2.0
#include "faces/edges/edge_profile.hpp"

#include "core/geometry/polyline.hpp"
#include "faces/base/block_means.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

constexpr double step_percent = 0.2, reach_percent = 5.0; ///< of the offsets at which an edge is sought
constexpr double px_per_step = 1.0;  ///< at least, of the picture as it is looked at, where it has as many
/// Pixels as they are looked at; less is nothing, more no face.
constexpr double least_grain = 0.3, most_grain = 50.0;
constexpr double kernel_reach = 3.5; ///< deviations
constexpr int filter_reach = static_cast<int>(kernel_reach * coarse_percent / step_percent) + 1; ///< steps
constexpr std::size_t taps = 2 * static_cast<std::size_t>(filter_reach) + 1;
constexpr std::size_t offset_count = 2 * static_cast<std::size_t>(reach_percent / step_percent + 0.5) + 1;
constexpr std::size_t sample_count = offset_count + taps - 1;

/// Brightness and redness of the part of a picture round some points, looked up between its pixels.
class Tones {
public:
    /// Where it will be looked up at places `px_apart`, in larger pixels: means of blocks. `grain_px` is the
    /// deviation of a Gaussian that takes grain away.
    Tones(const cv::Mat& picture, Rect around, double px_apart, double grain_px) {
        const auto clipped = [](double at, int end) {
            return static_cast<int>(std::clamp(std::isfinite(at) ? at : 0.0, 0.0, double(end)));
        };
        const int left = std::min(clipped(std::floor(around.min.x) - 1.0, picture.cols), picture.cols - 1);
        const int top = std::min(clipped(std::floor(around.min.y) - 1.0, picture.rows), picture.rows - 1);
        const int right = std::max(clipped(std::ceil(around.max.x) + 1.0, picture.cols), left + 1);
        const int bottom = std::max(clipped(std::ceil(around.max.y) + 1.0, picture.rows), top + 1);
        const cv::Rect window(left, top, right - left, bottom - top);
        origin_ = Vec2(left, top);
        const double blocks = std::isfinite(px_apart) ? px_apart / px_per_step : 1.0;
        const int by =
            static_cast<int>(std::clamp(blocks, 1.0, double(std::min(window.width, window.height))));
        pixels_ = block_means(picture(window), by);
        zoom_ = 1.0 / by;
        if (const double deviation = grain_px * zoom_; deviation > least_grain && deviation < most_grain) {
            cv::Mat smooth; // of its own: the pixels may be the picture's
            cv::GaussianBlur(pixels_, smooth, {}, deviation);
            pixels_ = smooth;
        }
    }

    /// {brightness, redness} at a place of the picture; beyond its border those of the border.
    std::array<double, edge_channels> at(Vec2 place) const {
        const Vec2 last(pixels_.cols - 1, pixels_.rows - 1);
        const Vec2 p = glm::clamp((place - origin_) * zoom_ - 0.5, Vec2(0.0), last);
        const int x = static_cast<int>(p.x), y = static_cast<int>(p.y);
        const int across = x + 1 < pixels_.cols ? 3 : 0;
        const uchar* row = pixels_.ptr<uchar>(y) + 3 * x;
        const uchar* below = pixels_.ptr<uchar>(std::min(y + 1, pixels_.rows - 1)) + 3 * x;
        const double u = p.x - x, v = p.y - y;
        std::array<double, 3> bgr;
        for (std::size_t c = 0; c < 3; ++c)
            bgr[c] = (1.0 - v) * ((1.0 - u) * row[c] + u * row[static_cast<std::size_t>(across) + c]) +
                     v * ((1.0 - u) * below[c] + u * below[static_cast<std::size_t>(across) + c]);
        const double grey = 0.114 * bgr[0] + 0.587 * bgr[1] + 0.299 * bgr[2];
        return {std::log(grey + darkest), std::log((bgr[2] + darkest) / (bgr[1] + darkest))};
    }

private:
    cv::Mat pixels_;
    Vec2 origin_{0.0};
    double zoom_ = 1.0;
};

/// The filter whose response is the weighted sum of `look`'s slopes and bends: weights of the samples from
/// -reach to +reach steps from a place.
std::vector<double> kernel_of(const ChannelLook& look) {
    constexpr int reach = filter_reach;
    std::vector<double> kernel(taps, 0.0);
    const auto add = [&kernel](double deviation, double slope, double bend) {
        double sum = 0.0;
        for (int k = -reach; k <= reach; ++k)
            sum += std::exp(-0.5 * std::pow(k * step_percent / deviation, 2));
        for (int k = -reach; k <= reach; ++k) {
            const double t = k * step_percent / deviation;
            kernel[static_cast<std::size_t>(k + reach)] +=
                std::exp(-0.5 * t * t) / sum * (slope * t + bend * (t * t - 1.0));
        }
    };
    add(fine_percent, look.fine_slope, look.fine_bend);
    add(coarse_percent, look.coarse_slope, look.coarse_bend);
    return kernel;
}

Rect grown(Rect rect, double by) { return {rect.min - by, rect.max + by}; }

} // namespace

std::vector<Vec2> normals_of(const std::vector<Vec2>& line, Vec2 outwards) {
    std::vector<Vec2> normals(line.size());
    Vec2 sum(0.0);
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Vec2 along = line[std::min(i + 1, line.size() - 1)] - line[i == 0 ? 0 : i - 1];
        const double size = length(along);
        normals[i] = size > 0.0 ? Vec2(-along.y, along.x) / size : Vec2(0.0);
        sum += normals[i];
    }
    if (glm::dot(sum, outwards) < 0.0)
        for (Vec2& n : normals)
            n = -n;
    return normals;
}

EdgeProfile edge_profile(const cv::Mat& picture, const std::vector<Vec2>& line, Vec2 outwards,
                         double unit_px, double grain_percent) {
    const double step_px = step_percent * unit_px / 100.0;
    const double first = -0.5 * static_cast<double>(sample_count - 1) * step_px;
    const Tones tones(picture, grown(bounds_of(line), -first), step_px, grain_percent * unit_px / 100.0);
    const std::vector<Vec2> normals = normals_of(line, outwards);
    std::array<std::vector<double>, edge_channels> across;
    for (auto& channel : across)
        channel.resize(line.size() * sample_count);
    for (std::size_t i = 0; i < line.size(); ++i)
        for (std::size_t s = 0; s < sample_count; ++s) {
            const auto tone = tones.at(line[i] + (first + static_cast<double>(s) * step_px) * normals[i]);
            for (std::size_t c = 0; c < edge_channels; ++c)
                across[c][i * sample_count + s] = tone[c];
        }
    EdgeProfile profile;
    profile.points = line.size();
    for (std::size_t c = 0; c < edge_channels; ++c) {
        profile.channels[c].resize(across[c].size());
        // Lashes and pores cross a line; its neighbours know better.
        for (std::size_t i = sample_count; i + sample_count < across[c].size(); ++i)
            profile.channels[c][i] =
                0.5 * across[c][i] + 0.25 * (across[c][i - sample_count] + across[c][i + sample_count]);
    }
    return profile;
}

Evidence evidence_in(const EdgeProfile& profile, const EdgeLook& look) {
    const std::array<std::vector<double>, edge_channels> kernels{kernel_of(look.brightness),
                                                                 kernel_of(look.redness)};
    Evidence evidence;
    evidence.points = profile.points;
    evidence.offsets = offset_count;
    evidence.step = step_percent;
    evidence.values.assign(evidence.points * evidence.offsets, 0.0);
    for (std::size_t i = 1; i + 1 < evidence.points; ++i)
        for (std::size_t c = 0; c < edge_channels; ++c) {
            const double* here = &profile.channels[c][i * sample_count];
            double* values = &evidence.values[i * evidence.offsets];
            for (std::size_t t = 0; t < taps; ++t)
                for (std::size_t k = 0; k < evidence.offsets; ++k)
                    values[k] += kernels[c][t] * here[k + t];
        }
    return evidence;
}
} // namespace tp
