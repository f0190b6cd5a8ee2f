// SPDX-License-Identifier: Apache-2.0
#include "core/participant/felt_shape.hpp"

#include "core/participant/way_belief.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace tp {
namespace {

constexpr double once = 2.0 * std::numbers::pi;
constexpr std::size_t parts = 60; // of the way about: divides by 3, 4, 5 and 6
constexpr double error_changes_mm =
    30.0; // way over which the error of remembered places is another one (assumed)

/// A polygon can be turned until it explains two of about two dozen independent errors, a dozen of places and a dozen of headings; a
/// circle cannot.
constexpr double by_chance = 24.0 / 22.0;

using Radii = std::array<double, parts>;
/// The angle of the way against that of a circle in each direction, radians counter clockwise, whichever way round; nothing where no
/// place was felt.
using Turns = std::array<std::optional<double>, parts>;

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }
Vec2 rotated(Vec2 v, double angle) {
    return {std::cos(angle) * v.x - std::sin(angle) * v.y, std::sin(angle) * v.x + std::cos(angle) * v.y};
}

/// Standard deviations of what is remembered of a shape of this size (mm from its middle).
struct Memory {
    double place_mm, heading_deg;
};

Memory memory_of(const Person& person, double size_mm) {
    return {std::max(person.joint_mm, std::min(person.place_mm, person.length_share * size_mm)),
            std::hypot(person.heading_deg, std::atan2(person.joint_mm, size_mm) * 360.0 / once)};
}

Vec2 middle_of(std::span<const FeltPlace> round) {
    Vec2 low = round.front().place, high = low;
    for (const FeltPlace& felt : round) {
        low = glm::min(low, felt.place);
        high = glm::max(high, felt.place);
    }
    return 0.5 * (low + high);
}

std::size_t part_of(Vec2 from_middle) {
    const double share = std::atan2(from_middle.y, from_middle.x) / once + 0.5;
    return std::min(parts - 1, static_cast<std::size_t>(share * parts));
}

/// How far the places lie from the middle in each direction; nothing where some eighth of the way about has none.
std::optional<Radii> radii_of(const std::vector<Vec2>& places, Vec2 middle) {
    std::array<std::vector<double>, parts> all;
    for (const Vec2 place : places)
        all[part_of(place - middle)].push_back(length(place - middle));
    Radii radii{};
    std::vector<std::size_t> known;
    for (std::size_t i = 0; i < parts; ++i)
        if (!all[i].empty()) {
            std::ranges::nth_element(all[i], all[i].begin() + static_cast<std::ptrdiff_t>(all[i].size() / 2));
            radii[i] = all[i][all[i].size() / 2];
            known.push_back(i);
        }
    for (std::size_t k = 0; k < known.size(); ++k) { // straight between the directions that are known
        const std::size_t from = known[k];
        const std::size_t to = known[(k + 1) % known.size()];
        const std::size_t gap = known.size() == 1 ? parts : (to + parts - from) % parts;
        if (gap > parts / 8)
            return std::nullopt;
        for (std::size_t step = 1; step < gap; ++step) {
            const double share = static_cast<double>(step) / static_cast<double>(gap);
            radii[(from + step) % parts] = (1.0 - share) * radii[from] + share * radii[to];
        }
    }
    return known.empty() ? std::nullopt : std::optional(radii);
}

Turns turns_of(const std::vector<FeltPlace>& round) {
    Vec2 middle(0.0); // of the way: a triangle's lies elsewhere than that of its extent
    for (const FeltPlace& felt : round)
        middle += felt.place / static_cast<double>(round.size());
    double area = 0.0;
    for (const FeltPlace& felt : round)
        area += cross(felt.place - middle, felt.heading);
    std::array<Vec2, parts> ways{};
    for (const FeltPlace& felt : round) {
        const Vec2 out = felt.place - middle;
        const Vec2 circle = area < 0.0 ? Vec2(out.y, -out.x) : Vec2(-out.y, out.x);
        if (length(out) > 0.0)
            ways[part_of(out)] +=
                Vec2(glm::dot(circle, felt.heading), cross(circle, felt.heading)) / length(out);
    }
    Turns turns;
    for (std::size_t i = 0; i < parts; ++i)
        if (ways[i] != Vec2(0.0))
            turns[i] = std::atan2(ways[i].y, ways[i].x);
    return turns;
}

/// From a corner of a polygon to the direction `angle`.
double behind_corner(double angle, double side) { return angle - side * std::floor(angle / side); }

