// SPDX-License-Identifier: Apache-2.0
#include "app/cli/command_line.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/verbs.hpp"
#include "app/figures/report/continuity_cost.hpp"
#include "app/figures/report/csv_table.hpp"
#include "app/figures/report/hard_cases.hpp"
#include "app/figures/report/loop_work.hpp"
#include "app/figures/report/released_handle.hpp"
#include "app/figures/report/stability_plots.hpp"

#include <QDir>

#include <cstdio>

namespace tp {

namespace {

std::string yes_no(bool value) { return value ? "1" : "0"; }

CsvTable table_of(const std::vector<LoopWork>& rows) {
    CsvTable table({"law", "vertex_spacing_mm", "wrong_fraction", "max_force_error_n", "max_loop_work_mj",
                    "max_force_step_n", "p99_loop_work_mj", "wrong_of_pulled"});
    for (const LoopWork& row : rows)
        table.add({row.law, cell(row.vertex_spacing_mm), cell(row.wrong_fraction),
                   cell(row.max_force_error_n), cell(row.max_loop_work_mj), cell(row.max_force_step_n),
                   cell(row.p99_loop_work_mj), cell(row.wrong_of_pulled)});
    return table;
}

CsvTable table_of(const std::vector<std::pair<HandleCase, HandleResult>>& rows) {
    CsvTable table({"law", "stiffness_n_per_mm", "range_mm", "period_s", "delay_samples", "mass_kg",
                    "damping_ns_per_m", "coulomb_n", "quantum_mm", "observer", "line_damping", "amplitude_mm",
                    "frequency_hz", "settled", "bound_ns_per_m"});
    for (const auto& [handle, result] : rows)
        table.add({handle.law == LawKind::exact ? "exact" : "published", cell(handle.stiffness),
                   cell(handle.range), cell(handle.period), std::to_string(handle.delay), cell(handle.mass),
                   cell(handle.damping), cell(handle.coulomb), cell(handle.quantum), yes_no(handle.observer),
                   yes_no(handle.line_damping), cell(result.amplitude_mm), cell(result.frequency_hz),
                   yes_no(result.settled), cell(handle.bound())});
    return table;
}

CsvTable table_of(const std::vector<HardVerdict>& verdicts) {
    CsvTable table({"case", "law", "verdict", "max_force_n", "note"});
    for (const HardVerdict& verdict : verdicts)
        table.add({verdict.name, verdict.law, verdict.verdict, cell(verdict.max_force_n), verdict.note});
    return table;
}

CsvTable table_of(const std::vector<ContinuityCost>& rows) {
    CsvTable table({"manner", "width_mm", "mean_error_n", "p99_error_n", "max_error_n", "wrong_fraction",
                    "largest_step_n", "clicks_per_m", "tremor_clicks_per_s", "work_given_mj"});
    for (const ContinuityCost& row : rows)
        table.add({row.manner, cell(row.width_mm), cell(row.mean_error_n), cell(row.p99_error_n),
                   cell(row.max_error_n), cell(row.wrong_fraction), cell(row.largest_step_n),
                   cell(row.clicks_per_m), cell(row.tremor_clicks_per_s), cell(row.work_given_mj)});
    return table;
}

std::vector<std::pair<HandleCase, HandleResult>> release_all(const std::vector<HandleCase>& grid) {
    std::vector<std::pair<HandleCase, HandleResult>> rows;
    for (std::size_t i = 0; i < grid.size(); ++i) {
        if (i % 200 == 0)
            say_step("released handles: " + std::to_string(i) + " of " + std::to_string(grid.size()));
        rows.emplace_back(grid[i], release_handle(grid[i]));
    }
    return rows;
}

void print_summary(const std::vector<LoopWork>& loops, const std::vector<ContinuityCost>& continuity,
                   const std::vector<std::pair<HandleCase, HandleResult>>& handles,
                   const std::vector<HardVerdict>& verdicts) {
    std::printf("%-10s %10s %10s %12s %12s %12s %12s %12s\n", "law", "spacing", "wrong", "of pulled",
                "worst error", "p99 loop", "worst loop", "force step");
    for (const LoopWork& row : loops)
        std::printf("%-10s %7.1f mm %8.3f %% %10.3f %% %10.3f N %9.2g mJ %9.2g mJ %10.3f N\n",
                    row.law.c_str(), row.vertex_spacing_mm, 100.0 * row.wrong_fraction,
                    100.0 * row.wrong_of_pulled, row.max_force_error_n, row.p99_loop_work_mj,
                    row.max_loop_work_mj, row.max_force_step_n);
    std::printf("%-21s %8s %9s %9s %9s %8s %8s %10s %12s %10s\n", "continuity", "width", "mean", "p99", "max",
                "wrong", "step", "clicks/m", "tremor", "work");
    for (const ContinuityCost& row : continuity)
        std::printf("%-21s %5.1f mm %7.4f N %7.4f N %7.3f N %6.2f %% %6.3f N %10.1f %7.1f a s %7.4f mJ\n",
                    row.manner.c_str(), row.width_mm, row.mean_error_n, row.p99_error_n, row.max_error_n,
                    100.0 * row.wrong_fraction, row.largest_step_n, row.clicks_per_m, row.tremor_clicks_per_s,
                    row.work_given_mj);
    for (const bool remedies : {false, true}) {
        int settled = 0;
        int all = 0;
        for (const auto& [handle, result] : handles)
            if (handle.law == LawKind::exact && handle.observer == remedies &&
                handle.line_damping == remedies) {
                ++all;
                settled += result.settled ? 1 : 0;
            }
        std::printf("released handles %s observer and damping: %d of %d settle\n",
                    remedies ? "with" : "without", settled, all);
    }
    for (const char* law : {"exact", "published"}) {
        int right = 0;
        int wrong = 0;
        int unsafe = 0;
        for (const HardVerdict& verdict : verdicts)
            if (verdict.law == law)
                ++(verdict.verdict == "right" ? right : verdict.verdict == "wrong" ? wrong : unsafe);
        std::printf("hard cases, %s law: %d right, %d wrong, %d unsafe\n", law, right, wrong, unsafe);
    }
}

} // namespace

int stability_verb(const QStringList& words) {
    VerbLine line(
        "stability",
        "Measures how stable the guidance is: net work round loops, released handles over stiffness,\n"
        "period, delay and damping, what softening the switches between contours costs, and the hard\n"
        "cases by name. Writes loop_work.csv, released_handle.csv, continuity.csv, hard_cases.csv and\n"
        "plots of the first two.");
    line.option("out", "Folder for the results; created if it is missing.", "DIR")
        .option("quick", "A smaller grid, for a first look.");
    if (const auto ended = line.parse(words, 0, 0))
        return *ended;
    if (!line.has("out"))
        return wrong_usage("stability", "--out DIR is missing.");
    const QDir folder(line.text("out"));
    if (const std::string problem = line.make_folder("out"); !problem.empty()) {
        say_problem(problem);
        return exit_bad_input;
    }
    const bool quick = line.has("quick");
    say_step("hard cases");
    const std::vector<HardVerdict> verdicts = judge_hard_cases();
    say_step("loops");
    const std::vector<LoopWork> loops = measure_loop_work(
        {0.5, 1.0, 2.0, 5.0, 10.0}, quick ? LoopWorkEffort{20'000, 100, 1'885} : LoopWorkEffort{});
    say_step("continuity at switches");
    const std::vector<ContinuityCost> continuity =
        measure_continuity(quick ? ContinuityEffort{40'000, 100, 2.0} : ContinuityEffort{});
    const auto handles = release_all(handle_grid(quick));

    LongWork::step("writing tables and plots");
    const std::filesystem::path out = folder.path().toStdString();
    for (const auto& written :
         {table_of(verdicts).write(out / "hard_cases.csv"), table_of(loops).write(out / "loop_work.csv"),
          table_of(continuity).write(out / "continuity.csv"),
          table_of(handles).write(out / "released_handle.csv"), plot_loop_work(out, loops),
          plot_released_handle(out, handles)})
        if (!written) {
            say_problem(written.error());
            return exit_bad_input;
        }
    print_summary(loops, continuity, handles, verdicts);
    return exit_done;
}

} // namespace tp
