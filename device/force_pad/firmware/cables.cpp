// SPDX-License-Identifier: Apache-2.0
#include "device/force_pad/firmware/cables.hpp"

namespace tp::pad {

namespace {

constexpr int longest_polygon = 4 + 2 * cable_count;

template <typename Real>
struct Directions {
    Vec<Real> unit[cable_count]; ///< from the knob to each exit; zero where it is on the exit
};

template <typename Real>
Directions<Real> directions(const CableFrame<Real>& frame, Vec<Real> place) {
    Directions<Real> to;
    for (int i = 0; i < cable_count; ++i) {
        const Vec<Real> way = frame.exits[i] - place;
        const Real distance = length(way);
        if (distance > 0)
            to.unit[i] = (Real(1) / distance) * way;
    }
    return to;
}

/// AAᵀ of the cables' directions: what their tensions make in the two axes of the plane.
template <typename Real>
class Crossed {
public:
    void add(Vec<Real> unit) {
        xx_ += unit.x * unit.x;
        xy_ += unit.x * unit.y;
        yy_ += unit.y * unit.y;
    }
    /// Solves AAᵀ·x = b; false, and x left as it is, where all cables lie nearly in one line.
    bool solve(Vec<Real> b, Vec<Real>& x) const {
        const Real determinant = xx_ * yy_ - xy_ * xy_; // 4 at best
        if (!(determinant > Real(1e-4)))
            return false;
        x = {(yy_ * b.x - xy_ * b.y) / determinant, (xx_ * b.y - xy_ * b.x) / determinant};
        return true;
    }

private:
    Real xx_ = 0;
    Real xy_ = 0;
    Real yy_ = 0;
};

template <typename Real>
struct Polygon {
    Vec<Real> corners[longest_polygon];
    int count = 0;

    /// Keeps what lies where normal·p ≤ bound.
    void clip(Vec<Real> normal, Real bound) {
        Polygon kept;
        for (int i = 0; i < count; ++i) {
            const Vec<Real> a = corners[i];
            const Vec<Real> b = corners[i + 1 < count ? i + 1 : 0];
            const Real over_a = dot(normal, a) - bound;
            const Real over_b = dot(normal, b) - bound;
            if (!(over_a > 0) && kept.count < longest_polygon)
                kept.corners[kept.count++] = a;
            if (((over_a > 0) != (over_b > 0)) && kept.count < longest_polygon)
                kept.corners[kept.count++] = a + (over_a / (over_a - over_b)) * (b - a);
        }
        *this = kept;
    }

    /// Nearest point of the edges to the origin, which it is itself where there are none.
    Vec<Real> nearest_to_origin() const {
        Vec<Real> best = corners[0];
        for (int i = 0; i < count; ++i) {
            const Vec<Real> a = corners[i];
            const Vec<Real> way = corners[i + 1 < count ? i + 1 : 0] - a;
            const Real square = dot(way, way);
            const Real share = square > 0 ? clamped(-dot(a, way) / square, Real(0), Real(1)) : Real(0);
            const Vec<Real> here = a + share * way;
            if (dot(here, here) < dot(best, best))
                best = here;
        }
        return best;
    }
};

/// Two orthonormal vectors of tensions that make no force.
template <typename Real>
struct NullSpace {
    Vec<Real> row[cable_count]; ///< what each tension gets of the two

    explicit NullSpace(const Directions<Real>& to) {
        Real basis[4][cable_count] = {};
        for (int i = 0; i < cable_count; ++i) {
            basis[0][i] = to.unit[i].x;
            basis[1][i] = to.unit[i].y;
        }
        normalise(basis, 0);
        normalise(basis, 1);
        for (int k = 2; k < 4; ++k) {
            // Of the four axes the one that the vectors so far cover least.
            int best = 0;
            for (int i = 1; i < cable_count; ++i)
                if (covered(basis, k, i) < covered(basis, k, best))
                    best = i;
            basis[k][best] = 1;
            normalise(basis, k);
        }
        for (int i = 0; i < cable_count; ++i)
            row[i] = {basis[2][i], basis[3][i]};
    }

    /// How much of an axis lies along the first k vectors, 0 … 1.
    static Real covered(const Real (&basis)[4][cable_count], int k, int axis) {
        Real squares = 0;
        for (int j = 0; j < k; ++j)
            squares += basis[j][axis] * basis[j][axis];
        return squares;
    }

