// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/study/expression_cues.hpp"

#include <random>

namespace tp {

/// How exactly a finger takes the cues of a face off the surface. Two lines nearer than 1 mm cannot be told
/// apart by force (DESIGN §4, §7); that each place is felt with an independent error of about the same size
/// is an assumption, and a careful one: a finger passes a place more than once.
struct FingerTouch {
    double noise_mm = 1.0;      ///< standard deviation with which each place is felt; ≥ 0
    double told_apart_mm = 1.0; ///< lips or lids nearer than that are one line; ≥ 0
    double eyes_mm = 100.0;     ///< between the outer corners of the eyes on the surface; > 0

    double percent(double mm) const { return 100.0 * mm / eyes_mm; }
    /// Standard deviation of a cue as felt, percent of the eyes' distance.
    double noise_of(std::size_t cue) const { return percent(noise_mm) * cue_kinds[cue].noise_gain; }
};

/// The exact cues of a face as the finger takes them once: what is too near to be told apart is closed, and
/// every cue has its error. The same for the same state of `random`.
ExpressionCues felt(ExpressionCues cues, const FingerTouch& touch, std::mt19937_64& random);

} // namespace tp
