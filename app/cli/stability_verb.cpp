// SPDX-License-Identifier: Apache-2.0
#include "app/cli/command_line.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/verbs.hpp"
#include "app/figures/report/continuity_cost.hpp"
#include "app/figures/report/csv_table.hpp"
#include "app/figures/report/hard_cases.hpp"
#include "app/figures/report/loop_work.hpp"
#include "app/figures/report/passivity.hpp"
#include "app/figures/report/released_handle.hpp"
#include "app/figures/report/stability_plots.hpp"
#include "core/files/file_name.hpp"

#include <QDir>

#include <algorithm>
#include <cmath>
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
    CsvTable table({"law",
                    "stiffness_n_per_mm",
                    "range_mm",
                    "period_s",
                    "delay_samples",
                    "mass_kg",
                    "damping_ns_per_m",
                    "coulomb_n",
                    "quantum_mm",
                    "observer",
                    "line_damping",
                    "amplitude_mm",
                    "frequency_hz",
                    "settled",
                    "bound_ns_per_m",
                    "start_mm",
                    "farthest_mm",
                    "swings",
                    "hand_damping_ns_per_m",
                    "stretch",
                    "told_delay_samples",
                    "jitter_samples",
                    "told_damping_ns_per_m"});
    for (const auto& [handle, result] : rows)
        table.add({handle.law == LawKind::exact ? "exact" : "published",
                   cell(handle.stiffness),
                   cell(handle.range),
                   cell(handle.period),
                   std::to_string(handle.delay),
                   cell(handle.mass),
                   cell(handle.damping),
                   cell(handle.coulomb),
                   cell(handle.quantum),
                   yes_no(handle.observer),
                   yes_no(handle.line_damping),
                   cell(result.amplitude_mm),
                   cell(result.frequency_hz),
                   yes_no(result.settled),
                   cell(handle.bound()),
                   cell(result.start_mm),
                   cell(result.farthest_mm),
                   yes_no(result.swings),
                   cell(handle.hand_damping),
                   cell(handle.stretch),
                   std::to_string(handle.told_delay.value_or(handle.delay)),
                   std::to_string(handle.jitter),
                   cell(handle.told_damping.value_or(handle.damping))});
    return table;
}

