// SPDX-License-Identifier: Apache-2.0
#include "core/friction/crossing_finder.hpp"

#include "core/friction/orientation.hpp"

#include <algorithm>
#include <tuple>

namespace tp {

namespace {

/// Left of a → b (1) or right of it (-1), of a place that is moved by (ε, ε²). `a` and `b` differ.
int side_of_place(Vec2 a, Vec2 b, Vec2 place) {
    if (const int side = orientation(a, b, place))
        return side;
    return std::tie(b.y, a.x) < std::tie(a.y, b.x) ? 1 : -1;
}

/// Left of the way (1) or right of it (-1), of a way that is moved by (ε, ε²). `from` and `to` differ.
int side_of_vertex(Vec2 from, Vec2 to, Vec2 vertex) {
    if (const int side = orientation(from, to, vertex))
        return side;
    return std::tie(from.y, to.x) < std::tie(to.y, from.x) ? 1 : -1;
}

/// Which way the step crosses the segment: 1 to its left, -1 to its right, 0 not at all.
int crossed_to(Vec2 a, Vec2 b, Vec2 from, Vec2 to) {
    const int begins = side_of_place(a, b, from);
    const int ends = side_of_place(a, b, to);
    if (begins == ends || side_of_vertex(from, to, a) == side_of_vertex(from, to, b))
        return 0;
    return ends;
}

/// At which share of the step it meets the line through a and b.
double share_of_step(Vec2 a, Vec2 b, Vec2 from, Vec2 to) {
    const double begins = cross(b - a, from - a);
    const double ends = cross(b - a, to - a);
    const double share = begins / (begins - ends);
    return share > 0.0 ? std::min(share, 1.0) : 0.0;
}

} // namespace

void StepCrossings::insert(const LineCrossing& crossing) noexcept {
    std::size_t place = count_;
    while (place > 0 && crossing.share < kept_[place - 1].share)
        --place;
    if (count_ == room) {
        ++left_out_;
        if (place == room)
            return;
    } else {
        ++count_;
    }
    for (std::size_t i = count_ - 1; i > place; --i)
        kept_[i] = kept_[i - 1];
    kept_[place] = crossing;
}

CrossingFinder::CrossingFinder(const FlatScene& scene) {
    for (std::size_t contour = 0; contour < scene.lines.size(); ++contour) {
        closed_.push_back(static_cast<char>(scene.lines[contour].closed));
        take(scene.lines[contour], static_cast<int>(contour));
    }
    SegmentSet set;
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
        const Piece& piece = pieces_[i];
        set.segments.emplace_back(piece.a, piece.b);
        set.owners.push_back(piece.contour);
        set.numbers.push_back(i);
        right_end_ = std::max({right_end_, piece.a.x, piece.b.x});
    }
    sort_along_hilbert_curve(set, Repeats::kept);
    tree_ = SegmentTree(set);
    in_order_ = std::move(set.numbers);
}

/// A line's segments, joined where one begins exactly where another ends.
void CrossingFinder::take(const Polyline& line, int contour) {
    const auto first = static_cast<std::uint32_t>(pieces_.size());
    for (std::size_t i = 0; i < line.segment_count(); ++i) {
        const Vec2 a = line.segment_start(i);
        const Vec2 b = line.segment_end(i);
        if (!is_finite(a) || !is_finite(b) || a == b)
            continue;
        const auto number = static_cast<std::uint32_t>(pieces_.size());
        Piece piece{a, b, contour, static_cast<std::uint32_t>(i)};
        if (number > first && pieces_.back().b == a) {
            piece.before = number - 1;
            pieces_.back().behind = number;
        }
        pieces_.push_back(piece);
    }
    if (!line.closed || pieces_.size() == first)
        return;
    const auto last = static_cast<std::uint32_t>(pieces_.size()) - 1;
    if (pieces_[last].b == pieces_[first].a) {
        pieces_[first].before = last;
        pieces_[last].behind = first;
    }
}

/// A crossed piece whose end the step passes exactly, where the piece that it is joined to there is crossed back.
bool CrossingFinder::touches_at(const Piece& piece, Vec2 from, Vec2 to) const noexcept {
    const auto crossed_back = [&](std::uint32_t neighbour, Vec2 joint) {
        if (neighbour == nobody || orientation(from, to, joint) != 0)
            return false;
        const Piece& other = pieces_[neighbour];
        return crossed_to(other.a, other.b, from, to) == -crossed_to(piece.a, piece.b, from, to);
    };
    return crossed_back(piece.before, piece.a) || crossed_back(piece.behind, piece.b);
}

template <typename Crossed>
void CrossingFinder::for_each_crossed(Vec2 from, Vec2 to, Crossed crossed) const noexcept {
    tree_.for_each_near(glm::min(from, to), glm::max(from, to), [&](std::uint32_t candidate) {
        const Piece& piece = pieces_[in_order_[candidate]];
        if (const int side = crossed_to(piece.a, piece.b, from, to))
            crossed(piece, side);
    });
}

void CrossingFinder::find(Vec2 from, Vec2 to, StepCrossings& found) const noexcept {
    found.clear();
    for_each_crossed(from, to, [&](const Piece& piece, int side) {
        if (touches_at(piece, from, to))
            return;
        const double share = share_of_step(piece.a, piece.b, from, to);
        found.insert(
            {piece.contour, piece.segment, share, from + share * (to - from), piece.b - piece.a, side > 0});
    });
}

bool CrossingFinder::inside(Vec2 place, std::span<const char> marked) const noexcept {
    bool within = false;
    for_each_crossed(place, Vec2(std::max(place.x, right_end_) + 1.0, place.y), [&](const Piece& piece, int) {
        const auto contour = static_cast<std::size_t>(piece.contour);
        within ^= closed_[contour] != 0 && marked[contour] != 0;
    });
    return within;
}

} // namespace tp
