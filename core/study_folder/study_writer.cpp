// SPDX-License-Identifier: Apache-2.0
#include "core/study_folder/study_writer.hpp"

#include "core/experiment/experiment_file.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"
#include "core/files/growing_file.hpp"
#include "core/files/new_file.hpp"
#include "core/study_folder/path_file.hpp"
#include "core/study_folder/running_trial.hpp"
#include "core/study_folder/study_readme.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <iterator>
#include <set>
#include <system_error>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

namespace {

using Opened = Result<std::unique_ptr<StudyWriter>>;

Error cannot_write(const fs::path& file, const std::string& reason) {
    return Error{"The study cannot write " + quoted(file) + ": " + reason};
}

/// Takes away what a program that was killed left under temporary names; nobody else writes here.
void sweep(const fs::path& folder) {
    std::vector<fs::path> left;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        if (is_temporary(at->path()))
            left.push_back(at->path());
    for (const fs::path& file : left)
        fs::remove(file, error);
}

/// Whether a study may begin there: nothing is in it, or what one that was killed at its beginning had written.
bool is_free(const fs::path& folder) {
    const std::set<fs::path> ours{study_terms_file, study_readme_file, study_paths_folder};
    bool begun = false, free = true;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        const fs::path name = at->path().filename();
        begun = begun || name == study_terms_file;
        free = false;
        if (!ours.contains(name))
            return false;
    }
    return !error && (free || begun);
}

/// The folder's lock, or the sentence that another program has it.
Result<std::unique_ptr<FolderLock>> locked(const fs::path& folder) {
    auto lock = std::make_unique<FolderLock>(folder, std::chrono::milliseconds(0));
    if (!lock->held())
        return Error{"Another program is running the study in " + quoted(folder) +
                     "; end it there, or choose another folder."};
    return lock;
}

/// Whether its line will be read as it is; one that is not would make the whole table unreadable.
bool is_readable(const Experiment& experiment, const TrialRecord& record) {
    const auto back = read_trials(experiment, trial_columns(experiment) + trial_line(experiment, record));
    return back && back->records == std::vector<TrialRecord>{record};
}

} // namespace

Opened StudyWriter::open(const fs::path& folder, const Experiment& experiment, const StudyTerms& terms,
                         const StudyMachine& machine) {
    if (!name_taken(folder / study_protocol_file))
        return begin(folder, experiment, terms, machine);
    auto writer = go_on(folder, machine);
    if (!writer)
        return writer;
    if (experiment_text((*writer)->experiment_) != experiment_text(experiment))
        return Error{"In " + quoted(folder) +
                     " lies a study of another experiment, or of another version of it; choose another "
                     "folder for this one."};
    if ((*writer)->terms_ != terms)
        return Error{"In " + quoted(folder) +
                     " lies a study with another seed or other participants; choose another folder for this "
                     "one."};
    return writer;
}

Opened StudyWriter::begin(const fs::path& folder, const Experiment& experiment, const StudyTerms& terms,
                          const StudyMachine& machine) {
    if (const std::string reason = make_folder(folder); !reason.empty())
        return cannot_write(folder, reason);
    auto lock = locked(folder);
    if (!lock)
        return Error{lock.error()};
    sweep(folder);
    if (!is_free(folder))
        return Error{"The folder " + quoted(folder) +
                     " has other files in it; a study begins in an empty one."};
    // The terms first: by them is_free knows the folder again. The protocol last: where it is, the study has begun.
    for (const auto& [file, text] : {std::pair(folder / study_terms_file, terms_text(terms)),
                                     std::pair(folder / study_readme_file, study_readme(experiment)),
                                     std::pair(folder / study_paths_folder, std::string()),
                                     std::pair(folder / study_protocol_file, experiment_text(experiment))}) {
        const std::string reason = text.empty() ? make_folder(file) : replace_file(file, text);
        if (!reason.empty())
            return cannot_write(file, reason);
    }
    std::unique_ptr<StudyWriter> writer(new StudyWriter(folder, experiment, terms, machine));
    writer->lock_ = std::move(*lock);
    return writer;
}

Opened StudyWriter::go_on(const fs::path& folder, const StudyMachine& machine) {
    if (!name_taken(folder / study_protocol_file))
        return Error{"There is no study in " + quoted(folder) + "."};
    auto lock = locked(folder);
    if (!lock)
        return Error{lock.error()};
    auto study = read_study(folder);
    if (!study)
        return Error{study.error()};
    if (!study->terms)
        return Error{"The study in " + quoted(folder) + " cannot go on: its file " +
                     quoted_readable(study_terms_file) + " is missing."};
    const auto tables = read_tables(folder, study->experiment);
    if (!tables)
        return Error{tables.error()};
    std::unique_ptr<StudyWriter> writer(
        new StudyWriter(folder, std::move(study->experiment), *study->terms, machine));
    writer->lock_ = std::move(*lock);
    writer->sittings_ = std::move(study->sittings);
    for (const ParticipantTable& table : *tables)
        if (const std::string problem = writer->take_table(table); !problem.empty())
            return Error{problem};
    if (const std::string lost = lost_trial(folder, study->records); !lost.empty())
        writer->remarks_.push_back(lost);
    forget_running(folder);
    sweep(folder);
    sweep(folder / study_paths_folder);
    if (const auto file = NewFile::beside(folder / study_sittings_file); !file) // before anybody has begun
        return cannot_write(folder, file.error());
    if (const std::string reason = make_folder(folder / study_paths_folder); !reason.empty())
        return cannot_write(folder / study_paths_folder, reason);
    return writer;
}

