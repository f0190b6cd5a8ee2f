// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

inline constexpr std::size_t most_terms_bytes = 64 * 1024;
inline constexpr std::size_t most_sittings_bytes = std::size_t{16} << 20;

/// What holds for a whole study beside its protocol; `study.txt`.
struct StudyTerms {
    std::uint64_t seed = 1; ///< of trials_of, for all participants
    bool simulated = false; ///< the participants are simulated people
    bool operator==(const StudyTerms&) const = default;
};
/// As lines `seed: 42`, `participants: people` or `participants: simulated`; `#` begins a comment.
std::string terms_text(const StudyTerms& terms);
/// Both lines must be there, each once. An error is one sentence with the number of the line.
Result<StudyTerms> read_terms(std::string_view text);

/// With what trials are done from now on. Each text has at most 1000 bytes on one line.
struct StudyMachine {
    std::string date;     ///< as 2026-11-26; the caller's, because simulated people have no day
    std::string software; ///< "touchphoto 0.1.0"
    std::string device;   ///< "force pad", "mouse"
    std::string
        calibration; ///< where the device lies on the surface, and its newtons, in the device's own words
    bool operator==(const StudyMachine&) const = default;
};

/// From which trial on a participant had which machine; a line of `sittings.csv`.
struct StudySitting {
    int participant = 0;
    int from_trial = 0; ///< TrialRecord::trial
    StudyMachine machine;
    bool operator==(const StudySitting&) const = default;
};
/// CSV (RFC 4180): participant, from_trial, date, software, device, calibration.
std::string sittings_text(const std::vector<StudySitting>& sittings);
/// An error is one sentence with the number of the line.
Result<std::vector<StudySitting>> read_sittings(std::string_view csv);

} // namespace tp