/// Of a polygon round which a circle of radius 1 goes, in the direction `angle` from one of its corners.
double polygon_radius(double angle, int corners) {
    if (corners == 0)
        return 1.0;
    const double side = once / corners;
    return std::cos(0.5 * side) / std::cos(behind_corner(angle, side) - 0.5 * side);
}

/// The angle of its side there against that of the circle.
double polygon_turn(double angle, int corners) {
    const double side = once / std::max(1, corners);
    return corners == 0 ? 0.0 : 0.5 * side - behind_corner(angle, side);
}

/// Mean square of what is left of the headings, radians².
double misfit_of_turns(const Turns& turns, int corners, double turn) {
    double left = 0.0;
    std::size_t known = 0;
    for (std::size_t i = 0; i < parts; ++i)
        if (turns[i]) {
            const double angle = once * (static_cast<double>(i) + 0.5) / parts;
            const double rest = *turns[i] - polygon_turn(angle + turn, corners);
            left += rest * rest;
            ++known;
        }
    return known == 0 ? 0.0 : left / static_cast<double>(known);
}

/// Mean square of what is left beside the best polygon of so many corners, of any size, turn and place near the middle: of places as a
/// share of the square of its radius, and `weight` times that of headings.
double misfit(const Radii& radii, const Turns& turns, double weight, int corners) {
    double best = std::numeric_limits<double>::infinity();
    const int phases = corners == 0 ? 1 : 30;
    for (int phase = 0; phase < phases; ++phase) {
        const double turn = once / std::max(1, corners) * phase / phases;
        Radii shape{};
        double both = 0.0, squares = 0.0;
        for (std::size_t i = 0; i < parts; ++i) {
            const double angle = once * (static_cast<double>(i) + 0.5) / parts;
            shape[i] = polygon_radius(angle + turn, corners);
            both += shape[i] * radii[i];
            squares += shape[i] * shape[i];
        }
        const double radius = both / squares;
        double left = 0.0, right = 0.0, up = 0.0; // and how far it lies to the right of the middle, and above
        for (std::size_t i = 0; i < parts; ++i) {
            const double angle = once * (static_cast<double>(i) + 0.5) / parts;
            const double rest = radii[i] - radius * shape[i];
            left += rest * rest;
            right += rest * std::cos(angle);
            up += rest * std::sin(angle);
        }
        left -= 2.0 / parts * (right * right + up * up);
        best =
            std::min(best, left / parts / (radius * radius) + weight * misfit_of_turns(turns, corners, turn));
    }
    return best;
}

} // namespace

std::optional<std::size_t> round_end(std::span<const FeltPlace> trail, std::size_t from, double place_mm) {
    double farthest = 0.0;
    for (std::size_t i = from + 1; i < trail.size(); ++i) {
        const double away = length(trail[i].place - trail[from].place);
        farthest = std::max(farthest, away);
        if (farthest < 3.0 * place_mm || away > 1.5 * place_mm)
            continue;
        const auto round = trail.subspan(from, i + 1 - from);
        std::vector<Vec2> places;
        for (const FeltPlace& felt : round)
            places.push_back(felt.place);
        if (radii_of(places, middle_of(round)))
            return i + 1;
    }
    return std::nullopt;
}

std::optional<ShapeMisfits> misfits_of(std::span<const FeltPlace> round, const Person& person,
                                       Chance& chance) {
    if (round.empty())
        return std::nullopt;
    double size = 0.0;
    const Vec2 middle = middle_of(round);
    for (const FeltPlace& felt : round)
        size = std::max(size, length(felt.place - middle));
    const auto [error_mm, error_deg] = memory_of(person, size);
    // Twice smoothed, so that places near each other keep their order.
    Vec2 drift{chance.normal(), chance.normal()};
    Vec2 error = drift / std::sqrt(2.0);
    double turn = chance.normal();
    std::vector<FeltPlace> remembered;
    std::vector<Vec2> places;
    for (std::size_t i = 0; i < round.size(); ++i) {
        if (i > 0) {
            const double kept = std::exp(-length(round[i].place - round[i - 1].place) / error_changes_mm);
            const double fresh = std::sqrt(1.0 - kept * kept);
            drift = kept * drift + fresh * Vec2{chance.normal(), chance.normal()};
            error = kept * error + (1.0 - kept) * drift;
            turn = kept * turn + fresh * chance.normal();
        }
        places.push_back(round[i].place + std::sqrt(2.0) * error_mm * error);
        remembered.push_back({places.back(), rotated(round[i].heading, radians(error_deg) * turn)});
    }
    const auto radii = radii_of(places, middle_of(round));
    if (!radii)
        return std::nullopt;
    const Turns turns = turns_of(remembered);
    // Each as much as it is worth: a heading was steered by pulls whose direction is felt so inexactly.
    const double share = error_mm / size, steered = radians(person.direction_deg);
    const double weight = share * share / (steered * steered);
    ShapeMisfits misfits{};
    for (std::size_t shape = 0; shape < shape_corners.size(); ++shape)
        misfits[shape] = misfit(*radii, turns, weight, shape_corners[shape]) *
                         (shape_corners[shape] > 0 ? by_chance : 1.0);
    return misfits;
}

