// SPDX-License-Identifier: Apache-2.0
// calibrate_quality TRUTH.json PHOTOS MESH.onnx: prints the weights of faces/quality.cpp, fitted to the
// errors of the embedded nets and of the face mesh on every second portrait (the first, the third, …) as it
// is and degraded.
#include "faces/contour_nets.hpp"
#include "faces/embedded_detector.hpp"
#include "faces/evaluation/contour_error.hpp"
#include "faces/evaluation/degraded.hpp"
#include "faces/evaluation/located_face.hpp"
#include "faces/evaluation/placed_truth.hpp"
#include "faces/mesh_model.hpp"
#include "faces/picture.hpp"
#include "faces/quality.hpp"
#include "faces/quiet_opencv.hpp"

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
        cv::Mat1d weighted = x.clone();
        for (int r = 0; r < x.rows; ++r)
            weighted.row(r) *= weight(r);
        cv::Mat1d normal(x.t() * weighted);
        for (int c = 1; c < count; ++c)
            normal(c, c) += ridge;
        cv::solve(normal, weighted.t() * y, b, cv::DECOMP_CHOLESKY);
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
    if (argc != 4) {
        std::fputs("calibrate_quality TRUTH.json PHOTOS MESH.onnx > faces/quality_weights.inc\n", stderr);
        return 2;
    }
    quiet_opencv();
    const auto people = read_placed_truth(argv[1], argv[2]);
    auto mesh = MeshModel::load(argv[3]);
    if (!people.ok() || !mesh.ok()) {
        std::fprintf(stderr, "%s\n", (people.ok() ? mesh.error() : people.error()).c_str());
        return 1;
    }
    EmbeddedDetector detector;
    ContourNets nets;
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
            for (LandmarkModel* model : {static_cast<LandmarkModel*>(&nets), mesh->get()}) {
                const auto points = located(*model, harder.picture, places);
                if (!points)
                    continue;
                EdgeReports edges;
                const auto contours = contours_of(on_edges(harder.picture, lines_through(*points), &edges));
                const QualitySigns signs = signs_of(*points, edges, harder.picture);
                for (std::size_t f = 0; f < feature_count; ++f) {
                    if (is_guessed(signs, static_cast<FeatureIndex>(f)))
                        continue; // its error is that of guesses
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
