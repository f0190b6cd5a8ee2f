// SPDX-License-Identifier: Apache-2.0
#include "app/cli/command_line.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/verbs.hpp"
#include "app/figures/simulated/touch_worth.hpp"
#include "core/files/file_name.hpp"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace tp {

namespace {

void show(const std::vector<TouchRow>& rows) {
    print("%-10s %8s %9s %8s %9s %8s %9s %6s\n", "manner", "latency", "found", "after", "followed", "after",
          "error", "lost");
    for (const TouchRow& row : rows)
        print("%-10s %5.0f ms %5zu/%-3zu %6.1f s %5zu/%-3zu %6.1f s %6.2f mm %6s\n",
              std::string(name_of(row.manner)).c_str(), 1000.0 * row.latency_s, row.found, row.trials,
              row.find_s, row.followed, row.trials, row.follow_s, row.error_mm,
              row.manner == TouchManner::force ? "-" : cell(row.lost, 3).c_str());
}

} // namespace

int bench_touch_verb(const QStringList& words) {
    VerbLine line(
        "bench touch",
        "Lets simulated people find lines and follow them by the force of the guidance, by friction\n"
        "alone and by ticks alone, felt 5 to 100 ms late. Writes touch.csv. The same seed gives the\n"
        "same bytes.");
    line.option("out", "Folder for the result; created if it is missing.", "DIR")
        .option("people", "How many people, each with every line and manner.", "N", "10")
        .option("seed", "Whole number; another one is other people.", "S", "1");
    if (const auto ended = line.parse(words, 0, 0))
        return *ended;
    if (!line.has("out"))
        return wrong_usage("bench touch", "--out DIR is missing.");
    const auto people = line.whole("people", 1, 10'000);
    const auto seed = line.whole("seed", 0, 1'000'000'000);
    if (!people || !seed)
        return wrong_usage("bench touch", people ? seed.error() : people.error());
    if (const std::string problem = line.make_folder("out"); !problem.empty())
        return refused(problem);
    LongWork::step("simulating people");
    TouchPlan plan;
    plan.people = *people;
    plan.seed = static_cast<std::uint64_t>(*seed);
    const auto rows = measure_touch(plan, LongWork::share, [] { return LongWork::stop_asked().load(); });
    if (LongWork::stop_asked())
        return LongWork::stop_code();
    if (!rows)
        return refused(rows.error());
    const auto written = touch_table(*rows).write(path_named(line.text("out").toStdString()) / "touch.csv");
    if (!written)
        return refused(written.error());
    show(*rows);
    return exit_done;
}

} // namespace tp
