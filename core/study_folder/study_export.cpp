// SPDX-License-Identifier: Apache-2.0
#include "core/study_folder/study_export.hpp"

#include "core/experiment/experiment_file.hpp"
#include "core/files/file_words.hpp"
#include "core/files/new_file.hpp"
#include "core/packing/zip.hpp"
#include "core/study_folder/path_file.hpp"
#include "core/study_folder/running_trial.hpp"
#include "core/study_folder/study_readme.hpp"

#include <map>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

namespace {

/// A participant's table as text, whole lines only; in the order of their numbers.
std::map<int, std::string> tables_of(const StudyFolder& study) {
    std::map<int, std::string> tables;
    for (const TrialRecord& record : study.records) {
        std::string& table = tables[record.participant];
        if (table.empty())
            table = trial_columns(study.experiment);
        table += trial_line(study.experiment, record);
    }
    return tables;
}

/// Whether a study has a file or folder of that name; every table of participants has been read.
bool is_of_study(const std::string& name) {
    for (const char* const ours : {study_protocol_file, study_terms_file, study_sittings_file,
                                   study_readme_file, study_paths_folder, study_running_file})
        if (name == ours)
            return true;
    return name.starts_with("participant-") && name.ends_with(".csv");
}

/// Says what else lies in the folder, but for the zip itself.
void note_others(const fs::path& folder, const fs::path& zip, StudyExport& done) {
    std::set<fs::path> others;
    std::error_code error, unclear;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        if (!is_of_study(at->path().filename().string()) && !is_temporary(at->path()) &&
            !fs::equivalent(at->path(), zip, unclear))
            others.insert(at->path());
    for (const fs::path& other : others)
        done.remarks.push_back(quoted(other) + " is no file of the study; it is not in the zip.");
}

} // namespace

Result<StudyExport> export_study(const fs::path& folder, const fs::path& zip_file, const TrialsDone& report,
                                 const std::stop_token& stop) {
    const auto study = read_study(folder);
    if (!study)
        return Error{study.error()};
    auto file = NewFile::beside(zip_file);
    if (!file)
        return Error{"The study cannot be written to " + quoted(zip_file) + ": " + file.error()};
    StudyExport done;
    done.remarks = study->remarks;
    ZipWriter zip([&](std::string_view bytes) { return file->write(bytes); });
    std::string reason;
    const auto add = [&](const std::string& name, std::string_view bytes, bool is_packed = false) {
        if (reason.empty())
            reason = zip.add(study->experiment.name + "/" + name, bytes, is_packed);
    };
    add(study_readme_file, study_readme(study->experiment));
    add(study_protocol_file, experiment_text(study->experiment));
    if (study->terms)
        add(study_terms_file, terms_text(*study->terms));
    if (!study->sittings.empty())
        add(study_sittings_file, sittings_text(study->sittings));
    for (const auto& [participant, table] : tables_of(*study)) {
        add(participant_file(participant), table);
        ++done.participants;
    }
    for (const TrialRecord& record : study->records) {
        if (stop.stop_requested())
            return Error{"The export was stopped; nothing was written."};
        const std::string name = path_file_name(record.participant, record.trial);
        const auto path = read_path(folder / study_paths_folder / name);
        if (path) {
            add(std::string(study_paths_folder) + "/" + name, path_bytes(*path), true);
            ++done.paths;
        } else {
            done.remarks.push_back(path.error());
        }
        if (++done.trials; report)
            report(done.trials, study->records.size());
    }
    if (reason.empty())
        reason = zip.close();
    if (reason.empty())
        reason = file->take_place();
    if (!reason.empty())
        return Error{"The study cannot be written to " + quoted(zip_file) + ": " + reason};
    note_others(folder, zip_file, done);
    return done;
}

} // namespace tp
