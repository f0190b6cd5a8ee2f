// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/cover_lessons.hpp"

#include "faces/edges/edge_fit.hpp"
#include "faces/evaluation/located_face.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace tp {
namespace {

constexpr double cover_ridge = 0.002; ///< of signs divided by their deviation
constexpr int newton_steps = 30;

/// Each column but the first by its deviation; the deviations.
cv::Mat1d scale_columns(cv::Mat1d& x) {
    cv::Mat1d deviation(1, x.cols, 1.0);
    for (int c = 1; c < x.cols; ++c) {
        cv::Scalar m, d;
        cv::meanStdDev(x.col(c), m, d);
        deviation(c) = d[0] + 1e-9;
        x.col(c) /= deviation(c);
    }
    return deviation;
}

} // namespace

std::optional<Sight> sight_of(Eyewitness& eyewitness, const cv::Mat& picture) {
    for (const Detection& place : surest_first(eyewitness.detector, picture)) {
        const auto ours = located(eyewitness.nets, picture, {place});
        auto opinions = eyewitness.second.about(picture, place, ours ? &*ours : nullptr);
        if (!opinions)
            continue;
        EdgeReports edges;
        on_edges(picture, lines_through(opinions->settled), &edges);
        const QualitySigns signs = signs_of(opinions->settled, edges, picture);
        return Sight{std::move(*opinions), signs};
    }
    return std::nullopt;
}

cv::Mat1d fitted_cover(const cv::Mat1d& signs, const cv::Mat1d& y, double prior) {
    cv::Mat1d x = signs.clone();
    const cv::Mat1d deviation = scale_columns(x);
    const double seen = y.rows - cv::sum(y)[0], weight_of_covered = prior * seen / cv::sum(y)[0];
    cv::Mat1d b(x.cols, 1, 0.0), step;
    for (int round = 0; round < newton_steps; ++round) {
        const cv::Mat1d z(x * b);
        cv::Mat1d slope(x.rows, 1), bent = x.clone();
        for (int r = 0; r < x.rows; ++r) {
            const double weight = y(r) > 0.5 ? weight_of_covered : 1.0, p = 1.0 / (1.0 + std::exp(-z(r)));
            slope(r) = weight * (y(r) - p);
            bent.row(r) *= weight * p * (1.0 - p);
        }
        cv::Mat1d normal(x.t() * bent), gradient(x.t() * slope);
        for (int c = 0; c < x.cols; ++c) {
            normal(c, c) += cover_ridge * x.rows;
            gradient(c) -= c > 0 ? cover_ridge * x.rows * b(c) : 0.0;
        }
        cv::solve(normal, gradient, step, cv::DECOMP_CHOLESKY);
        b += step;
    }
    for (int c = 1; c < x.cols; ++c)
        b(c) /= deviation(c);
    return b;
}

double threshold_for(const cv::Mat1d& signs, const cv::Mat1d& y, const cv::Mat1d& weights, double share) {
    std::vector<double> evidence;
    for (int r = 0; r < signs.rows; ++r)
        if (y(r) < 0.5)
            evidence.push_back(signs.row(r).dot(weights.t()));
    std::ranges::sort(evidence);
    return evidence.empty()
               ? 0.0
               : evidence[static_cast<std::size_t>((1.0 - share) * static_cast<double>(evidence.size() - 1))];
}

void print_row(const cv::Mat1d& values) {
    std::printf("{");
    for (int i = 0; i < static_cast<int>(values.total()); ++i)
        std::printf("%s%.4f", i ? ", " : "", values(i));
    std::printf("}");
}

} // namespace tp
