// SPDX-License-Identifier: Apache-2.0
#include "core/experiment/trial_table.hpp"

#include "core/experiment/number_text.hpp"

#include <algorithm>
#include <utility>

namespace tp {
namespace {

constexpr int most_count = 1'000'000;

const StudyFactor* asked_factor(const Experiment& experiment) {
    const auto asked = std::ranges::find_if(
        experiment.factors, [&](const StudyFactor& factor) { return factor.parameter == experiment.answer; });
    return asked == experiment.factors.end() ? nullptr : &*asked;
}

/// The cells of a line. Ours need no quotation marks, since every text in them is a word of the experiment; another program may
/// have put them round each.
std::optional<std::vector<std::string_view>> cells_of(std::string_view line) {
    std::vector<std::string_view> cells;
    while (true) {
        std::string_view cell;
        if (line.starts_with('"')) {
            const std::size_t end = line.find('"', 1);
            if (end == std::string_view::npos || (end + 1 < line.size() && line[end + 1] != ','))
                return std::nullopt;
            cell = line.substr(1, end - 1);
            line.remove_prefix(end + 1);
        } else {
            cell = line.substr(0, line.find(','));
            line.remove_prefix(cell.size());
        }
        cells.push_back(cell);
        if (line.empty())
            return cells;
        line.remove_prefix(1);
    }
}

bool take_flag(std::string_view text, bool& into) {
    into = text == "yes";
    return into || text == "no";
}

/// What is wrong with a line, the end of a sentence; empty: it is in `record`.
std::string take(const Experiment& experiment, const Experiment& in_training, std::string_view line,
                 TrialRecord& record) {
    const auto cells = cells_of(line);
    if (!cells || cells->size() != 11 + experiment.factors.size())
        return "has another number of cells than there are columns";
    auto cell = cells->begin();
    if (*cell != experiment.name)
        return "is of another experiment";
    for (const auto& [into, what] :
         {std::pair(&record.participant, "participant"), std::pair(&record.trial, "trial"),
          std::pair(&record.repetition, "repetition")}) {
        const auto number = number_in(*++cell, 1, most_count);
        if (!number)
            return std::string("has no ") + what;
        *into = *number;
    }
    if (!take_flag(*++cell, record.training))
        return "does not say whether it was training";
    const Experiment& from = record.training ? in_training : experiment;
    std::vector<std::size_t> levels;
    for (const StudyFactor& factor : from.factors) {
        const auto level = std::ranges::find(factor.levels, *++cell);
        if (level == factor.levels.end())
            return "has a " + std::string(kind_of(factor.parameter).name) +
                   " that the experiment does not know";
        levels.push_back(static_cast<std::size_t>(level - factor.levels.begin()));
    }
    record.condition = from.condition_of(levels);
    if (!(++cell)->empty()) {
        record.error_mm = number_in(*cell, 0.0, 1e6);
        if (!record.error_mm)
            return "has an error that is no distance";
    }
    const auto time = number_in(*++cell, 0.0, 1e6);
    if (!time)
        return "has no time";
    record.time_s = *time;
    record.answer = *++cell;
    const StudyFactor* const asked = asked_factor(experiment);
    if (!record.answer.empty() &&
        (!asked || std::ranges::find(asked->levels, record.answer) == asked->levels.end()))
        return "has an answer that nobody could give";
    ++cell; // whether it was right follows from the answer
    if (!take_flag(*++cell, record.repeated))
        return "does not say whether it was repeated";
    const auto seed = number_in(*++cell, std::uint64_t{0}, ~std::uint64_t{0});
    if (!seed)
        return "has no seed";
    record.seed = *seed;
    return {};
}

} // namespace

bool is_right(const Experiment& experiment, const TrialRecord& record) {
    if (!experiment.answer || record.answer.empty())
        return false;
    return record.answer == (record.training ? experiment.in_training() : experiment)
                                .value_of(*experiment.answer, record.condition);
}

std::string trial_columns(const Experiment& experiment) {
    std::string line = "experiment,participant,trial,repetition,training,";
    for (const StudyFactor& factor : experiment.factors)
        line += std::string(kind_of(factor.parameter).name) + ",";
    return line + "error_mm,time_s,answer,correct,repeated,seed\n";
}

std::string trial_line(const Experiment& experiment, const TrialRecord& record) {
    const auto flag = [](bool is) { return std::string(is ? "yes" : "no"); };
    std::string line = experiment.name + "," + std::to_string(record.participant) + "," +
                       std::to_string(record.trial) + "," + std::to_string(record.repetition) + "," +
                       flag(record.training) + ",";
    const Experiment from = record.training ? experiment.in_training() : experiment;
    const std::vector<std::size_t> levels = from.levels_of(record.condition);
    for (std::size_t i = 0; i < levels.size(); ++i)
        line += from.factors[i].levels[levels[i]] + ",";
    line += (record.error_mm ? shortest(*record.error_mm) : "") + "," + shortest(record.time_s) + "," +
            record.answer + "," +
            (experiment.asks(record.training) ? flag(is_right(experiment, record)) : "") + "," +
            flag(record.repeated) + "," + std::to_string(record.seed) + "\n";
    return line;
}

Result<TrialTable> read_trials(const Experiment& experiment, std::string_view csv) {
    if (csv.size() > most_trial_table_bytes)
        return Error{"The table of trials is longer than " + std::to_string(most_trial_table_bytes >> 20) +
                     " MB."};
    TrialTable table;
    std::string columns = trial_columns(experiment);
    columns.pop_back();
    const Experiment in_training = experiment.in_training();
    int line_number = 0;
    for (std::string_view rest = csv; !rest.empty();) {
        ++line_number;
        const std::size_t end = rest.find('\n');
        if (end == std::string_view::npos) {
            table.torn = true;
            break;
        }
        std::string_view line = rest.substr(0, end);
        rest.remove_prefix(end + 1);
        if (line.ends_with('\r'))
            line.remove_suffix(1);
        if (line_number == 1) {
            if (line != columns)
                return Error{"The table of trials is not one of this experiment: its columns are others."};
            continue;
        }
        TrialRecord record;
        if (const std::string problem = take(experiment, in_training, line, record); !problem.empty())
            return Error{"Line " + std::to_string(line_number) + " of the table of trials " + problem + "."};
        table.records.push_back(std::move(record));
    }
    if (line_number == 0)
        return Error{"The table of trials is empty."};
    return table;
}

} // namespace tp