std::optional<int> ShapeNamer::hear(std::span<const FeltPlace> trail) {
    constexpr double sure = 1.5;   // the second best leaves so much more unexplained (assumed)
    if (trail.size() < looked_at_) // the hand turned round
        from_ = std::min(from_, trail.size());
    if (trail.size() == looked_at_)
        return std::nullopt;
    looked_at_ = trail.size();
    if (const auto named = by_the_way(trail))
        return named;
    const auto end = round_end(trail, from_, person_.place_mm);
    if (!end)
        return std::nullopt;
    const auto misfits = misfits_of(trail.subspan(from_, *end - from_), person_, chance_);
    from_ = *end - 1;
    if (!misfits)
        return std::nullopt;
    for (std::size_t i = 0; i < misfits_.size(); ++i)
        misfits_[i] += (*misfits)[i];
    ++rounds_;
    ShapeMisfits sorted = misfits_;
    std::ranges::sort(sorted);
    return rounds_ >= person_.most_rounds || sorted[1] > sure * sorted[0] ? guess() : std::nullopt;
}

/// Where the way is long enough since it was asked last. What is remembered of a place stays as it is.
std::optional<int> ShapeNamer::by_the_way(std::span<const FeltPlace> trail) {
    constexpr std::size_t between = 10; // places
    // How near the line a finger is that follows it, and for how long it keeps to that side (assumed).
    constexpr WayError tracked_mm{2.0, 20.0};
    constexpr double steered_way_mm = 30.0;
    errors_.resize(std::min(errors_.size(), trail.size()));
    believed_at_ = std::min(believed_at_, trail.size());
    for (std::size_t i = errors_.size(); i < trail.size(); ++i) {
        const double kept =
            i == 0 ? 0.0 : std::exp(-length(trail[i].place - trail[i - 1].place) / error_changes_mm);
        drift_ = kept * drift_ + std::sqrt(1.0 - kept * kept) * Vec2{chance_.normal(), chance_.normal()};
        error_ = kept * error_ + (1.0 - kept) * drift_;
        turn_ = kept * turn_ + std::sqrt(1.0 - kept * kept) * chance_.normal();
        errors_.push_back({std::sqrt(2.0) * error_, turn_});
    }
    if (trail.size() < believed_at_ + between)
        return std::nullopt;
    believed_at_ = trail.size();
    double size = 0.0;
    const Vec2 middle = middle_of(trail);
    for (const FeltPlace& felt : trail)
        size = std::max(size, length(felt.place - middle));
    const auto [error_mm, error_deg] = memory_of(person_, size);
    std::vector<FeltPlace> way;
    for (std::size_t i = 0; i < trail.size(); i += 2)
        way.push_back({trail[i].place + error_mm * errors_[i].place,
                       rotated(trail[i].heading, radians(error_deg) * errors_[i].turn)});
    const ShapeBeliefs beliefs = beliefs_of(
        way, {WayError{error_mm, 4.0 * error_changes_mm}, tracked_mm},
        {WayError{error_deg, 2.0 * error_changes_mm}, WayError{person_.direction_deg, steered_way_mm}});
    const auto best = std::ranges::max_element(beliefs);
    return *best >= sure_belief
               ? std::optional(shape_corners[static_cast<std::size_t>(best - beliefs.begin())])
               : std::nullopt;
}

std::optional<int> ShapeNamer::guess() const {
    if (rounds_ == 0)
        return std::nullopt;
    return shape_corners[static_cast<std::size_t>(std::ranges::min_element(misfits_) - misfits_.begin())];
}

} // namespace tp