    /// Takes from vector k what lies along the earlier ones, and makes it a unit vector.
    static void normalise(Real (&basis)[4][cable_count], int k) {
        for (int j = 0; j < k; ++j) {
            Real along = 0;
            for (int i = 0; i < cable_count; ++i)
                along += basis[j][i] * basis[k][i];
            for (int i = 0; i < cable_count; ++i)
                basis[k][i] -= along * basis[j][i];
        }
        Real square = 0;
        for (int i = 0; i < cable_count; ++i)
            square += basis[k][i] * basis[k][i];
        const Real size = square_root(square);
        if (size > 0)
            for (int i = 0; i < cable_count; ++i)
                basis[k][i] /= size;
    }
};

/// The force nearest to `wanted` that tensions within their bounds can make, from the edges of the zonotope
/// of all such forces; false, and the tensions left as they are, where `wanted` itself is inside.
template <typename Real>
bool nearest_feasible(const CableFrame<Real>& frame, const Directions<Real>& to, Vec<Real> wanted,
                      Real (&tensions)[cable_count]) {
    constexpr Real parallel = Real(1e-5);
    constexpr Real sides[] = {-1, 1};
    const Real range = frame.greatest_tension - frame.least_tension;
    bool found = false;
    Real best{};
    for (const Vec<Real> along : to.unit)
        for (const Real side : sides) {
            const Vec<Real> outward = side * Vec<Real>{-along.y, along.x};
            Real edge[cable_count];
            Real on_edge
                [cable_count]; // 1 or −1 for a cable that pulls along the edge or back along it, or else 0
            Vec<Real> from;    // the end of the edge that is farthest back along it
            for (int j = 0; j < cable_count; ++j) {
                const Real out = dot(outward, to.unit[j]);
                on_edge[j] = absolute(out) < parallel ? dot(along, to.unit[j]) : Real(0);
                const bool high = on_edge[j] < 0 || (on_edge[j] == 0 && out > 0);
                edge[j] = high ? frame.greatest_tension : frame.least_tension;
                from = from + edge[j] * to.unit[j];
            }
            const Vec<Real> rest = wanted - from;
            if (!(dot(outward, rest) > 0))
                continue; // not beyond this edge
            Real left = dot(along, rest);
            for (int j = 0; j < cable_count; ++j)
                if (on_edge[j] != 0) {
                    const Real take = clamped(left, Real(0), range);
                    edge[j] += on_edge[j] < 0 ? -take : take;
                    left -= take;
                }
            Vec<Real> made;
            for (int j = 0; j < cable_count; ++j)
                made = made + edge[j] * to.unit[j];
            const Real square = dot(wanted - made, wanted - made);
            if (!found || square < best) {
                found = true;
                best = square;
                for (int j = 0; j < cable_count; ++j)
                    tensions[j] = edge[j];
            }
        }
    return found;
}

} // namespace

template <typename Real>
CablePlace<Real> locate(const CableFrame<Real>& frame, const Real (&lengths)[cable_count], Vec<Real> start) {
    constexpr int most_steps = 12;
    constexpr Real small = sizeof(Real) == sizeof(float) ? Real(1e-3) : Real(1e-9);
    constexpr Real longest = 100; // mm; a wild reading does not throw the knob out of the room
    CablePlace<Real> found;
    found.place = start;
    for (int step = 0; step < most_steps; ++step) {
        Crossed<Real> cables;
        Vec<Real> slope;
        for (int i = 0; i < cable_count; ++i) {
            const Vec<Real> way = found.place - frame.exits[i];
            const Real distance = length(way);
            if (!(distance > 0))
                continue;
            const Vec<Real> unit = (Real(1) / distance) * way;
            cables.add(unit);
            slope = slope + (lengths[i] - distance) * unit;
        }
        Vec<Real> move;
        if (!cables.solve(slope, move))
            break;
        const Real size = length(move);
        if (size > longest)
            move = (longest / size) * move;
        found.place = found.place + move;
        if (size < small) {
            found.converged = true;
            break;
        }
    }
    Real squares = 0;
    for (int i = 0; i < cable_count; ++i) {
        const Real off = lengths[i] - length(found.place - frame.exits[i]);
        squares += off * off;
    }
    found.residual =
        squares >= 0 ? square_root(squares / Real(cable_count)) : squares; // not a number stays none
    return found;
}

template <typename Real>
Tensions<Real> distribute(const CableFrame<Real>& frame, Vec<Real> place, Vec<Real> wanted) {
    const Directions<Real> to = directions(frame, place);
    const Real low = frame.least_tension;
    const Real high = frame.greatest_tension;
    Tensions<Real> found;

    // The tensions nearest to rest that make the force, bounds left aside: t = t_rest + Aᵀ(AAᵀ)⁻¹(F −
    // A·t_rest).
    Crossed<Real> cables;
    Vec<Real> missing = wanted;
    for (const Vec<Real> unit : to.unit) {
        cables.add(unit);
        missing = missing - frame.rest_tension * unit;
    }
    Vec<Real> pull;
    const bool solved = cables.solve(missing, pull);
    bool within = solved;
    for (int i = 0; i < cable_count; ++i) {
        found.newtons[i] = frame.rest_tension + dot(pull, to.unit[i]);
        within = within && found.newtons[i] >= low && found.newtons[i] <= high;
    }
    found.feasible = solved;
    if (!within) {
        if (nearest_feasible(frame, to, wanted, found.newtons)) {
            found.feasible = false;
        } else {
            const NullSpace<Real> none(to);
            // The tensions above are the foot of a perpendicular, so that those within their bounds are no
            // farther from them than from rest: 2·high at most.
            const Real wide = Real(4) * high;
            Polygon<Real> polygon;
            polygon.count = 4;
            polygon.corners[0] = {-wide, -wide};
            polygon.corners[1] = {wide, -wide};
            polygon.corners[2] = {wide, wide};
            polygon.corners[3] = {-wide, wide};
            for (int i = 0; i < cable_count; ++i) {
                polygon.clip(none.row[i], high - found.newtons[i]);
                polygon.clip(Real(-1) * none.row[i], found.newtons[i] - low);
            }
            // Nothing is left of it only where rounding decides on the very edge of what is feasible.
            const Vec<Real> shift = polygon.nearest_to_origin();
            for (int i = 0; i < cable_count; ++i)
                found.newtons[i] += dot(none.row[i], shift);
        }
        for (Real& tension : found.newtons)
            tension = clamped(tension, low, high); // whatever rounding made of it
    }
    for (int i = 0; i < cable_count; ++i)
        found.force = found.force + found.newtons[i] * to.unit[i];
    return found;
}

template CablePlace<float> locate(const CableFrame<float>&, const float (&)[cable_count], Vec<float>);
template Tensions<float> distribute(const CableFrame<float>&, Vec<float>, Vec<float>);
#if __STDC_HOSTED__
template CablePlace<double> locate(const CableFrame<double>&, const double (&)[cable_count], Vec<double>);
template Tensions<double> distribute(const CableFrame<double>&, Vec<double>, Vec<double>);
#endif

} // namespace tp::pad