CsvTable table_of(const std::vector<PassivityRow>& rows) {
    CsvTable table({"frequency_hz", "delay_ms", "part", "work_mj", "own_mj"});
    for (const PassivityRow& row : rows)
        table.add(
            {cell(row.frequency_hz), cell(row.delay_ms), row.part, cell(row.work_mj), cell(row.own_mj)});
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

/// As in bounded_handles: with a fifth more damping than it needs, and nothing that is not as told.
bool is_bounded(const HandleCase& handle) {
    return std::abs(handle.damping - 1.2 * handle.bound()) < 1e-12 && handle.jitter == 0 &&
           !handle.told_delay && !handle.told_damping && handle.coulomb == 0.0 &&
           handle.hand_damping == 0.0 && handle.stretch == 1.0 && handle.quantum == HandleCase{}.quantum &&
           handle.start_share == 1.0;
}

template <typename Choose>
void print_handles(const char* which, const std::vector<std::pair<HandleCase, HandleResult>>& handles,
                   Choose chosen) {
    int all = 0;
    int settled = 0;
    int swing = 0;
    int farther = 0;
    for (const auto& [handle, result] : handles)
        if (chosen(handle)) {
            ++all;
            settled += result.settled ? 1 : 0;
            swing += result.swings ? 1 : 0;
            farther += result.farthest_mm > result.start_mm + 0.5 * handle.quantum ? 1 : 0;
        }
    print("released handles %s: %d of %d settle, %d swing on, %d go farther than they began\n", which,
          settled, all, swing, farther);
}

void print_summary(const std::vector<LoopWork>& loops, const std::vector<ContinuityCost>& continuity,
                   const std::vector<std::pair<HandleCase, HandleResult>>& handles,
                   const std::vector<PassivityRow>& passivity, const std::vector<HardVerdict>& verdicts) {
    print("%-10s %10s %10s %12s %12s %12s %12s %12s\n", "law", "spacing", "wrong", "of pulled", "worst error",
          "p99 loop", "worst loop", "force step");
    for (const LoopWork& row : loops)
        print("%-10s %7.1f mm %8.3f %% %10.3f %% %10.3f N %9.2g mJ %9.2g mJ %10.3f N\n", row.law.c_str(),
              row.vertex_spacing_mm, 100.0 * row.wrong_fraction, 100.0 * row.wrong_of_pulled,
              row.max_force_error_n, row.p99_loop_work_mj, row.max_loop_work_mj, row.max_force_step_n);
    print("%-21s %8s %9s %9s %9s %8s %8s %10s %12s %10s\n", "continuity", "width", "mean", "p99", "max",
          "wrong", "step", "clicks/m", "tremor", "work");
    for (const ContinuityCost& row : continuity)
        print("%-21s %5.1f mm %7.4f N %7.4f N %7.3f N %6.2f %% %6.3f N %10.1f %7.1f a s %7.4f mJ\n",
              row.manner.c_str(), row.width_mm, row.mean_error_n, row.p99_error_n, row.max_error_n,
              100.0 * row.wrong_fraction, row.largest_step_n, row.clicks_per_m, row.tremor_clicks_per_s,
              row.work_given_mj);
    for (const bool remedies : {false, true})
        print_handles(remedies ? "with observer and damping" : "without", handles,
                      [&](const HandleCase& handle) {
                          return handle.law == LawKind::exact && handle.observer == remedies &&
                                 handle.line_damping == remedies;
                      });
    print_handles("with b = 1.2 K (T/2 + nT)", handles, [](const HandleCase& handle) {
        return handle.observer && handle.line_damping && is_bounded(handle);
    });
    for (const double delay_ms : {0.0, 1.0, 2.0, 4.0})
        for (const char* part : {"line_damping", "observer", "all"}) {
            double most_own = -1e9;
            double most = -1e9;
            for (const PassivityRow& row : passivity)
                if (row.delay_ms == delay_ms && row.part == part) {
                    most_own = std::max(most_own, row.own_mj);
                    most = std::max(most, row.work_mj);
                }
            print("driven at 1 to 100 Hz, %.0f ms, %-12s: at most %+.5f mJ in a cycle, %+.5f beyond "
                  "the bare law\n",
                  delay_ms, part, most, most_own);
        }
    for (const char* law : {"exact", "published"}) {
        int right = 0;
        int wrong = 0;
        int unsafe = 0;
        for (const HardVerdict& verdict : verdicts)
            if (verdict.law == law)
                ++(verdict.verdict == "right" ? right : verdict.verdict == "wrong" ? wrong : unsafe);
        print("hard cases, %s law: %d right, %d wrong, %d unsafe\n", law, right, wrong, unsafe);
    }
}

} // namespace

int stability_verb(const QStringList& words) {
    VerbLine line(
        "stability",
        "Measures how stable the guidance is: net work round loops, released handles over stiffness,\n"
        "period, delay and damping, the work of the force on a driven handle over 1 to 100 Hz, what\n"
        "softening the switches between contours costs, and the hard cases by name. Writes\n"
        "loop_work.csv, released_handle.csv, passivity.csv, continuity.csv, hard_cases.csv and plots of\n"
        "the first three.");
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
    say_step("passivity");
    const std::vector<PassivityRow> passivity = measure_passivity();
    const auto handles = release_all(handle_grid(quick));

    LongWork::step("writing tables and plots");
    const std::filesystem::path out = path_named(folder.path().toStdString());
    for (const auto& written :
         {table_of(verdicts).write(out / "hard_cases.csv"), table_of(loops).write(out / "loop_work.csv"),
          table_of(continuity).write(out / "continuity.csv"),
          table_of(handles).write(out / "released_handle.csv"),
          table_of(passivity).write(out / "passivity.csv"), plot_loop_work(out, loops),
          plot_released_handle(out, handles), plot_passivity(out, passivity)})
        if (!written) {
            say_problem(written.error());
            return exit_bad_input;
        }
    print_summary(loops, continuity, handles, passivity, verdicts);
    return exit_done;
}

} // namespace tp
