// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/study_folder/study_folder.hpp"

#include <cstddef>
#include <optional>

namespace tp {

/// A study in a few numbers, as far as it has come. Means are over the trials that count: neither training nor done again.
struct StudySummary {
    std::size_t participants = 0;   ///< with a trial of any kind
    std::size_t trials = 0;         ///< that count
    std::size_t repeated = 0;       ///< that were done again
    std::optional<double> error_mm; ///< mean; nothing where no trial that counts has one
    std::optional<double> time_s;   ///< mean
    std::optional<double> right;    ///< share that was named rightly; nothing where nothing is named
};

StudySummary summary_of(const StudyFolder& study);

} // namespace tp
