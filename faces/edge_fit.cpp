// SPDX-License-Identifier: Apache-2.0
#include "faces/edge_fit.hpp"

#include "core/geometry/polyline.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace tp {
namespace {

constexpr double step_percent = 0.2, reach_percent = 5.0; ///< of the offsets at which an edge is sought
constexpr double smallest_unit_px = 24.0;                 ///< below, a percent is a quarter of a pixel
constexpr double px_per_step = 1.0;  ///< of the picture as it is looked at, where the original has more
constexpr double kernel_reach = 3.5; ///< deviations

/// Outward normals of a line.
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

/// Brightness and redness of the part of a picture round some points, looked up between its pixels.
class Tones {
public:
    Tones(const cv::Mat& picture, Rect around, double most_zoom) {
        const auto clipped = [](double at, int end) {
            return static_cast<int>(std::clamp(std::isfinite(at) ? at : 0.0, 0.0, double(end)));
        };
        const int left = std::min(clipped(std::floor(around.min.x) - 1.0, picture.cols), picture.cols - 1);
        const int top = std::min(clipped(std::floor(around.min.y) - 1.0, picture.rows), picture.rows - 1);
        const int right = std::max(clipped(std::ceil(around.max.x) + 1.0, picture.cols), left + 1);
        const int bottom = std::max(clipped(std::ceil(around.max.y) + 1.0, picture.rows), top + 1);
        const cv::Rect window(left, top, right - left, bottom - top);
        origin_ = Vec2(left, top);
        pixels_ = picture(window);
        if (most_zoom < 1.0) {
            const auto shrunk = [&](int side) {
                return std::max(1, static_cast<int>(std::ceil(side * most_zoom)));
            };
            cv::Mat small;
            cv::resize(pixels_, small, {shrunk(window.width), shrunk(window.height)}, 0, 0, cv::INTER_AREA);
            zoom_ = Vec2(small.cols, small.rows) / Vec2(window.width, window.height);
            pixels_ = small;
        }
    }

