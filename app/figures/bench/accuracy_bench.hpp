// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/figures/bench/accuracy_scenes.hpp"
#include "core/base/result.hpp"

#include <filesystem>
#include <functional>

namespace tp {

/// What one law over one index took, and how far its force was from the curves' own. The force alone is asked
/// for, as little as a device needs: the exact law over our index answers within the band.
struct AccuracyRow {
    std::string scene;
    /// exact; blended, with_corner_cue (see Continuity); published (Algorithm 1); nearest_vertex, the tent
    /// towards the nearest vertex
    std::string law;
    std::string index;         ///< see NearestMethod::names
    double tolerance_mm = 0.0; ///< largest distance from curve to segment
    double facet_degrees = 0.0;
    std::size_t segments = 0;
    double ns_median = 0.0; ///< per force, hand path of 0.1 mm a sample, processor time
    double mean_error_n = 0.0;
    double p99_error_n = 0.0;
    double max_error_n = 0.0;
    double build_ms = 0.0;
};

struct AccuracyPlan {
    std::vector<double> tolerances_mm{0.3, 0.1, 0.03, 0.01, 0.003, 0.001};
    double truth_mm = 1e-6; ///< tolerance of the curves that the forces are compared with
    int places = 20'000;    ///< at random within the band, for the errors
    int rounds = 15;        ///< batches of questions, of which the median counts
    double batch_ms = 2.0;
    std::size_t most_scanned = 20'000; ///< segments up to which the methods that look at all of them run
};

/// Every law and index on `scene` over the tolerances, and at the usual tolerance with the facet rule.
/// `progress` hears a line now and then. One core.
std::vector<AccuracyRow> run_accuracy_bench(const AccuracyScene& scene, const AccuracyPlan& plan,
                                            const std::function<void(const std::string&)>& progress);

/// accuracy.csv in `folder`, a row a line, columns named as the fields.
Result<std::filesystem::path> write_accuracy_table(const std::filesystem::path& folder,
                                                   const std::vector<AccuracyRow>& rows);
/// accuracy.png and .svg in `folder`: error over time, a panel a scene, a line a method over its
/// tolerances; at the usual tolerance an upright line from the mean to the 99th percentile.
Result<std::filesystem::path> plot_accuracy(const std::filesystem::path& folder,
                                            const std::vector<AccuracyRow>& rows);

} // namespace tp
