// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/cover_lessons.hpp"

#include "faces/edge_fit.hpp"
#include "faces/evaluation/located_face.hpp"

#include <cmath>
#include <cstdio>

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

std::optional<Sight> sight_of(EmbeddedDetector& detector, ContourNets& nets, const cv::Mat& picture) {
    const auto points = located(nets, picture, surest_first(detector, picture));
    if (!points)
        return std::nullopt;
    EdgeReports edges;
    on_edges(picture, lines_through(*points), &edges);
    return Sight{*points, signs_of(*points, edges, picture)};
}

cv::Mat1d fitted_places(const cv::Mat1d& guides, const cv::Mat1d& y, double ridge) {
    cv::Mat1d x = guides.clone(), mean; // as a parameter it would share the caller's numbers
    cv::reduce(x, mean, 0, cv::REDUCE_AVG);
    for (int c = 1; c < x.cols; ++c)
        x.col(c) -= mean(c);
    const cv::Mat1d deviation = scale_columns(x);
    cv::Mat1d normal(x.t() * x), weights;
    for (int c = 1; c < x.cols; ++c)
        normal(c, c) += ridge * x.rows;
    cv::solve(normal, x.t() * y, weights, cv::DECOMP_CHOLESKY);
    for (int c = 1; c < x.cols; ++c) {
        weights.row(c) /= deviation(c);
        weights.row(0) -= mean(c) * weights.row(c);
    }
    return weights;
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

void print_row(const cv::Mat1d& values) {
    std::printf("{");
    for (int i = 0; i < static_cast<int>(values.total()); ++i)
        std::printf("%s%.4f", i ? ", " : "", values(i));
    std::printf("}");
}

} // namespace tp
