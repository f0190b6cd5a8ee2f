// SPDX-License-Identifier: Apache-2.0
#include "faces/pieces/fewest_pieces.hpp"

#include "core/geometry/polyline.hpp"
#include "faces/pieces/contour_fit.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace tp {
namespace {

constexpr int looks_per_piece = 16;      ///< places of a candidate that are compared with the curve
constexpr int samples_per_piece = 4;     ///< of the curve itself
constexpr double of_tolerance = 0.88;    ///< allowed at the places compared; the rest is for those between
constexpr double straight = 0.01;        ///< sine of an angle that nobody feels: half a degree
constexpr std::size_t give_up_after = 3; ///< spans in a row that are too long for the tolerance
constexpr std::array<double, 3> handles{0.25, 0.18,
                                        0.33}; ///< of the chord, where two quadratics share a span

/// The curve to be followed between two breaks: joints, directions there, and samples in between.
struct Run {
    std::vector<Vec2> joints;
    std::vector<Vec2> directions;     ///< unit; at each joint
    std::vector<Vec2> samples;        ///< along the curve
    std::vector<std::size_t> sampled; ///< index of each joint among the samples
};

Vec2 unit(Vec2 v) {
    const double size = length(v);
    return size > 0.0 ? v / size : Vec2(0.0);
}

Vec2 direction_at_start(const Piece& piece) {
    if (const auto* q = std::get_if<Quadratic>(&piece); q && q->control != q->a)
        return unit(q->control - q->a);
    return unit(end_of(piece) - start_of(piece));
}

Vec2 direction_at_end(const Piece& piece) {
    if (const auto* q = std::get_if<Quadratic>(&piece); q && q->control != q->b)
        return unit(q->b - q->control);
    return unit(end_of(piece) - start_of(piece));
}

bool turns(const Piece& before, const Piece& after) {
    const Vec2 a = direction_at_end(before), b = direction_at_start(after);
    return std::abs(cross(a, b)) > 1e-6 || glm::dot(a, b) < 0.0;
}

/// `pieces` as fit_contour leaves them: from point to point a line or two quadratics.
Run run_of(const std::vector<Piece>& pieces) {
    Run run;
    run.joints.push_back(start_of(pieces.front()));
    run.directions.push_back(direction_at_start(pieces.front()));
    run.samples.push_back(run.joints.front());
    run.sampled.push_back(0);
    for (std::size_t i = 0; i < pieces.size();) {
        const std::size_t end =
            std::min(i + (std::holds_alternative<Line>(pieces[i]) ? 1 : 2), pieces.size());
        for (; i < end; ++i)
            for (int k = 1; k <= samples_per_piece; ++k)
                run.samples.push_back(point_at(pieces[i], static_cast<double>(k) / samples_per_piece));
        run.joints.push_back(end_of(pieces[end - 1]));
        run.directions.push_back(direction_at_end(pieces[end - 1]));
        run.sampled.push_back(run.samples.size() - 1);
    }
    return run;
}

/// Whether every place of `piece` lies within `tolerance` of the samples [first, last]; both advance
/// together.
bool follows(const Piece& piece, const std::vector<Vec2>& samples, std::size_t& at, std::size_t last,
             double tolerance) {
    for (int k = 1; k <= looks_per_piece; ++k) {
        const Vec2 place = point_at(piece, static_cast<double>(k) / looks_per_piece);
        const auto away = [&](std::size_t s) {
            const Vec2 gap = place - nearest_on_segment(samples[s], samples[s + 1], place);
            return glm::dot(gap, gap);
        };
        double distance = away(at);
        for (std::size_t ahead = at + 1; ahead < last; ++ahead) {
            const double next = away(ahead);
            if (next > distance && ahead > at + 2)
                break;
            if (next <= distance) {
                distance = next;
                at = ahead;
            }
        }
        if (!(distance <= tolerance * tolerance))
            return false;
    }
    return true;
}

bool follow(const std::vector<Piece>& pieces, const Run& run, std::size_t from, std::size_t to,
            double tolerance) {
    std::size_t at = run.sampled[from];
    for (const Piece& piece : pieces)
        if (!follows(piece, run.samples, at, run.sampled[to], tolerance))
            return false;
    return true;
}

/// One piece, or two where `allowed`, from joint `from` to joint `to` that keep both directions and the
/// tolerance.
std::optional<std::vector<Piece>> span(const Run& run, std::size_t from, std::size_t to, double tolerance,
                                       std::size_t allowed) {
    const Vec2 a = run.joints[from], b = run.joints[to];
    const Vec2 leaving = run.directions[from], arriving = run.directions[to];
    const double chord = length(b - a);
    if (!(chord > 0.0))
        return std::nullopt;
    const Vec2 along = (b - a) / chord;
    std::vector<Piece> pieces;
    const bool forwards = glm::dot(leaving, along) > 0.0 && glm::dot(arriving, along) > 0.0;
    if (forwards && std::abs(cross(leaving, along)) < straight &&
        std::abs(cross(arriving, along)) < straight) {
        pieces = {Line{a, b}};
        if (follow(pieces, run, from, to, tolerance))
            return pieces;
    }
    const double turn = cross(leaving, arriving);
    if (std::abs(turn) > 1e-9) {
        const double reach = cross(b - a, arriving) / turn, back = cross(leaving, b - a) / turn;
        if (reach > 0.0 && back > 0.0 && reach + back < 3.0 * chord) {
            pieces = {Quadratic{a, a + reach * leaving, b}};
            if (follow(pieces, run, from, to, tolerance))
                return pieces;
        }
    }
    if (allowed < 2)
        return std::nullopt;
    for (double handle : handles) {
        const Vec2 first = a + handle * chord * leaving, second = b - handle * chord * arriving;
        const Vec2 middle = 0.5 * (first + second);
        pieces = {Quadratic{a, first, middle}, Quadratic{middle, second, b}};
        if (follow(pieces, run, from, to, tolerance))
            return pieces;
    }
    return std::nullopt;
}

std::vector<Piece> fewest(const std::vector<Piece>& exact, double tolerance) {
    const Run run = run_of(exact);
    const std::size_t count = run.joints.size();
    constexpr std::size_t unreached = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> cost(count, unreached);
    std::vector<std::size_t> before(count, 0);
    std::vector<std::vector<Piece>> arriving(count);
    cost[0] = 0;
    for (std::size_t from = 0; from + 1 < count; ++from) {
        if (cost[from] == unreached)
            continue;
        std::size_t failures = 0;
        for (std::size_t to = from + 1; to < count && failures < give_up_after; ++to) {
            const std::size_t allowed = cost[to] > cost[from] + 2 ? 2
                                        : cost[to] > cost[from]   ? cost[to] - cost[from] - 1
                                                                  : 0;
            if (allowed == 0)
                continue;
            auto pieces = span(run, from, to, tolerance, allowed);
            if (pieces)
                failures = 0;
            else if (allowed == 2)
                ++failures;
            if (pieces) {
                cost[to] = cost[from] + pieces->size();
                before[to] = from;
                arriving[to] = std::move(*pieces);
            }
        }
    }
    if (cost.back() == unreached)
        return exact;
    std::vector<Piece> pieces;
    for (std::size_t at = count - 1; at > 0; at = before[at])
        pieces.insert(pieces.begin(), arriving[at].begin(), arriving[at].end());
    return pieces;
}

} // namespace

Contour fewest_pieces(std::string name, const std::vector<Vec2>& points, bool closed,
                      const std::vector<std::size_t>& corners, double tolerance) {
    Contour contour = fit_contour(std::move(name), points, closed, corners);
    std::vector<Piece> pieces;
    for (auto begin = contour.pieces.begin(); begin != contour.pieces.end();) {
        auto end = begin + 1;
        while (end != contour.pieces.end() && !turns(*(end - 1), *end))
            ++end;
        const std::vector<Piece> fitted = fewest({begin, end}, of_tolerance * tolerance);
        pieces.insert(pieces.end(), fitted.begin(), fitted.end());
        begin = end;
    }
    contour.pieces = std::move(pieces);
    return contour;
}

} // namespace tp
