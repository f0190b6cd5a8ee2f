// SPDX-License-Identifier: Apache-2.0
#include "app/figures/report/aim_report.hpp"

#include "app/figures/report/plot.hpp"

#include <QColor>
#include <QString>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

namespace tp {

namespace {

constexpr std::array aims{Aim::middle, Aim::thirds, Aim::head_and_shoulders, Aim::everybody};

AimTrial trial_of(Aim aim, AimGuidance guidance, std::uint64_t seed, std::size_t person) {
    AimTrial trial;
    trial.aim = aim;
    trial.guidance = guidance;
    trial.seed = seed * 1'000'003 + person; // the people of another seed are others
    return trial;
}

struct Assumption {
    const char* what;
    void (*change)(AimTrial& trial);
};

constexpr double worse_by = 1.5;

const std::array<Assumption, 12> assumptions{{
    {"as it is", [](AimTrial&) {}},
    {"the camera does not know which way is down", [](AimTrial& trial) { trial.gravity = false; }},
    {"starts half as far off again",
     [](AimTrial& trial) {
         trial.hand.aim_pan_deg *= worse_by;
         trial.hand.aim_tilt_deg *= worse_by;
         trial.hand.aim_roll_deg *= worse_by;
     }},
    {"twice as many wrong ways",
     [](AimTrial& trial) {
         trial.hand.wrong_side *= 2.0;
         trial.hand.wrong_height *= 2.0;
         trial.hand.tone_wrong_side *= 2.0;
         trial.hand.tone_wrong_height *= 2.0;
     }},
    {"lengths of moves spread by half",
     [](AimTrial& trial) { trial.hand.spread = trial.hand.tone_spread = 0.5; }},
    {"all moves half as long again",
     [](AimTrial& trial) {
         for (double* length : {&trial.hand.little_deg, &trial.hand.some_deg, &trial.hand.much_deg,
                                &trial.hand.little_m, &trial.hand.some_m, &trial.hand.much_m})
             *length *= worse_by;
     }},
    {"all moves two thirds as long",
     [](AimTrial& trial) {
         for (double* length : {&trial.hand.little_deg, &trial.hand.some_deg, &trial.hand.much_deg,
                                &trial.hand.little_m, &trial.hand.some_m, &trial.hand.much_m})
             *length /= worse_by;
     }},
    {"reactions half as long again",
     [](AimTrial& trial) {
         trial.hand.fastest_reaction_s *= worse_by;
         trial.hand.slowest_reaction_s *= worse_by;
     }},
    {"sentences half as long again", [](AimTrial& trial) { trial.hand.words_per_minute /= worse_by; }},
    {"0.3 s from frame to sound", [](AimTrial& trial) { trial.latency_s = 0.3; }},
    {"the strongest tremor and twice the sway",
     [](AimTrial& trial) {
         trial.tremor.peak_g = 0.035;
         trial.tremor.sway_deg *= 2.0;
     }},
    {"a detector that misses 15 % and jitters 3 %",
     [](AimTrial& trial) {
         trial.detector.missed = 0.15;
         trial.detector.jitter = 0.03;
     }},
}};

std::string seconds(const std::optional<double>& time) { return time ? cell(*time) : std::string(); }

} // namespace

std::string name_of(Aim aim) {
    switch (aim) {
    case Aim::middle:
        return "middle";
    case Aim::thirds:
        return "thirds";
    case Aim::head_and_shoulders:
        return "head-and-shoulders";
    case Aim::everybody:
        break;
    }
    return "everybody";
}

std::optional<Aim> aim_named(const std::string& name) {
    const auto* const found =
        std::find_if(aims.begin(), aims.end(), [&name](Aim aim) { return name_of(aim) == name; });
    return found == aims.end() ? std::nullopt : std::optional(*found);
}

AimReport measure_aiming(Aim aim, int people, std::uint64_t seed, const std::function<void(double)>& told,
                         const std::function<bool()>& stopped) {
    AimReport report;
    report.aim = aim;
    for (std::size_t person = 0; person < static_cast<std::size_t>(people); ++person) {
        if (stopped && stopped())
            break;
        if (told)
            told(static_cast<double>(person) / people);
        for (std::size_t i = 0; i < all_guidance.size(); ++i)
            report.results[i].push_back(run_trial(trial_of(aim, all_guidance[i], seed, person)));
    }
    for (std::size_t i = 0; i < all_guidance.size(); ++i)
        report.shares[i] = shares_of(report.results[i]);
    return report;
}

std::vector<AimVariation> vary_assumptions(Aim aim, int people, std::uint64_t seed,
                                           const std::function<void(double)>& told,
                                           const std::function<bool()>& stopped) {
    std::vector<AimVariation> variations;
    for (const Assumption& assumption : assumptions) {
        if (told)
            told(static_cast<double>(variations.size()) / static_cast<double>(assumptions.size()));
        std::vector<AimTrialResult> results;
        for (std::size_t person = 0; person < static_cast<std::size_t>(people); ++person) {
            if (stopped && stopped())
                return variations;
            AimTrial trial = trial_of(aim, AimGuidance::words_and_tone, seed, person);
            assumption.change(trial);
            results.push_back(run_trial(trial));
        }
        variations.push_back({assumption.what, shares_of(results)});
    }
    return variations;
}

CsvTable variations_table(const std::vector<AimVariation>& variations) {
    CsvTable table({"assumption", "within_10_s", "within_15_s", "within_20_s", "median_s"});
    for (const AimVariation& variation : variations)
        table.add({variation.what, cell(variation.shares.within_10_s), cell(variation.shares.within_15_s),
                   cell(variation.shares.within_20_s), seconds(variation.shares.median_s)});
    return table;
}

CsvTable shares_table(const AimReport& report) {
    CsvTable table({"aim", "guidance", "people", "within_5_s", "within_10_s", "within_15_s", "within_20_s",
                    "median_s", "missed_pictures", "sentences"});
    for (std::size_t i = 0; i < all_guidance.size(); ++i) {
        const AimShares& shares = report.shares[i];
        table.add({name_of(report.aim), std::string(name_of(all_guidance[i])), std::to_string(shares.trials),
                   cell(shares.within_5_s), cell(shares.within_10_s), cell(shares.within_15_s),
                   cell(shares.within_20_s), seconds(shares.median_s), cell(shares.missed_pictures),
                   cell(shares.sentences)});
    }
    return table;
}

CsvTable people_table(const AimReport& report, std::uint64_t seed) {
    CsvTable table({"person", "start_pan_deg", "start_tilt_deg", "start_roll_deg", "start_distance_m",
                    "words_and_tone_s", "words_s", "tone_s", "none_s"});
    for (std::size_t person = 0; person < report.results.front().size(); ++person) {
        const AimStart start = start_of(trial_of(report.aim, AimGuidance::none, seed, person));
        std::vector<std::string> row{std::to_string(person), cell(start.pose.pan_deg),
                                     cell(start.pose.tilt_deg), cell(start.pose.roll_deg),
                                     cell(start.people.front().ahead_m)};
        for (const auto& results : report.results)
            row.push_back(seconds(results[person].framed_s));
        table.add(std::move(row));
    }
    return table;
}

Result<std::filesystem::path> plot_aiming(const std::filesystem::path& folder, const AimReport& report) {
    const std::array<QColor, all_guidance.size()> colours{QColor(20, 120, 200), QColor(20, 150, 90),
                                                          QColor(214, 140, 40), QColor(120, 120, 130)};
    PlotPanel panel;
    panel.title = QStringLiteral("Simulated hands: from a random start to the picture");
    panel.x = {QStringLiteral("time, s"), 0.0, 30.0, false};
    panel.y = {QStringLiteral("share framed, %"), 0.0, 100.0, false};
    for (std::size_t i = 0; i < all_guidance.size(); ++i) {
        const std::string_view name = name_of(all_guidance[i]);
        PlotPanel::Line line{QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())),
                             colours[i],
                             {{0.0, 0.0}},
                             false};
        std::vector<double> times;
        for (const AimTrialResult& result : report.results[i])
            if (result.framed_s)
                times.push_back(*result.framed_s);
        std::sort(times.begin(), times.end());
        const double each = 100.0 / static_cast<double>(std::max<std::size_t>(1, report.results[i].size()));
        for (const double time : times) {
            line.points.emplace_back(time, line.points.back().y);
            line.points.emplace_back(time, line.points.back().y + each);
        }
        line.points.emplace_back(30.0, line.points.back().y);
        panel.lines.push_back(std::move(line));
    }
    return write_plot(folder / "aim", {panel});
}

} // namespace tp
