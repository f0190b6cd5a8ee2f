// SPDX-License-Identifier: Apache-2.0
#include "app/figures/study/study_report.hpp"

#include "core/study_folder/study_summary.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

namespace tp {
namespace {

bool counts(const TrialRecord& record) { return !record.training && !record.repeated; }

/// Faces stand for people at large; a question about one of them is not asked.
bool is_compared(const StudyFactor& factor) { return factor.parameter != StudyParameter::face; }

std::vector<Factor> factors_of(const Experiment& experiment) {
    std::vector<Factor> factors;
    for (const StudyFactor& factor : experiment.factors) {
        if (!is_compared(factor))
            continue;
        Factor& named = factors.emplace_back(Factor{std::string(kind_of(factor.parameter).name), {}});
        for (std::size_t level = 0; level < factor.levels.size(); ++level)
            named.levels.push_back(level_words(factor, level));
    }
    return factors;
}

std::vector<std::size_t> compared_levels(const Experiment& experiment, std::size_t condition) {
    const std::vector<std::size_t> levels = experiment.levels_of(condition);
    std::vector<std::size_t> compared;
    for (std::size_t i = 0; i < levels.size(); ++i)
        if (is_compared(experiment.factors[i]))
            compared.push_back(levels[i]);
    return compared;
}

/// Participants in the order of their numbers, as the table sorts them by text.
std::string numbered(int participant) {
    std::string text = std::to_string(participant);
    return text.insert(0, text.size() < 3 ? 3 - text.size() : 0, '0');
}

using Value = std::function<std::optional<double>(const TrialRecord&)>;

void add_measure(StudyReport& report, const StudyFolder& study, std::string name, std::string axis,
                 const Value& value) {
    WithinTable table(factors_of(study.experiment));
    for (const TrialRecord& record : study.records)
        if (counts(record))
            if (const auto number = value(record))
                table.add(numbered(record.participant), compared_levels(study.experiment, record.condition),
                          *number);
    auto means = table.means();
    if (!means) {
        report.remarks.push_back("Nothing can be said about the " + axis.substr(0, axis.find(',')) + ". " +
                                 means.error());
        return;
    }
    for (const std::string& sentence : means->left_out)
        if (std::ranges::find(report.remarks, sentence) == report.remarks.end())
            report.remarks.push_back(sentence);
    StudyMeasure measure{std::move(name), std::move(axis), std::move(*means), {}, {}};
    measure.anova = repeated_anova(measure.means);
    for (std::size_t factor = 0; factor < measure.means.factors.size(); ++factor)
        measure.levels.push_back(tukey_hsd(measure.means, factor));
    if (!measure.anova.remark.empty())
        report.remarks.push_back(measure.anova.remark);
    report.measures.push_back(std::move(measure));
}

Confusion confusion(const StudyFolder& study, const StudyFactor& asked, std::string where,
                    const std::function<bool(const TrialRecord&)>& among) {
    const std::size_t count = asked.levels.size();
    Confusion result{std::move(where), asked.levels, std::vector(count, std::vector<std::size_t>(count + 1))};
    const auto place = [&](const std::string& word) {
        return static_cast<std::size_t>(std::ranges::find(asked.levels, word) - asked.levels.begin());
    };
    for (const TrialRecord& record : study.records)
        if (counts(record) && among(record))
            ++result.counts[place(study.experiment.value_of(asked.parameter, record.condition))]
                           [place(record.answer)];
    return result;
}

void add_confusions(StudyReport& report, const StudyFolder& study) {
    const std::vector<StudyFactor>& factors = study.experiment.factors;
    const StudyFactor& asked = *std::ranges::find(factors, *study.experiment.answer, &StudyFactor::parameter);
    report.confusions.push_back(confusion(study, asked, "", [](const TrialRecord&) { return true; }));
    for (const StudyFactor& factor : factors)
        if (factor.parameter != asked.parameter && is_compared(factor))
            for (std::size_t level = 0; level < factor.levels.size(); ++level)
                report.confusions.push_back(
                    confusion(study, asked,
                              std::string(kind_of(factor.parameter).name) + " " + level_words(factor, level),
                              [&](const TrialRecord& record) {
                                  return study.experiment.value_of(factor.parameter, record.condition) ==
                                         factor.levels[level];
                              }));
}

std::string maybe(const std::optional<double>& value) { return value ? cell(*value) : std::string(); }

} // namespace

double Confusion::right() const {
    std::size_t all = 0, named = 0;
    for (std::size_t row = 0; row < counts.size(); ++row)
        for (std::size_t column = 0; column < counts[row].size(); ++column) {
            all += counts[row][column];
            named += row == column ? counts[row][column] : 0;
        }
    return all == 0 ? 0.0 : static_cast<double>(named) / static_cast<double>(all);
}

Result<StudyReport> report_on(const StudyFolder& study) {
    StudyReport report;
    report.experiment = study.experiment;
    report.remarks = study.remarks;
    if (study.terms && study.terms->simulated)
        report.remarks.push_back("The participants are simulated people; nobody has felt anything.");
    const StudySummary summary = summary_of(study);
    report.participants = summary.participants;
    report.trials = summary.trials;
    report.repeated = summary.repeated;
    if (report.trials == 0)
        return Error{"There are no trials yet that count."};
    if (study.experiment.task == StudyTask::follow)
        add_measure(report, study, "error_mm", "tracking error, mm",
                    [](const TrialRecord& record) { return record.error_mm; });
    else
        add_measure(report, study, "right", "named rightly, share", [&](const TrialRecord& record) {
            return std::optional(is_right(study.experiment, record) ? 1.0 : 0.0);
        });
    add_measure(report, study, "time_s", "time, s",
                [](const TrialRecord& record) { return std::optional(record.time_s); });
    if (study.experiment.answer)
        add_confusions(report, study);
    std::vector<std::string> once; // the same is said of two measures
    for (std::string& remark : report.remarks)
        if (std::ranges::find(once, remark) == once.end())
            once.push_back(std::move(remark));
    report.remarks = std::move(once);
    return report;
}

CsvTable effects_table(const StudyReport& report) {
    CsvTable table({"measure", "effect", "sum_of_squares", "df", "error_sum_of_squares", "error_df", "f", "p",
                    "epsilon", "p_greenhouse_geisser", "eta_squared_generalised"});
    for (const StudyMeasure& measure : report.measures)
        for (const WithinEffect& effect : measure.anova.effects)
            table.add({measure.name, words_for(effect, measure.means.factors), cell(effect.sum),
                       cell(effect.df), cell(effect.error_sum), cell(effect.error_df), maybe(effect.f),
                       maybe(effect.p), maybe(effect.epsilon), maybe(effect.p_spherical),
                       maybe(effect.eta_squared)});
    return table;
}

CsvTable levels_table(const StudyReport& report) {
    CsvTable table({"measure", "factor", "level", "mean", "standard_error", "letters"});
    for (const StudyMeasure& measure : report.measures)
        for (std::size_t factor = 0; factor < measure.levels.size(); ++factor)
            for (const LevelMean& level : measure.levels[factor].levels)
                table.add({measure.name, measure.means.factors[factor].name, level.level, cell(level.mean),
                           maybe(level.standard_error), level.letters});
    return table;
}

CsvTable pairs_table(const StudyReport& report) {
    CsvTable table({"measure", "factor", "level", "other_level", "difference", "p_tukey"});
    for (const StudyMeasure& measure : report.measures)
        for (std::size_t factor = 0; factor < measure.levels.size(); ++factor) {
            const Pairwise& pairwise = measure.levels[factor];
            for (const LevelPair& pair : pairwise.pairs)
                table.add({measure.name, measure.means.factors[factor].name, pairwise.levels[pair.one].level,
                           pairwise.levels[pair.other].level, cell(pair.difference), cell(pair.p)});
        }
    return table;
}

CsvTable confusion_table(const StudyReport& report) {
    CsvTable table({"where", "it_was", "said", "times"});
    for (const Confusion& confusion : report.confusions)
        for (std::size_t row = 0; row < confusion.names.size(); ++row)
            for (std::size_t column = 0; column <= confusion.names.size(); ++column)
                table.add({confusion.where, confusion.names[row],
                           column < confusion.names.size() ? confusion.names[column] : std::string(),
                           std::to_string(confusion.counts[row][column])});
    return table;
}

} // namespace tp
