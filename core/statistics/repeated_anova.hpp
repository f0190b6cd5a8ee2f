// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/statistics/within_table.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// What a factor, or several together (an interaction), does to the mean.
struct WithinEffect {
    std::vector<std::size_t> factors; ///< indices
    double sum{};                     ///< of squares
    double df{};
    double error_sum{}; ///< of squares, of the same between participants
    double error_df{};
    /// None with one participant, or where the participants do not differ in it at all.
    std::optional<double> f;
    std::optional<double> p; ///< that F is at least so large by chance
    std::optional<double>
        epsilon; ///< how spherical the differences are, 1/df … 1 (Greenhouse and Geisser, 1959)
    std::optional<double> p_spherical; ///< the p with both degrees of freedom times `epsilon`
    /// Of all that varies but other factors (Olejnik and Algina, Psychological Methods 8, 2003). None where nothing varies.
    std::optional<double> eta_squared;
};

struct RepeatedAnova {
    std::vector<WithinEffect> effects; ///< main effects first, then interactions
    double participants_sum{};         ///< of squares, between participants
    std::string remark;                ///< why there is no F; empty where there is
};

/// The analysis of variance of an experiment in which everybody did everything, exactly: all cells are turned into orthonormal
/// contrasts once (Helmert's, along each factor), and each effect is read off its own.
RepeatedAnova repeated_anova(const WithinMeans& means);

/// "stiffness × path"
std::string words_for(const WithinEffect& effect, const std::vector<Factor>& factors);

} // namespace tp
