// SPDX-License-Identifier: Apache-2.0
#include "app/figures/simulated/touch_worth.hpp"

#include "app/figures/simulated/touch_trials.hpp"

#include <string>

namespace tp {
namespace {

constexpr double force_latency_s = 0.005;

double mean(double sum, std::size_t count) { return count == 0 ? 0.0 : sum / static_cast<double>(count); }

} // namespace

std::string_view name_of(TouchManner manner) {
    switch (manner) {
    case TouchManner::force:
        return "force";
    case TouchManner::resistance:
        return "resistance";
    case TouchManner::ticks:
        return "ticks";
    }
    return {};
}

Result<TouchRow> measure_touch_row(const TouchPlan& plan, TouchManner manner, double latency_s,
                                   const std::function<bool()>& stopped) {
    TouchRow row;
    row.manner = manner;
    row.latency_s = latency_s;
    double find_s = 0.0, follow_s = 0.0, error_mm = 0.0, lost = 0.0;
    for (int number = 1; number <= plan.people; ++number) {
        const Person person = person_of(number, plan.seed);
        for (const StudyShape shape : {StudyShape::circle, StudyShape::triangle, StudyShape::curve})
            for (int repetition = 0; repetition < plan.repetitions && !stopped(); ++repetition) {
                const std::uint64_t seed = plan.seed * 1'000'003U +
                                           static_cast<std::uint64_t>(number * 1009 + repetition * 31) +
                                           static_cast<std::uint64_t>(shape);
                const StudyTrial trial = touch_trial(shape, seed);
                const auto find = find_line(trial, person, manner, latency_s, seed);
                const auto follow = follow_line(trial, person, manner, latency_s, seed);
                if (!find || !follow)
                    return Error{find ? follow.error() : find.error()};
                ++row.trials;
                lost += static_cast<double>(follow->times_lost);
                if (*find) {
                    ++row.found;
                    find_s += **find;
                }
                if (follow->done) {
                    ++row.followed;
                    follow_s += follow->time_s;
                    error_mm += follow->error_mm;
                }
            }
    }
    row.find_s = mean(find_s, row.found);
    row.follow_s = mean(follow_s, row.followed);
    row.error_mm = mean(error_mm, row.followed);
    row.lost = mean(lost, row.trials);
    return row;
}

Result<std::vector<TouchRow>> measure_touch(const TouchPlan& plan,
                                            const std::function<void(double)>& progress,
                                            const std::function<bool()>& stopped) {
    std::vector<TouchRow> rows;
    const double whole = 1.0 + 2.0 * static_cast<double>(plan.latencies_s.size());
    const auto add = [&](TouchManner manner, double latency_s) -> std::string {
        if (stopped())
            return {};
        const auto row = measure_touch_row(plan, manner, latency_s, stopped);
        if (!row)
            return row.error();
        if (stopped())
            return {};
        rows.push_back(*row);
        progress(static_cast<double>(rows.size()) / whole);
        return {};
    };
    if (const std::string problem = add(TouchManner::force, force_latency_s); !problem.empty())
        return Error{problem};
    for (const TouchManner manner : {TouchManner::resistance, TouchManner::ticks})
        for (const double latency_s : plan.latencies_s)
            if (const std::string problem = add(manner, latency_s); !problem.empty())
                return Error{problem};
    return rows;
}

CsvTable touch_table(const std::vector<TouchRow>& rows) {
    CsvTable table(
        {"manner", "latency_ms", "trials", "found", "find_s", "followed", "follow_s", "error_mm", "lost"});
    for (const TouchRow& row : rows)
        table.add({std::string(name_of(row.manner)), cell(1000.0 * row.latency_s), std::to_string(row.trials),
                   std::to_string(row.found), cell(row.find_s, 4), std::to_string(row.followed),
                   cell(row.follow_s, 4), cell(row.error_mm, 4),
                   row.manner == TouchManner::force ? std::string() : cell(row.lost, 4)});
    return table;
}

} // namespace tp
