// SPDX-License-Identifier: Apache-2.0
#include "app/cli/command_line.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/study_simulation.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/verbs.hpp"
#include "app/figures/study/published_results.hpp"
#include "app/figures/study/study_report.hpp"
#include "core/experiment/trial_order.hpp"
#include "core/study_folder/study_check.hpp"
#include "core/study_folder/study_export.hpp"

#include <QJsonArray>
#include <QJsonObject>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace tp {
namespace {

QString text_of(const std::string& text) { return QString::fromStdString(text); }

QJsonValue maybe(const std::optional<double>& value) { return value ? QJsonValue(*value) : QJsonValue(); }

QJsonObject json_of(const StudyReport& report) {
    QJsonArray effects, levels, remarks, published;
    for (const ComparedResult& result : compared_results(std::span(&report, 1)))
        published.append(QJsonObject{{"what", text_of(subject_words(result.published))},
                                     {"published", text_of(published_words(result.published))},
                                     {"here", result.mean},
                                     {"alike", result.alike}});
    for (const StudyMeasure& measure : report.measures) {
        for (const WithinEffect& effect : measure.anova.effects)
            effects.append(QJsonObject{{"measure", text_of(measure.name)},
                                       {"effect", text_of(words_for(effect, measure.means.factors))},
                                       {"f", maybe(effect.f)},
                                       {"df", effect.df},
                                       {"error_df", effect.error_df},
                                       {"p", maybe(effect.p)},
                                       {"epsilon", maybe(effect.epsilon)},
                                       {"p_greenhouse_geisser", maybe(effect.p_spherical)},
                                       {"eta_squared_generalised", maybe(effect.eta_squared)}});
        for (std::size_t factor = 0; factor < measure.levels.size(); ++factor)
            for (const LevelMean& level : measure.levels[factor].levels)
                levels.append(QJsonObject{{"measure", text_of(measure.name)},
                                          {"factor", text_of(measure.means.factors[factor].name)},
                                          {"level", text_of(level.level)},
                                          {"mean", level.mean},
                                          {"standard_error", maybe(level.standard_error)},
                                          {"letters", text_of(level.letters)}});
    }
    for (const std::string& remark : report.remarks)
        remarks.append(text_of(remark));
    return {{"experiment", text_of(report.experiment.name)},
            {"participants", static_cast<int>(report.participants)},
            {"trials", static_cast<int>(report.trials)},
            {"repeated", static_cast<int>(report.repeated)},
            {"effects", effects},
            {"levels", levels},
            {"published", published},
            {"remarks", remarks}};
}

void show(const StudyReport& report) {
    print("%zu participants, %zu trials, %zu done again\n", report.participants, report.trials,
          report.repeated);
    for (const StudyMeasure& measure : report.measures) {
        print("\n%s\n", measure.axis.c_str());
        for (const WithinEffect& effect : measure.anova.effects) {
            const std::string words = // × is two bytes
                text_of(words_for(effect, measure.means.factors)).leftJustified(32).toStdString();
            if (effect.f)
                print("  %s F(%.0f, %.0f) = %7.2f, p = %.3g, after Greenhouse and Geisser %.3g\n",
                      words.c_str(), effect.df, effect.error_df, *effect.f, *effect.p, *effect.p_spherical);
            else
                print("  %s no F\n", words.c_str());
        }
    }
    for (const Confusion& confusion : report.confusions)
        print("%s%s: %.1f %% named rightly\n", &confusion == &report.confusions.front() ? "\n" : "",
              confusion.where.empty() ? "all" : confusion.where.c_str(), 100.0 * confusion.right());
}

int report_verb(const VerbLine& line, const std::filesystem::path& folder) {
    if (!line.has("out"))
        return wrong_usage("study", "--out DIR is missing.");
    LongWork::step("reading the study");
    const auto study = read_study(folder);
    if (!study)
        return refused(study.error());
    LongWork::step("working out what the study shows");
    const auto report = report_on(*study);
    if (!report)
        return refused(report.error());
    if (const std::string problem = line.make_folder("out"); !problem.empty())
        return refused(problem);
    LongWork::step("writing the report");
    if (const std::string problem = write_report(line.text("out").toStdString(), *report); !problem.empty())
        return refused(problem);
    for (const std::string& remark : report->remarks)
        say(remark);
    if (line.has("json"))
        print_json(json_of(*report));
    else
        show(*report);
    return exit_done;
}

void share_done(std::size_t done, std::size_t all) {
    LongWork::share(static_cast<double>(done) / static_cast<double>(all));
}

int check_verb(const std::filesystem::path& folder) {
    LongWork::step("reading the study");
    const auto study = read_study(folder);
    if (!study)
        return refused(study.error());
    LongWork::step("checking the study");
    const StudyFindings found = check_study(folder, *study, share_done, LongWork::stop_token());
    if (LongWork::stop_asked())
        return LongWork::stop_code();
    if (found.running)
        say("A program is running this study now; this is how far it has come.");
    for (const std::string& sentence : study_progress(*study))
        print("%s\n", sentence.c_str());
    if (study->records.empty())
        print("There are no trials yet.\n");
    for (const std::string& fault : found.faults)
        print("%s\n", fault.c_str());
    return found.faults.empty() ? exit_done : exit_bad_input;
}

int export_verb(const VerbLine& line, const std::filesystem::path& folder) {
    if (!line.has("out"))
        return wrong_usage("study", "--out FILE.zip is missing.");
    const auto out = line.output_file(line.text("out"));
    if (!out)
        return refused(out.error());
    LongWork::step("packing the study");
    const auto done = export_study(folder, *out, share_done, LongWork::stop_token());
    if (!done)
        return refused(done.error());
    for (const std::string& remark : done->remarks)
        say(remark);
    print("%zu participants, %zu trials, %zu paths\n", done->participants, done->trials, done->paths);
    return exit_done;
}

int plan_verb(const VerbLine& line, const std::filesystem::path& file) {
    const auto participant = line.whole("participant", 1, 1'000'000);
    const auto seed = line.whole("seed", 0, 1'000'000'000);
    if (!participant || !seed)
        return wrong_usage("study", participant ? seed.error() : participant.error());
    const auto experiment = experiment_of(file);
    if (!experiment)
        return refused(experiment.error());
    std::string columns = "trial,repetition,training";
    for (const StudyFactor& factor : experiment->factors)
        columns += "," + std::string(kind_of(factor.parameter).name);
    print("%s,seed\n", columns.c_str());
    const Experiment in_training = experiment->in_training();
    int number = 0;
    for (const PlannedTrial& trial :
         trials_of(*experiment, *participant, static_cast<std::uint64_t>(*seed))) {
        std::string row = std::to_string(++number) + "," + std::to_string(trial.repetition + 1) +
                          (trial.training ? ",yes" : ",no");
        const Experiment& from = trial.training ? in_training : *experiment;
        const auto levels = from.levels_of(trial.condition);
        for (std::size_t i = 0; i < levels.size(); ++i)
            row += "," + from.factors[i].levels[levels[i]];
        print("%s,%llu\n", row.c_str(), static_cast<unsigned long long>(trial.seed));
    }
    return exit_done;
}

} // namespace

int study_verb(const QStringList& words) {
    VerbLine line(
        "study",
        "Experiments with people. plan FILE: the trials of one participant, in their order. check FOLDER:\n"
        "how far each participant of a study has come, and what is wrong in its folder; ends with 1 if\n"
        "something is. export FOLDER: all of it as one zip, without names. report FOLDER: what the study\n"
        "shows, as tables, plots and one page: repeated-measures analysis of variance, Tukey's groups, what\n"
        "was called what. simulate FILE: lets simulated people do the experiment, which fills such a "
        "folder;\n"
        "the same seed gives the same bytes. replicate FILE: several such studies, each of other people, "
        "beside "
        "what\nwas published of the experiment.\n"
        "Experiments are files. The program's own have names and numbers: 1 tracking, 2 primitives,\n"
        "3 expressions, 4 laws-tracking, 5 laws-expressions; 1 to 3 are the published ones.");
    line.argument("what", "plan, check, export, report, simulate or replicate.",
                  "plan|check|export|report|simulate|replicate")
        .argument("from", "An experiment's file, name or number, or the folder of a study.", "FILE|FOLDER")
        .option("participant", "With plan: the number of the person.", "N", "1")
        .option("seed",
                "With plan and simulate: the study's number; another one is another order. With replicate: "
                "the first.",
                "S", "1")
        .output("out",
                "With report: folder for the results; made where it is missing. With export: the zip. With "
                "simulate: the study's folder, new or begun. With replicate: the folder of all.",
                "DIR|FILE")
        .option("json", "With report, simulate and replicate: JSON instead of words.");
    add_simulation_options(line);
    if (const auto ended = line.parse(words, 2, 2))
        return *ended;
    const QString what = line.arguments()[0];
    const std::filesystem::path from = line.arguments()[1].toStdString();
    if (what == "plan")
        return plan_verb(line, from);
    if (what == "check")
        return check_verb(from);
    if (what == "export")
        return export_verb(line, from);
    if (what == "report")
        return report_verb(line, from);
    if (what == "simulate")
        return simulate_study_verb(line, from);
    if (what == "replicate")
        return replicate_study_verb(line, from);
    return wrong_usage("study",
                       "There is nothing called \"" + what.toStdString() +
                           "\"; plan, check, export, report, simulate and replicate are what can be done.");
}

} // namespace tp
