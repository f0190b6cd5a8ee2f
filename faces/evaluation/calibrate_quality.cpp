// SPDX-License-Identifier: Apache-2.0
// calibrate_quality TRUTH.json PHOTOS: prints the weights of faces/judge/quality.cpp, fitted to the errors of
// our nets, of what comes of theirs and the face mesh's opinion, and of the mesh, on every second portrait of
// people whom no training saw, as it is and degraded.
#include "faces/contours/contour_nets.hpp"
#include "faces/contours/mesh_model.hpp"
#include "faces/contours/second_opinion.hpp"
#include "faces/decode/picture.hpp"
#include "faces/decode/quiet_opencv.hpp"
#include "faces/detect/embedded_detector.hpp"
#include "faces/evaluation/contour_error.hpp"
#include "faces/evaluation/degraded.hpp"
#include "faces/evaluation/located_face.hpp"
#include "faces/evaluation/placed_truth.hpp"
#include "faces/judge/covered.hpp"
#include "faces/judge/quality.hpp"
#include "faces/models/model_catalog.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace tp;

namespace {

constexpr const char* names[] = {feature::right_eye, feature::left_eye, feature::outer_lip,
                                 feature::inner_lip, feature::outline}; // as FeatureIndex
constexpr double error_floor_percent = 0.05;                            ///< as in quality.cpp
constexpr double ridge = 3.0;   ///< in units of predictors divided by their deviation
constexpr double outlier = 0.7; ///< of ln error, from which a sample weighs less (Huber)
constexpr int rounds = 15;

using Predictors = std::array<double, predictor_count>;
struct Sample {
    Predictors predictors;
    double log_error = 0.0;
};

/// Whatever chance says, models that differ more, or are less confident, mean no smaller error: the sign that
/// the weight of such a predictor must not have; 0: it may have any.
int forbidden_sign(int predictor) {
    constexpr int confidence = 10, between_models = static_cast<int>(predictor_count) - 1;
    if (predictor == confidence)
        return 1;
    return (predictor >= 1 && predictor <= 3) || predictor == between_models ? -1 : 0;
}

/// Ridge regression with weighted rows; predictors with a forbidden sign are left out, the worst first.
cv::Mat1d solved(const cv::Mat1d& x, const cv::Mat1d& y, const cv::Mat1d& weight) {
    cv::Mat1d weighted = x.clone();
    for (int r = 0; r < x.rows; ++r)
        weighted.row(r) *= weight(r);
    cv::Mat1d normal(x.t() * weighted), right(weighted.t() * y), b;
    for (int c = 1; c < x.cols; ++c)
        normal(c, c) += ridge;
    while (true) {
        cv::solve(normal, right, b, cv::DECOMP_CHOLESKY);
        int worst = -1;
        for (int c = 1; c < x.cols; ++c)
            if (b(c) * forbidden_sign(c) > 1e-9 && (worst < 0 || std::abs(b(c)) > std::abs(b(worst))))
                worst = c;
        if (worst < 0)
            return b;
        normal.row(worst) = 0.0;
        normal.col(worst) = 0.0;
        normal(worst, worst) = 1.0;
        right(worst) = 0.0;
    }
}

/// Robust ridge regression of ln error on the predictors (iteratively reweighted least squares).
Predictors fitted(const std::vector<Sample>& samples) {
    constexpr int count = static_cast<int>(predictor_count);
    cv::Mat1d x(static_cast<int>(samples.size()), count), y(x.rows, 1), weight(x.rows, 1, 1.0);
    for (int r = 0; r < x.rows; ++r) {
        for (int c = 0; c < count; ++c)
            x(r, c) = samples[static_cast<std::size_t>(r)].predictors[static_cast<std::size_t>(c)];
        y(r) = samples[static_cast<std::size_t>(r)].log_error;
    }
    cv::Mat1d mean(1, count, 0.0), deviation(1, count, 1.0);
    for (int c = 1; c < count; ++c) {
        cv::Scalar m, d;
        cv::meanStdDev(x.col(c), m, d);
        mean(c) = m[0];
        deviation(c) = d[0] + 1e-9;
        x.col(c) = (x.col(c) - m[0]) / deviation(c);
    }
    cv::Mat1d b;
    for (int round = 0; round < rounds; ++round) {
        b = solved(x, y, weight);
        const cv::Mat1d rest(y - x * b);
        for (int r = 0; r < x.rows; ++r)
            weight(r) = 1.0 / std::max(1.0, std::abs(rest(r)) / outlier);
    }
    Predictors result{};
    result[0] = b(0);
    for (int c = 1; c < count; ++c) {
        result[static_cast<std::size_t>(c)] = b(c) / deviation(c);
        result[0] -= b(c) * mean(c) / deviation(c);
    }
    return result;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fputs("calibrate_quality TRUTH.json PHOTOS > faces/judge/quality_weights.inc\n", stderr);
        return 2;
    }
    quiet_opencv();
    const auto people = read_placed_truth(argv[1], argv[2]);
    if (!people.ok()) {
        std::fprintf(stderr, "%s\n", people.error().c_str());
        return 1;
    }
    EmbeddedDetector detector;
    ContourNets nets;
    MeshModel mesh(embedded_net(EmbeddedModel::mesh));
    SecondOpinion second(nets);
    std::array<std::vector<Sample>, feature_count> samples;
    // Of the people whom no training saw (every second, faces/training/holdout.txt) every second one; the
    // test takes the others. On faces that the nets were trained on they err less than they will.
    for (std::size_t i = 3; i < people->size(); i += 4) {
        const auto portrait = read_picture((*people)[i].photo);
        if (!portrait) {
            std::fprintf(stderr, "%s: %s\n", (*people)[i].photo.c_str(), portrait.error().c_str());
            return 1;
        }
        for (const Degraded& harder : degraded(*portrait, (*people)[i].truth, static_cast<unsigned>(i))) {
            const auto places = surest_first(detector, harder.picture);
            const auto ours = located(nets, harder.picture, places);
            std::optional<Landmarks> both;
            if (auto opinions = places.empty()
                                    ? std::nullopt
                                    : second.about(harder.picture, places.front(), ours ? &*ours : nullptr))
                both = std::move(opinions->settled);
            for (const auto& points : {ours, both, located(mesh, harder.picture, places)}) {
                if (!points)
                    continue;
                EdgeReports edges;
                const auto contours = contours_of(on_edges(harder.picture, lines_through(*points), &edges));
                const QualitySigns signs = signs_of(*points, edges, harder.picture);
                for (std::size_t f = 0; f < feature_count; ++f) {
                    if (is_covered(signs, static_cast<FeatureIndex>(f)))
                        continue; // its error is that of what is covered
                    if (const auto error = contour_error_percent(harder.truth, contours, names[f]))
                        samples[f].push_back({predictors(signs, static_cast<FeatureIndex>(f)),
                                              std::log(*error + error_floor_percent)});
                }
            }
        }
    }
    // Both eyes are alike.
    auto& eyes = samples[at_right_eye];
    eyes.insert(eyes.end(), samples[at_left_eye].begin(), samples[at_left_eye].end());
    samples[at_left_eye] = eyes;
    std::puts("// SPDX-License-Identifier: Apache-2.0");
    for (std::size_t f = 0; f < feature_count; ++f) {
        std::printf("    {");
        const Predictors weights = fitted(samples[f]);
        for (std::size_t c = 0; c < predictor_count; ++c)
            std::printf("%s%.3f", c ? ", " : "", weights[c]);
        std::printf("}, // %s, %zu samples\n", names[f], samples[f].size());
    }
    return 0;
}
