// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/statistics/within_table.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// A level of a factor, over all levels of the others.
struct LevelMean {
    std::string level;
    double mean{};
    std::optional<double> standard_error; ///< of the participants' means; none with one participant
    /// Levels that have one in common do not differ (Piepho, Journal of Computational and Graphical Statistics 13, 2004); "a" has
    /// the smallest mean. Empty where nothing can be compared.
    std::string letters{};
};

/// Two levels, by their indices.
struct LevelPair {
    std::size_t one, other;
    double difference{}; ///< of the other's mean from the one's
    double p{};          ///< that some two of all levels are so far apart by chance
};

struct Pairwise {
    std::vector<LevelMean> levels;
    std::vector<LevelPair>
        pairs; ///< none with one participant, or where the participants do not differ at all
};

/// Which levels of a factor differ: Tukey's honestly significant difference, with the error of this factor between participants.
/// `least_p`: levels differ where p is below it.
Pairwise tukey_hsd(const WithinMeans& means, std::size_t factor, double least_p = 0.05);

/// The letters for `count` levels, in the order in which they stand, where those pairs differ.
std::vector<std::string> letter_groups(std::size_t count, const std::vector<LevelPair>& differing);

} // namespace tp
