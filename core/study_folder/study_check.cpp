// SPDX-License-Identifier: Apache-2.0
#include "core/study_folder/study_check.hpp"

#include "core/experiment/next_trial.hpp"
#include "core/files/file_words.hpp"
#include "core/files/folder_lock.hpp"
#include "core/files/new_file.hpp"
#include "core/study_folder/path_file.hpp"
#include "core/study_folder/running_trial.hpp"

#include <algorithm>
#include <chrono>
#include <set>
#include <span>
#include <system_error>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr double rate_tolerance = 0.99; // clocks differ

std::vector<fs::path> names_in(const fs::path& folder) {
    std::vector<fs::path> names;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        names.push_back(at->path().filename());
    std::ranges::sort(names);
    return names;
}

/// Such as "3, 5–9, 12": numbers that grow, in every language.
std::string listed(std::span<const int> numbers) {
    std::string words;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t last = i;
        while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1)
            ++last;
        words += (words.empty() ? "" : ", ") + std::to_string(numbers[i]);
        if (last > i)
            words += (last > i + 1 ? "–" : ", ") + std::to_string(numbers[last]);
        i = last + 1;
    }
    return words;
}

/// The records of each participant, as they follow each other in the study.
std::vector<std::span<const TrialRecord>> by_participant(const StudyFolder& study) {
    std::vector<std::span<const TrialRecord>> all;
    for (auto at = study.records.begin(); at != study.records.end();) {
        const auto end = std::find_if(at, study.records.end(), [&](const TrialRecord& one) {
            return one.participant != at->participant;
        });
        all.emplace_back(at, end);
        at = end;
    }
    return all;
}

class StudyChecker {
public:
    StudyChecker(const fs::path& folder, const StudyFolder& study, const TrialsDone& report,
                 std::stop_token stop)
        : folder_(folder), paths_(folder / study_paths_folder), study_(study), report_(report),
          stop_(std::move(stop)) {}

    StudyFindings check() {
        findings_.running = !FolderLock(folder_, std::chrono::milliseconds(0)).held();
        findings_.faults = study_.remarks;
        if (const std::string lost = lost_trial(folder_, study_.records); !findings_.running && !lost.empty())
            say(lost);
        if (!study_.terms)
            say("There is no file " + quoted_readable(study_terms_file) +
                ": nobody knows the seed of the study, or whether its participants are simulated.");
        for (const auto& records : by_participant(study_)) {
            look_at_plan(records);
            look_at_sittings(records);
            look_at_paths(records);
            if (stop_.stop_requested())
                return findings_;
        }
        look_at_names();
        return findings_;
    }

private:
    void say(const std::string& sentence) { findings_.faults.push_back(sentence); }

    void look_at_plan(std::span<const TrialRecord> records) {
        if (!study_.terms)
            return;
        const int participant = records.front().participant;
        const auto plan = trials_of(study_.experiment, participant, study_.terms->seed);
        if (const auto trial = first_unplanned(study_.experiment, plan, records))
            say("Participant " + std::to_string(participant) + ": trial " + std::to_string(*trial) +
                " is not the one that was planned; protocol, seed or table were changed since.");
    }

    void look_at_sittings(std::span<const TrialRecord> records) {
        const TrialRecord& first = records.front();
        if (study_.terms && std::ranges::none_of(study_.sittings, [&](const StudySitting& sitting) {
                return sitting.participant == first.participant && sitting.from_trial <= first.trial;
            }))
            say("Participant " + std::to_string(first.participant) +
                ": nobody has noted with which machine the first trial was done.");
    }

    void look_at_paths(std::span<const TrialRecord> records) {
        std::vector<int> missing;
        for (const TrialRecord& record : records) {
            if (stop_.stop_requested())
                return;
            const fs::path file = paths_ / path_file_name(record.participant, record.trial);
            known_.insert(file.filename());
            std::error_code error;
            if (!fs::exists(file, error)) {
                missing.push_back(record.trial);
            } else if (const auto path = read_path(file); !path) {
                say(path.error());
            } else if (static_cast<double>(path->size()) <
                       rate_tolerance * least_path_rate_hz * record.time_s) {
                say(quoted(file) + " has " + std::to_string(path->size()) +
                    " samples; in the trial's time there are " +
                    std::to_string(static_cast<long>(least_path_rate_hz * record.time_s)) + " at least.");
            }
            ++done_;
            if (report_)
                report_(done_, study_.records.size());
        }
        if (!missing.empty())
            say("Participant " + std::to_string(records.front().participant) +
                ": the finger's path is missing in these trials: " + listed(missing) + ".");
    }

    void look_at_names() {
        for (const fs::path& folder : {folder_, paths_})
            for (const fs::path& name : names_in(folder))
                if (is_temporary(name))
                    say(quoted(folder / name) +
                        " was being written when the program ended; it goes when the study goes on.");
                else if (folder == paths_ && !known_.contains(name))
                    say(quoted(folder / name) + " belongs to no trial that was kept.");
    }

    const fs::path& folder_;
    fs::path paths_;
    const StudyFolder& study_;
    const TrialsDone& report_;
    std::stop_token stop_;
    StudyFindings findings_;
    std::set<fs::path> known_;
    std::size_t done_ = 0;
};

} // namespace

StudyFindings check_study(const fs::path& folder, const StudyFolder& study, const TrialsDone& report,
                          std::stop_token stop) {
    return StudyChecker(folder, study, report, std::move(stop)).check();
}

} // namespace tp