    /// {brightness, redness} at a place of the picture; beyond its border those of the border.
    std::array<double, 2> at(Vec2 place) const {
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
    Vec2 origin_{0.0}, zoom_{1.0};
};

/// The filter whose response is the weighted sum of `look`'s slopes and bends: weights of the samples from
/// -reach to +reach steps from a place.
std::vector<double> kernel_of(const ChannelLook& look) {
    const int reach = static_cast<int>(std::ceil(kernel_reach * coarse_percent / step_percent));
    std::vector<double> kernel(static_cast<std::size_t>(2 * reach + 1), 0.0);
    const auto add = [&](double deviation, double slope, double bend) {
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

double mean_gap(const Opening& opening) {
    double sum = 0.0;
    for (std::size_t i = 0; i < opening.lower.size(); ++i)
        sum += length(opening.lower[i] - opening.upper[i]);
    return sum / static_cast<double>(opening.lower.size());
}

Rect grown(Rect rect, double by) { return {rect.min - by, rect.max + by}; }

} // namespace

Evidence edge_evidence(const cv::Mat& picture, const std::vector<Vec2>& line, Vec2 outwards, double unit_px,
                       const EdgeLook& look) {
    const std::array<std::vector<double>, 2> kernels{kernel_of(look.brightness), kernel_of(look.redness)};
    const std::size_t taps = kernels[0].size();
    Evidence evidence;
    evidence.points = line.size();
    evidence.offsets = 2 * static_cast<std::size_t>(std::lround(reach_percent / step_percent)) + 1;
    evidence.step = step_percent;
    evidence.values.assign(evidence.points * evidence.offsets, 0.0);

    const std::size_t samples = evidence.offsets + taps - 1;
    const double step_px = step_percent * unit_px / 100.0;
    const double first = -0.5 * static_cast<double>(samples - 1) * step_px;
    const Tones tones(picture, grown(bounds_of(line), -first), px_per_step / step_px);
    const std::vector<Vec2> normals = normals_of(line, outwards);
    std::array<std::vector<double>, 2> across; // per channel: points × samples
    for (auto& channel : across)
        channel.resize(line.size() * samples);
    for (std::size_t i = 0; i < line.size(); ++i)
        for (std::size_t s = 0; s < samples; ++s) {
            const auto tone = tones.at(line[i] + (first + static_cast<double>(s) * step_px) * normals[i]);
            for (std::size_t c = 0; c < 2; ++c)
                across[c][i * samples + s] = tone[c];
        }

    std::vector<double> profile(samples);
    for (std::size_t i = 1; i + 1 < line.size(); ++i)
        for (std::size_t c = 0; c < 2; ++c) {
            // Lashes and pores cross a line; its neighbours know better.
            const double* here = &across[c][i * samples];
            for (std::size_t s = 0; s < samples; ++s)
                profile[s] = 0.5 * here[s] + 0.25 * (*(here + s - samples) + *(here + s + samples));
            double* values = &evidence.values[i * evidence.offsets];
            for (std::size_t t = 0; t < taps; ++t)
                for (std::size_t k = 0; k < evidence.offsets; ++k)
                    values[k] += kernels[c][t] * profile[k + t];
        }
    return evidence;
}

std::vector<Vec2> on_edge(const cv::Mat& picture, const std::vector<Vec2>& line, Vec2 outwards,
                          double unit_px, const EdgeLook& look, EdgeReport* report) {
    const Evidence evidence = edge_evidence(picture, line, outwards, unit_px, look);
    const std::vector<double> displacement = snapped(evidence, look.stray, look.bend);
    const std::vector<Vec2> normals = normals_of(line, outwards);
    std::vector<Vec2> moved = line;
    double sum = 0.0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        moved[i] += displacement[i] * unit_px / 100.0 * normals[i];
        sum += std::abs(displacement[i]);
    }
    if (report)
        *report = {sum / static_cast<double>(line.size()), clarity(evidence, displacement)};
    return moved;
}

FaceLines on_edges(const cv::Mat& picture, FaceLines lines, EdgeReports* reports) {
    const Vec2 across = lines.left_eye.lower.front() - lines.right_eye.lower.front();
    const double unit_px = length(across);
    EdgeReports found;
    if (unit_px >= smallest_unit_px) {
        const Vec2 down(-across.y, across.x);
        const auto fitted = [&](Opening opening, const EdgeLook& lower, const EdgeLook& upper,
                                EdgeReports::Pair& said) {
            opening.lower = on_edge(picture, opening.lower, down, unit_px, lower, &said.lower);
            opening.upper = on_edge(picture, opening.upper, -down, unit_px, upper, &said.upper);
            opening.lower.front() = opening.upper.front() =
                0.5 * (opening.lower.front() + opening.upper.front());
            opening.lower.back() = opening.upper.back() = 0.5 * (opening.lower.back() + opening.upper.back());
            return opening;
        };
        lines.right_eye = fitted(lines.right_eye, lower_lid, upper_lid, found.right_eye);
        lines.left_eye = fitted(lines.left_eye, lower_lid, upper_lid, found.left_eye);
        lines.outer_lip = fitted(lines.outer_lip, outer_lower_lip, outer_upper_lip, found.outer_lip);
        const double gap = 100.0 * mean_gap(lines.inner_lip) / unit_px;
        Opening inner = lines.inner_lip;
        if (gap < 2.0 * open_percent)
            inner = fitted(lines.inner_lip, shut_lower_lip, shut_upper_lip, found.inner_lip);
        if (gap >= open_percent && 100.0 * mean_gap(inner) / unit_px > one_line_percent)
            inner = fitted(lines.inner_lip, open_lower_lip, open_upper_lip, found.inner_lip);
        lines.inner_lip = std::move(inner);
    }
    if (reports)
        *reports = found;
    return lines;
}

} // namespace tp
