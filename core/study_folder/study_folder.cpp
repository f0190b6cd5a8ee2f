// SPDX-License-Identifier: Apache-2.0
#include "core/study_folder/study_folder.hpp"

#include "core/experiment/experiment_file.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"
#include "core/files/whole_file.hpp"

#include <algorithm>
#include <map>
#include <system_error>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

namespace {

std::string about(const fs::path& file, const std::string& problem) { return quoted(file) + ": " + problem; }

/// The names of the participants' tables, in order.
Result<std::vector<fs::path>> tables_in(const fs::path& folder) {
    std::vector<fs::path> tables;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        const std::string name = at->path().filename().string();
        if (name.starts_with("participant-") && name.ends_with(".csv"))
            tables.push_back(at->path());
        if (tables.size() > most_study_participants)
            return Error{"The study has more than " + std::to_string(most_study_participants) +
                         " participants."};
    }
    if (error)
        return Error{"The folder " + quoted(folder) + " cannot be read."};
    std::ranges::sort(tables);
    return tables;
}

} // namespace

std::string participant_file(int participant) {
    std::string number = std::to_string(participant);
    number.insert(0, number.size() < 3 ? 3 - number.size() : 0, '0');
    return "participant-" + number + ".csv";
}

Result<std::vector<ParticipantTable>> read_tables(const fs::path& folder, const Experiment& experiment) {
    const auto files = tables_in(folder);
    if (!files)
        return Error{files.error()};
    std::vector<ParticipantTable> tables;
    std::map<int, fs::path> seen;
    for (const fs::path& file : *files) {
        const auto csv = read_whole(file, most_trial_table_bytes);
        if (!csv)
            return Error{csv.error()};
        auto read = read_trials(experiment, *csv);
        if (!read)
            return Error{about(file, read.error())};
        ParticipantTable table{file, 0, std::move(read->records), read->torn, csv->rfind('\n') + 1};
        if (!table.records.empty()) {
            const int participant = table.participant = table.records.front().participant;
            if (!std::ranges::all_of(table.records, [&](const TrialRecord& record) {
                    return record.participant == participant;
                }))
                return Error{about(file, "the trials of more than one participant are in it.")};
            if (const auto [other, is_new] = seen.emplace(participant, file); !is_new)
                return Error{about(file, "participant " + std::to_string(participant) + " is in " +
                                             quoted(other->second) + " already.")};
        }
        tables.push_back(std::move(table));
    }
    return tables;
}

Result<StudyFolder> read_study(const fs::path& folder) {
    const fs::path protocol = folder / study_protocol_file;
    const auto text = read_whole(protocol, most_experiment_bytes);
    if (!text)
        return Error{text.error()};
    auto experiment = read_experiment(*text);
    if (!experiment)
        return Error{about(protocol, experiment.error())};
    StudyFolder study;
    study.experiment = std::move(*experiment);
    if (const fs::path file = folder / study_terms_file; !is_gone(file)) {
        const auto bytes = read_whole(file, most_terms_bytes);
        if (!bytes)
            return Error{bytes.error()};
        const auto terms = read_terms(*bytes);
        if (!terms)
            return Error{about(file, terms.error())};
        study.terms = *terms;
    }
    if (const fs::path file = folder / study_sittings_file; !is_gone(file)) {
        const auto csv = read_whole(file, most_sittings_bytes);
        if (!csv)
            return Error{csv.error()};
        auto sittings = read_sittings(*csv);
        if (!sittings)
            return Error{about(file, sittings.error())};
        study.sittings = std::move(*sittings);
    }
    const auto tables = read_tables(folder, study.experiment);
    if (!tables)
        return Error{tables.error()};
    for (const ParticipantTable& table : *tables) {
        if (table.torn)
            study.remarks.push_back(about(
                table.file, "the last trial was being written when the program ended; it is left out."));
        study.records.insert(study.records.end(), table.records.begin(), table.records.end());
    }
    return study;
}

std::vector<std::string> study_progress(const StudyFolder& study) {
    struct Done {
        std::map<std::size_t, int> times; ///< of a condition
        int again = 0;
    };
    std::map<int, Done> participants;
    for (const TrialRecord& record : study.records) {
        Done& done = participants[record.participant];
        if (record.repeated)
            ++done.again;
        else if (!record.training)
            ++done.times[record.condition];
    }
    std::vector<std::string> sentences;
    for (const auto& [participant, done] : participants) {
        std::size_t trials = 0, missing = 0;
        for (std::size_t condition = 0; condition < study.experiment.conditions(); ++condition) {
            const auto times = done.times.find(condition);
            const int count = times == done.times.end() ? 0 : times->second;
            trials += static_cast<std::size_t>(count);
            missing += static_cast<std::size_t>(std::max(0, study.experiment.repetitions - count));
        }
        sentences.push_back(
            "Participant " + std::to_string(participant) + ": " + std::to_string(trials) + " trials of " +
            std::to_string(study.experiment.trials()) +
            (done.again > 0 ? ", " + std::to_string(done.again) + " of them done again" : "") +
            (missing > 0 ? "; " + std::to_string(missing) + " are missing." : "."));
    }
    return sentences;
}

} // namespace tp
