// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/scene.hpp"
#include "core/guidance/segment_tree.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tp {

/// Where the way of a finger crosses a line.
struct LineCrossing {
    int contour{};           ///< index into the FlatScene
    std::uint32_t segment{}; ///< of that contour's line
    double share{};          ///< of the step, 0 at its beginning … 1 at its end
    Vec2 place{};            ///< mm
    Vec2 along{};            ///< of the segment as it was drawn, mm; never zero
    bool to_left{};          ///< of the line as it was drawn
};

/// The crossings of one step, in their order along it; room for so many that a finger cannot feel more.
class StepCrossings {
public:
    static constexpr std::size_t room = 32;

    void clear() noexcept { count_ = left_out_ = 0; }
    void insert(const LineCrossing& crossing) noexcept;
    std::span<const LineCrossing> list() const noexcept { return {kept_.data(), count_}; }
    /// Later ones for which there was no room.
    std::size_t left_out() const noexcept { return left_out_; }

private:
    std::array<LineCrossing, room> kept_{};
    std::size_t count_ = 0;
    std::size_t left_out_ = 0;
};

/// Finds what a finger's steps cross, exactly: each segment of the way against the segments of the scene, decided by
/// `orientation`. Queries allocate nothing, lock nothing, throw nothing and change nothing.
///
/// A way is taken for what it would be a nothing farther right and up (by ε and ε², ε → 0), so that no place lies on a line
/// and no step passes through a vertex: simulation of simplicity (Edelsbrunner, Mücke, ACM Transactions on Graphics 9,
/// 1990). So a closed line is crossed evenly often by a way that ends on the side where it began, wherever it passes: through
/// a vertex or the seam it crosses once, along a segment at one end of it or not at all. Where a step only touches a vertex
/// from outside, nothing is crossed. A finger that comes to lie exactly on a line has crossed it or has not, and crosses it
/// back, if it had, when it goes away again on the side from which it came.
///
/// Of lines that lie on one another each is crossed. Segments of length zero are none; those with a coordinate that is not
/// finite are left out.
class CrossingFinder {
public:
    explicit CrossingFinder(const FlatScene& scene);

    /// What the step from `from` to `to` (mm, finite) crosses, in its order.
    void find(Vec2 from, Vec2 to, StepCrossings& found) const noexcept;
    /// Whether a place lies inside those contours that are marked (one mark a contour of the scene): inside an odd number of
    /// them, so that marked lips round a marked mouth are the lips alone. Open contours have no inside.
    bool inside(Vec2 place, std::span<const char> marked) const noexcept;
    bool closed(int contour) const { return closed_[static_cast<std::size_t>(contour)] != 0; }

    std::size_t segment_count() const { return pieces_.size(); }

private:
    static constexpr std::uint32_t nobody = ~std::uint32_t(0);
    struct Piece {
        Vec2 a, b; ///< mm, as it was drawn
        int contour;
        std::uint32_t segment;
        std::uint32_t before = nobody, behind = nobody; ///< the pieces that it is joined to
    };

    void take(const Polyline& line, int contour);
    bool touches_at(const Piece& piece, Vec2 from, Vec2 to) const noexcept;
    template <typename Crossed>
    void for_each_crossed(Vec2 from, Vec2 to, Crossed crossed) const noexcept;

    std::vector<Piece> pieces_;
    std::vector<char> closed_;            ///< one a contour
    std::vector<std::uint32_t> in_order_; ///< the pieces as the tree has them
    SegmentTree tree_;
    double right_end_{}; ///< mm, beyond all lines
};

} // namespace tp