/// A sentence where the study cannot go on with it.
std::string StudyWriter::take_table(const ParticipantTable& table) {
    if (table.participant != 0) {
        if (table.file.filename() != participant_file(table.participant))
            return quoted(table.file) + " has the trials of participant " +
                   std::to_string(table.participant) + "; name it " +
                   quoted_readable(participant_file(table.participant)) + ".";
        const auto plan = trials_of(experiment_, table.participant, terms_.seed);
        if (const auto trial = first_unplanned(experiment_, plan, table.records))
            return quoted(table.file) + " cannot be gone on with: its trial " + std::to_string(*trial) +
                   " is not the one that the study has planned.";
    }
    if (table.torn) {
        if (const std::string reason = cut_file(table.file, table.whole_bytes); !reason.empty())
            return cannot_write(table.file, reason).sentence;
        remarks_.push_back(quoted(table.file) +
                           ": the last trial was being written when the program ended; it is done again.");
    }
    if (table.participant != 0)
        tables_[table.participant] = {table.file, table.records, table.whole_bytes, false};
    return {};
}

std::vector<int> StudyWriter::participants() const {
    const std::lock_guard held(mutex_);
    std::vector<int> all;
    for (const auto& [participant, table] : tables_)
        if (!table.records.empty())
            all.push_back(participant);
    return all;
}

std::vector<TrialRecord> StudyWriter::records_of(int participant) const {
    const std::lock_guard held(mutex_);
    const auto table = tables_.find(participant);
    return table == tables_.end() ? std::vector<TrialRecord>() : table->second.records;
}

std::optional<NextTrial> StudyWriter::next(int participant) const {
    const std::vector<TrialRecord> records = records_of(participant);
    return next_trial(experiment_, trials_of(experiment_, participant, terms_.seed), records);
}

void StudyWriter::begins(int participant) const {
    if (const auto trial = next(participant))
        note_running(folder_, participant, trial->number);
}

void StudyWriter::use(const StudyMachine& machine) {
    const std::lock_guard held(mutex_);
    machine_ = machine;
}

std::string StudyWriter::keep(const TrialRecord& record, std::span<const FingerSample> path) {
    const auto planned = record.participant > 0 ? next(record.participant) : std::nullopt;
    if (!planned || !is_of(*planned, record))
        return "The trial was not kept: it is not the one that comes next.";
    if (!is_readable(experiment_, record))
        return "The trial was not kept: its error, time or answer is none that there can be.";
    if (!is_path(path))
        return "The trial was not kept: the finger's path in it is none.";
    const std::string bytes = path_bytes(path);
    const fs::path file = folder_ / study_paths_folder / path_file_name(record.participant, record.trial);
    // The path first, so that a trial in the table has one.
    if (const std::string reason = replace_file(file, bytes); !reason.empty())
        return cannot_write(file, reason).sentence;
    const std::lock_guard held(mutex_);
    if (std::string problem = put_sitting(record.participant, record.trial); !problem.empty())
        return problem;
    if (tables_.size() >= most_study_participants && !tables_.contains(record.participant))
        return "The trial was not kept: a study has at most " + std::to_string(most_study_participants) +
               " participants.";
    Table& table = tables_[record.participant];
    if (table.file.empty())
        table.file = folder_ / participant_file(record.participant);
    if (const std::string reason = put_line(table, record); !reason.empty())
        return cannot_write(table.file, reason).sentence;
    table.records.push_back(record);
    forget_running(folder_);
    return {};
}

/// Where the participant has another machine than before. A sentence where it could not be written.
std::string StudyWriter::put_sitting(int participant, int trial) {
    const auto is_before = [](const StudySitting& a, const StudySitting& b) {
        return std::pair(a.participant, a.from_trial) < std::pair(b.participant, b.from_trial);
    };
    std::vector<StudySitting> sittings = sittings_;
    const StudySitting sitting{participant, trial, machine_};
    // One from this trial on, or later, is of a program that was killed before the trial was kept.
    const std::size_t stale = std::erase_if(sittings, [&](const StudySitting& other) {
        return other.participant == participant && other.from_trial >= trial;
    });
    const auto behind = std::ranges::upper_bound(sittings, sitting, is_before);
    const bool same = behind != sittings.begin() && std::prev(behind)->participant == participant &&
                      std::prev(behind)->machine == machine_;
    if (same && stale == 0)
        return {};
    if (!same)
        sittings.insert(behind, sitting);
    const fs::path file = folder_ / study_sittings_file;
    if (const std::string reason = replace_file(file, sittings_text(sittings)); !reason.empty())
        return cannot_write(file, reason).sentence;
    sittings_ = std::move(sittings);
    return {};
}

/// The reason why not, the end of a sentence.
std::string StudyWriter::put_line(Table& table, const TrialRecord& record) const {
    if (table.size == 0) {
        const std::string columns = trial_columns(experiment_);
        if (std::string reason = replace_file(table.file, columns); !reason.empty())
            return reason;
        table.size = columns.size();
    }
    if (table.unsure)
        if (std::string reason = cut_file(table.file, table.size); !reason.empty())
            return reason;
    table.unsure = false;
    const std::string line = trial_line(experiment_, record);
    std::string reason = append_to_file(table.file, table.size, line);
    if (reason.empty())
        table.size += line.size();
    else
        table.unsure = reason != changed_meanwhile;
    return reason;
}

} // namespace tp
