// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/chance.hpp"
#include "core/participant/study_hand.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tp {

/// What a closed line without eyes can be taken for: a circle, or a polygon of that many equal sides.
inline constexpr std::array<int, 5> shape_corners{0, 3, 4, 5, 6}; ///< 0: a circle

inline constexpr double sure_belief = 0.9; ///< in an answer, before it is given (assumed)

/// How unlike each of these a round was, in their order: the mean square of what lies between the places felt and the best polygon of
/// so many corners, as a share of the square of its radius, and that of the headings, weighted by how surely either is known.
using ShapeMisfits = std::array<double, shape_corners.size()>;

/// Where a round that begins at `from` of a trail ends: the finger has been everywhere about its middle, and the place is as it was at
/// first, within what is remembered of places (`place_mm`). The number behind its last place; nothing where the round is not over.
std::optional<std::size_t> round_end(std::span<const FeltPlace> trail, std::size_t from, double place_mm);

/// Judges a round by its places and by how its way turned: which regular polygon has its corners and sides where they are. Both are
/// remembered with the person's errors, which change over some centimetres of way. Nothing where too many directions have no place.
std::optional<ShapeMisfits> misfits_of(std::span<const FeltPlace> round, const Person& person,
                                       Chance& chance);

/// Feels its way round until it is sure what it is: where one shape is as probable as `sure_belief` by the way so far (a sequential
/// test: Wald, "Sequential tests of statistical hypotheses", Annals of Mathematical Statistics 16, 1945), else by one round after the
/// other.
class ShapeNamer {
public:
    ShapeNamer(const Person& person, std::uint64_t seed) : person_(person), chance_(seed) {}
    /// The hand's trail so far. The number of the shape's corners once it is sure, or has gone round as often as it will.
    std::optional<int> hear(std::span<const FeltPlace> trail);
    /// The best that can be said: of the rounds so far; nothing before the first one.
    std::optional<int> guess() const;
    int rounds() const { return rounds_; }

private:
    Person person_;
    Chance chance_;
    std::optional<int> by_the_way(std::span<const FeltPlace> trail);
    std::size_t from_ = 0, looked_at_ = 0, believed_at_ = 0;
    /// Of a place of the trail as it is remembered, in standard deviations.
    struct Error {
        Vec2 place;
        double turn;
    };
    std::vector<Error> errors_;
    Vec2 drift_{0.0}, error_{0.0};
    double turn_ = 0.0;
    ShapeMisfits misfits_{}; ///< sums over the rounds
    int rounds_ = 0;
};

} // namespace tp
