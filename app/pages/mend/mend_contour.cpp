// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/mend_contour.hpp"

#include "core/geometry/polyline.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

namespace tp {

namespace {

using Kind = MendNode::Kind;

constexpr double straight_rad = 1e-6;
constexpr double smooth_rad = std::numbers::pi / 180.0;
constexpr double joint_tolerance = 1e-9; ///< px; pieces farther apart have a straight one between them
constexpr double least_share = 0.02;     ///< nearer to an anchor a smooth point cannot turn the other one

struct Ring {
    const MendContour& contour;

    std::size_t count() const { return contour.nodes.size(); }
    std::optional<std::size_t> beside(std::size_t node, int step) const {
        if (step < 0 && node == 0)
            return contour.closed ? std::optional(count() - 1) : std::nullopt;
        if (step > 0 && node + 1 == count())
            return contour.closed ? std::optional<std::size_t>(0) : std::nullopt;
        return step < 0 ? node - 1 : node + 1;
    }
    /// The nearest point in that direction that is not smooth.
    std::optional<std::size_t> anchor(std::size_t node, int step) const {
        std::optional<std::size_t> at = beside(node, step);
        for (std::size_t i = 0; at && i < count(); ++i) {
            if (contour.nodes[*at].kind != Kind::smooth)
                return at;
            at = beside(*at, step);
        }
        return std::nullopt;
    }
    std::optional<std::pair<std::size_t, std::size_t>> anchors(std::size_t node) const {
        const auto before = anchor(node, -1);
        const auto after = anchor(node, 1);
        if (!before || !after || *before == *after)
            return std::nullopt;
        return std::pair(*before, *after);
    }
    /// The point on the curve at which the piece of `node` begins.
    std::size_t piece_start(std::size_t node) const {
        while (!contour.nodes[node].on_curve())
            node = *beside(node, -1);
        if (!beside(node, 1)) { // the end of an open contour
            do
                node = *beside(node, -1);
            while (!contour.nodes[node].on_curve());
        }
        return node;
    }
    std::vector<std::size_t> controls_after(std::size_t joint) const {
        std::vector<std::size_t> controls;
        for (auto at = beside(joint, 1); at && !contour.nodes[*at].on_curve(); at = beside(*at, 1))
            controls.push_back(*at);
        return controls;
    }
    std::optional<std::size_t> joint_after(std::size_t joint) const {
        auto at = beside(joint, 1);
        while (at && !contour.nodes[*at].on_curve())
            at = beside(*at, 1);
        return at;
    }
    std::size_t joint_count() const {
        return static_cast<std::size_t>(
            std::count_if(contour.nodes.begin(), contour.nodes.end(), [](const MendNode& n) { return n.on_curve(); }));
    }
};

Piece piece_after(const MendContour& contour, std::size_t joint) {
    const Ring ring{contour};
    const auto at = [&](std::size_t node) { return contour.nodes[node].at; };
    const std::vector<std::size_t> controls = ring.controls_after(joint);
    const Vec2 a = at(joint), b = at(*ring.joint_after(joint));
    if (controls.empty())
        return Line{a, b};
    if (controls.size() == 1)
        return Quadratic{a, at(controls[0]), b};
    return Cubic{a, at(controls[0]), at(controls[1]), b};
}

double share_between(Vec2 a, Vec2 at, Vec2 b) {
    const double before = length(at - a), after = length(b - at);
    return before + after > 0.0 ? before / (before + after) : 0.5;
}

/// Where the smooth points lie between their anchors, to be laid there again once those have moved.
class SmoothPlaces {
public:
    explicit SmoothPlaces(const MendContour& contour) {
        const Ring ring{contour};
        for (std::size_t i = 0; i < contour.nodes.size(); ++i)
            if (contour.nodes[i].kind == Kind::smooth)
                if (const auto anchors = ring.anchors(i)) {
                    const Vec2 a = contour.nodes[anchors->first].at, b = contour.nodes[anchors->second].at;
                    places_.push_back({i, anchors->first, anchors->second, a, b,
                                       share_between(a, contour.nodes[i].at, b)});
                }
    }
    void lay(MendContour& contour, std::size_t except) const {
        for (const Place& p : places_) {
            const Vec2 a = contour.nodes[p.before].at, b = contour.nodes[p.after].at;
            if (p.node != except && (a != p.was_before || b != p.was_after))
                contour.nodes[p.node].at = a + p.share * (b - a);
        }
    }

private:
    struct Place {
        std::size_t node, before, after;
        Vec2 was_before, was_after;
        double share;
    };
    std::vector<Place> places_;
};

bool joins_smoothly(const MendContour& contour, std::size_t node) {
    const Ring ring{contour};
    const auto before = ring.beside(node, -1), after = ring.beside(node, 1);
    if (!before || !after)
        return false;
    const MendNode& p = contour.nodes[*before];
    const MendNode& n = contour.nodes[*after];
    const Vec2 in = contour.nodes[node].at - p.at, out = n.at - contour.nodes[node].at;
    if (in == Vec2(0.0) || out == Vec2(0.0))
        return false;
    const double turn = std::abs(std::atan2(cross(in, out), glm::dot(in, out)));
    return turn < (p.on_curve() && n.on_curve() ? straight_rad : smooth_rad);
}

double nearest_parameter(const Piece& piece, Vec2 place, double& away) {
    constexpr int samples = 64;
    double best = 0.0;
    away = std::numeric_limits<double>::infinity();
    for (double step = 1.0 / samples, from = 0.0, to = 1.0; step > 1e-7; step /= 16.0) {
        for (double t = from; t <= to + 0.5 * step; t += step) {
            const double share = std::min(t, 1.0);
            if (const double d = length(point_at(piece, share) - place); d < away) {
                away = d;
                best = share;
            }
        }
        from = std::max(0.0, best - step);
        to = std::min(1.0, best + step);
    }
    return best;
}

std::size_t split(MendContour& contour, std::size_t joint, double t) {
    const Ring ring{contour};
    const Piece piece = piece_after(contour, joint);
    std::vector<MendNode> fresh;
    std::size_t own = 0; // of the new point on the curve, among them
    const auto between = [t](Vec2 a, Vec2 b) { return a + t * (b - a); };
    if (const auto* q = std::get_if<Quadratic>(&piece)) {
        const Vec2 first = between(q->a, q->control), second = between(q->control, q->b);
        fresh = {{first, Kind::control}, {between(first, second), Kind::smooth}, {second, Kind::control}};
        own = 1;
    } else if (const auto* c = std::get_if<Cubic>(&piece)) {
        const Vec2 ab = between(c->a, c->control_a), bc = between(c->control_a, c->control_b),
                   cd = between(c->control_b, c->b);
        const Vec2 first = between(ab, bc), second = between(bc, cd);
        fresh = {{ab, Kind::control},
                 {first, Kind::control},
                 {between(first, second), Kind::smooth},
                 {second, Kind::control},
                 {cd, Kind::control}};
        own = 2;
    } else {
        fresh = {{point_at(piece, t), Kind::smooth}};
    }
    const auto begin = contour.nodes.begin() + static_cast<std::ptrdiff_t>(joint) + 1;
    const auto after = contour.nodes.erase(
        begin, begin + static_cast<std::ptrdiff_t>(ring.controls_after(joint).size()));
    contour.nodes.insert(after, fresh.begin(), fresh.end());
    return joint + 1 + own;
}

/// Where the straight lines a–b and c–d meet, ahead of `a` seen along a–b and ahead of `c` along c–d.
std::optional<Vec2> meeting(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const double turn = cross(b - a, d - c);
    if (std::abs(turn) < 1e-3 * length(b - a) * length(d - c) || turn == 0.0)
        return std::nullopt;
    const double along = cross(c - a, d - c) / turn;
    const double back = cross(c - a, b - a) / turn;
    if (!(along > 0.0) || !(back > 0.0) || along > 20.0 || back > 20.0)
        return std::nullopt;
    return a + along * (b - a);
}

void delete_joint(MendContour& contour, std::size_t joint) {
    const Ring ring{contour};
    const auto before = ring.beside(joint, -1);
    const auto after = ring.beside(joint, 1);
    if (!before || !after) { // an end: its piece goes too
        const std::size_t controls = !after ? ring.controls_after(ring.piece_start(joint)).size()
                                            : ring.controls_after(joint).size();
        const auto first = contour.nodes.begin() +
                           (before ? static_cast<std::ptrdiff_t>(joint - controls) : std::ptrdiff_t{0});
        contour.nodes.erase(first, first + static_cast<std::ptrdiff_t>(controls) + 1);
        contour.nodes.front().kind = Kind::corner;
        contour.nodes.back().kind = Kind::corner;
        return;
    }
    const std::size_t start = ring.piece_start(*before);
    const std::vector<std::size_t> one = ring.controls_after(start), other = ring.controls_after(joint);
    const Vec2 a = contour.nodes[start].at, b = contour.nodes[*ring.joint_after(joint)].at;
    std::vector<Vec2> controls;
    for (const std::vector<std::size_t>* some : {&one, &other})
        for (const std::size_t control : *some)
            controls.push_back(contour.nodes[control].at);
    if (one.size() == 1 && other.size() == 1)
        controls = {meeting(a, controls[0], b, controls[1]).value_or(0.5 * (controls[0] + controls[1]))};
    else if (controls.size() > 2)
        controls = {controls.front(), controls.back()};

    std::vector<std::size_t> gone{joint};
    gone.insert(gone.end(), one.begin(), one.end());
    gone.insert(gone.end(), other.begin(), other.end());
    std::vector<MendNode> nodes;
    for (std::size_t i = 0; i < contour.nodes.size(); ++i) {
        if (std::find(gone.begin(), gone.end(), i) == gone.end())
            nodes.push_back(contour.nodes[i]);
        if (i == start)
            for (const Vec2 control : controls)
                nodes.push_back({control, Kind::control});
    }
    contour.nodes = std::move(nodes);
    if (!contour.nodes.front().on_curve()) // a closed contour lost its first point
        std::rotate(contour.nodes.begin(),
                    std::find_if(contour.nodes.begin(), contour.nodes.end(),
                                 [](const MendNode& n) { return n.on_curve(); }),
                    contour.nodes.end());
}

/// Smooth points that lost what made them smooth are corners.
void judge_smooth(MendContour& contour) {
    for (std::size_t i = 0; i < contour.nodes.size(); ++i)
        if (contour.nodes[i].kind == Kind::smooth && !joins_smoothly(contour, i))
            contour.nodes[i].kind = Kind::corner;
}

} // namespace

std::optional<MendContour> mendable(const Contour& contour) {
    MendContour result{contour.name, {}, contour.closed};
    for (const Piece& piece : contour.pieces) {
        if (!is_finite(piece))
            continue;
        const Vec2 start = start_of(piece);
        if (result.nodes.empty() || length(result.nodes.back().at - start) > joint_tolerance)
            result.nodes.push_back({start, Kind::corner});
        if (const auto* q = std::get_if<Quadratic>(&piece)) {
            result.nodes.push_back({q->control, Kind::control});
        } else if (const auto* c = std::get_if<Cubic>(&piece)) {
            result.nodes.push_back({c->control_a, Kind::control});
            result.nodes.push_back({c->control_b, Kind::control});
        }
        result.nodes.push_back({end_of(piece), Kind::corner});
    }
    if (result.nodes.size() < 2)
        return std::nullopt;
    if (result.closed && result.nodes.size() > 2 &&
        length(result.nodes.back().at - result.nodes.front().at) <= joint_tolerance)
        result.nodes.pop_back();
    std::vector<bool> smooth;
    for (std::size_t i = 0; i < result.nodes.size(); ++i)
        smooth.push_back(result.nodes[i].on_curve() && joins_smoothly(result, i));
    for (std::size_t i = 0; i < result.nodes.size(); ++i)
        if (smooth[i])
            result.nodes[i].kind = Kind::smooth;
    return result;
}

Contour contour_of(const MendContour& contour) {
    Contour result{contour.name, {}, contour.closed};
    const Ring ring{contour};
    for (std::size_t i = 0; i < contour.nodes.size(); ++i)
        if (contour.nodes[i].on_curve() && ring.joint_after(i))
            result.pieces.push_back(piece_after(contour, i));
    return result;
}

void move_node(MendContour& contour, std::size_t node, Vec2 to) {
    if (!is_finite(to) || contour.nodes[node].at == to)
        return;
    const SmoothPlaces places(contour);
    std::vector<MendNode>& nodes = contour.nodes;
    if (nodes[node].kind == Kind::smooth) {
        const auto anchors = Ring{contour}.anchors(node);
        const bool first = anchors && nodes[anchors->first].kind == Kind::control;
        const bool second = anchors && nodes[anchors->second].kind == Kind::control;
        const Vec2 by = to - nodes[node].at;
        if (first && second) {
            nodes[anchors->first].at += by;
            nodes[anchors->second].at += by;
        } else if (first || second) {
            MendNode& turned = nodes[first ? anchors->first : anchors->second];
            const Vec2 pivot = nodes[first ? anchors->second : anchors->first].at;
            const double share = share_between(pivot, nodes[node].at, turned.at);
            if (share > least_share)
                turned.at = pivot + (to - pivot) / share;
            else
                nodes[node].kind = Kind::corner;
        } else {
            nodes[node].kind = Kind::corner;
        }
    }
    nodes[node].at = to;
    places.lay(contour, node);
    if (nodes[node].kind == Kind::corner) // others may have leaned on what lies beyond it
        judge_smooth(contour);
}

void move_all(MendContour& contour, Vec2 by) {
    if (is_finite(by))
        for (MendNode& node : contour.nodes)
            node.at += by;
}

std::size_t add_node_near(MendContour& contour, Vec2 place) {
    const Ring ring{contour};
    std::size_t best = ring.piece_start(0);
    double nearest = std::numeric_limits<double>::infinity();
    double at = 0.5;
    for (std::size_t i = 0; i < contour.nodes.size(); ++i)
        if (contour.nodes[i].on_curve() && ring.joint_after(i)) {
            double away = 0.0;
            const double t = nearest_parameter(piece_after(contour, i), place, away);
            if (away < nearest) {
                nearest = away;
                best = i;
                at = t;
            }
        }
    return split(contour, best, std::clamp(at, 0.02, 0.98));
}

std::size_t add_node_after(MendContour& contour, std::size_t node) {
    return split(contour, Ring{contour}.piece_start(node), 0.5);
}

bool delete_node(MendContour& contour, std::size_t node) {
    const std::size_t joints = Ring{contour}.joint_count();
    if (!contour.nodes[node].on_curve()) {
        if (contour.closed && joints < 3 && contour.nodes.size() - joints < 2)
            return false;
        contour.nodes.erase(contour.nodes.begin() + static_cast<std::ptrdiff_t>(node));
    } else {
        const bool bare = contour.nodes.size() == joints;
        if (joints <= (contour.closed && bare ? 3u : 2u))
            return false;
        delete_joint(contour, node);
    }
    judge_smooth(contour);
    return true;
}

bool toggle_corner(MendContour& contour, std::size_t node) {
    MendNode& own = contour.nodes[node];
    if (own.kind == Kind::smooth) {
        own.kind = Kind::corner;
        return true;
    }
    const auto anchors = Ring{contour}.anchors(node);
    if (own.kind == Kind::control || !anchors ||
        (contour.nodes[anchors->first].on_curve() && contour.nodes[anchors->second].on_curve()))
        return false;
    const Vec2 a = contour.nodes[anchors->first].at, b = contour.nodes[anchors->second].at;
    const SmoothPlaces places(contour); // those that leaned on this corner
    own.at = a + share_between(a, own.at, b) * (b - a);
    places.lay(contour, node);
    own.kind = Kind::smooth;
    return true;
}

Rect bounds_of(const MendContour& contour) {
    std::vector<Vec2> points;
    for (const MendNode& node : contour.nodes)
        points.push_back(node.at);
    return bounds_of(points);
}

} // namespace tp
