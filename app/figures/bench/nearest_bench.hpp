// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/figures/bench/bench_scene.hpp"

#include <functional>
#include <string>
#include <vector>

namespace tp {

/// What one method took for one kind of question on one scene.
struct BenchRow {
    std::string scene;
    std::size_t segments = 0;
    std::string queries;       ///< "hand_path" or "random"
    std::string method;        ///< see NearestMethod::names
    std::string query;         ///< "band" or "any", see NearestMethod::query
    double ns_median = 0.0;    ///< per question: processor time, the median over batches of milliseconds
    double ns_p999 = 0.0;      ///< wall time of questions one by one, less the clock's own
    double build_ms = 0.0;     ///< processor time, median over a few builds
    std::size_t bytes = 0;     ///< held once built
    double max_error_mm = 0.0; ///< against the distance in extended precision, over a sample of the questions
};

struct BenchPlan {
    std::vector<std::size_t> sizes; ///< segments
    int rounds;                     ///< batches of each method; the methods take turns
    double batch_ms;                ///< how long a batch aims to take
    /// Whether a method is worth its time at a size.
    std::function<bool(const std::string& method, std::size_t segments)> wanted;

    /// All sizes, every method where it ends within a minute or so.
    static BenchPlan whole();
    /// Ends within 45 s: 1 000, 10 000 and 1 000 000 segments, the slow methods left out early.
    static BenchPlan quick();
};

/// Runs on one core. `progress` hears a line now and then.
std::vector<BenchRow> run_nearest_bench(const BenchPlan& plan,
                                        const std::function<void(const std::string&)>& progress);

} // namespace tp
