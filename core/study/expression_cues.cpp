// SPDX-License-Identifier: Apache-2.0
#include "core/study/expression_cues.hpp"

#include "core/base/words.hpp"
#include "core/geometry/flatten.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tp {

using std::numbers::sqrt2;

const std::array<CueKind, cue_count> cue_kinds{{
    {"mouth_width", sqrt2},               // one corner minus the other
    {"mouth_opening", sqrt2},             // one edge minus the other
    {"outer_corner_lift", 1.0},           // two corners, two middles, a half each
    {"inner_corner_lift", 1.0},           //
    {"lip_height", 2.0},                  // four edges, 1 each
    {"eye_opening", 1.0},                 // two lids in two eyes, a half each
    {"lid_slope", std::sqrt(1.25)},       // in two eyes two places by a half and two corners by a quarter
    {"eye_slant", 1.0},                   // two corners of two eyes, a half each
    {"chin_depth", std::sqrt(1.0 + 0.25)} // the chin, and four corners by a quarter
}};

namespace {

/// Of a contour's width: what counts as its corner, about a millimetre of a mouth.
constexpr double corner_share = 0.02;
/// Of the eyes' distance: a contour narrower than that is none.
constexpr double smallest_share = 0.02;
/// Shares of a width.
constexpr double middle_columns[] = {0.4, 0.45, 0.5, 0.55, 0.6};

struct Span {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void take(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    double size() const { return high - low; }
    double middle() const { return 0.5 * (low + high); }
};

/// Mean place on straight segments, each by its length: no matter how a line is cut up or where it begins.
class LineMean {
public:
    void take(Vec2 a, Vec2 b) {
        const double weight = length(b - a);
        sum_ += weight * (0.5 * a + 0.5 * b);
        weight_ += weight;
        any_ = a;
    }
    Vec2 mean() const { return weight_ > 0.0 ? sum_ / weight_ : any_; }

private:
    Vec2 sum_{0.0};
    double weight_ = 0.0;
    Vec2 any_{0.0}; ///< where all are of length zero
};

/// A closed contour in the face's frame: x along the eyes, y up, percent of the eyes' distance.
class Ring {
public:
    explicit Ring(Polyline line) : line_(std::move(line)) {
        for (const Vec2 p : line_.points)
            across_.take(p.x);
    }

    double width() const { return across_.size(); }

    /// Upper and lower edge at a share of the width (0 left … 1 right in the frame).
    Span edges_at(double share) const {
        const double x = across_.low + share * across_.size();
        Span edges;
        for (std::size_t i = 0; i < line_.segment_count(); ++i) {
            const Vec2 a = line_.segment_start(i);
            const Vec2 b = line_.segment_end(i);
            if (std::min(a.x, b.x) > x || std::max(a.x, b.x) < x)
                continue;
            if (a.x == b.x) {
                edges.take(a.y);
                edges.take(b.y);
            } else {
                edges.take(a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x)));
            }
        }
        return edges;
    }

    /// The edges in the middle, as a finger feels them over a fifth of the width.
    Span middle() const {
        Span mean{0.0, 0.0};
        for (const double share : middle_columns) {
            const Span edges = edges_at(share);
            mean.low += edges.low / std::size(middle_columns);
            mean.high += edges.high / std::size(middle_columns);
        }
        return mean;
    }

    /// Mean height of the line at its corner on the right of the frame, or on the left.
    double corner_height(bool right) const {
        const double reach = corner_share * across_.size();
        const double from = right ? across_.high - reach : across_.low;
        const double to = from + reach;
        LineMean heights;
        for (std::size_t i = 0; i < line_.segment_count(); ++i) {
            Vec2 a = line_.segment_start(i);
            Vec2 b = line_.segment_end(i);
            if (a.x > b.x)
                std::swap(a, b);
            if (b.x < from || a.x > to)
                continue;
            const auto at_x = [a, b](double x) { return a + (b - a) * ((x - a.x) / (b.x - a.x)); };
            const Vec2 first = a.x < from ? at_x(from) : a;
            const Vec2 last = b.x > to ? at_x(to) : b;
            heights.take(first, last);
        }
        return heights.mean().y;
    }

    double corner_lift() const {
        return 0.5 * (corner_height(true) + corner_height(false)) - middle().middle();
    }

private:
    Polyline line_;
    Span across_;
};

Vec2 centre_of(const Polyline& line) {
    LineMean places;
    for (std::size_t i = 0; i < line.segment_count(); ++i)
        places.take(line.segment_start(i), line.segment_end(i));
    return places.mean();
}

/// The line of that name, closed if asked; empty where there is none with a finite place.
Polyline line_named(const std::vector<Contour>& contours, const char* name, bool closed) {
    for (const Contour& contour : contours)
        if (contour.name == name) {
            Polyline line = flatten(contour);
            line.closed = closed;
            return line;
        }
    return {};
}

struct FaceLines {
    Polyline left_eye, right_eye, outer_lip, inner_lip, outline;
};

Result<FaceLines> face_lines(const std::vector<Contour>& contours) {
    FaceLines lines;
    const struct {
        const char* name;
        Polyline& line;
        bool closed;
    } wanted[] = {{"left_eye", lines.left_eye, true},
                  {"right_eye", lines.right_eye, true},
                  {"outer_lip", lines.outer_lip, true},
                  {"inner_lip", lines.inner_lip, true},
                  {"outline", lines.outline, false}};
    for (const auto& [name, line, closed] : wanted) {
        line = line_named(contours, name, closed);
        if (line.points.empty())
            return Error{"The face has no contour " + quoted(name) + "."};
    }
    return lines;
}

/// Photo or surface → the face's frame.
struct FaceFrame {
    Vec2 origin{0.0};
    Vec2 along{1.0, 0.0}; ///< unit vector
    Vec2 up{0.0, 1.0};    ///< unit vector
    double percent = 1.0; ///< of the eyes' distance, a unit of the contours

    Polyline operator()(Polyline line) const {
        for (Vec2& p : line.points)
            p = percent * Vec2(glm::dot(p - origin, along), glm::dot(p - origin, up));
        return line;
    }
};

Result<FaceFrame> frame_of(const FaceLines& lines) {
    const Vec2 right = centre_of(lines.right_eye);
    const Vec2 left = centre_of(lines.left_eye);
    const Vec2 mouth = centre_of(lines.outer_lip);
    const double apart = length(left - right);
    if (!(apart > 0.0) || !std::isfinite(apart))
        return Error{"Both eyes of the face lie in one place."};
    FaceFrame frame;
    frame.origin = 0.5 * (left + right);
    frame.along = (left - right) / apart;
    Span eyes;
    for (const Polyline* eye : {&lines.left_eye, &lines.right_eye})
        for (const Vec2 p : eye->points)
            eyes.take(glm::dot(p, frame.along));
    frame.percent = 100.0 / eyes.size();
    frame.up = Vec2(-frame.along.y, frame.along.x);
    const double below = glm::dot(mouth - frame.origin, frame.up);
    if (!(std::abs(below) * frame.percent > 100.0 * smallest_share))
        return Error{"The mouth of the face lies between its eyes."};
    if (below > 0.0)
        frame.up = -frame.up;
    return frame;
}

/// What one eye says; `outer_right`: its outer corner is the one on the right of the frame.
struct EyeCues {
    double opening;
    double lid_slope;
    double slant;
    double corners; ///< mean height of both

    EyeCues(const Ring& eye, bool outer_right) {
        const double outer = eye.corner_height(outer_right);
        const double inner = eye.corner_height(!outer_right);
        const double outer_lid = eye.edges_at(outer_right ? 0.75 : 0.25).high;
        const double inner_lid = eye.edges_at(outer_right ? 0.25 : 0.75).high;
        opening = eye.middle().size();
        slant = outer - inner;
        // The quarters lie half as far apart as the corners.
        lid_slope = inner_lid - outer_lid + 0.5 * slant;
        corners = 0.5 * (outer + inner);
    }
};

} // namespace

Result<ExpressionCues> expression_cues(const std::vector<Contour>& contours) {
    const auto lines = face_lines(contours);
    if (!lines)
        return Error{lines.error()};
    const auto frame = frame_of(*lines);
    if (!frame)
        return Error{frame.error()};
    const Ring left((*frame)(lines->left_eye)), right((*frame)(lines->right_eye));
    const Ring outer((*frame)(lines->outer_lip)), inner((*frame)(lines->inner_lip));
    const std::pair<const Ring*, const char*> rings[] = {
        {&left, "left_eye"}, {&right, "right_eye"}, {&outer, "outer_lip"}, {&inner, "inner_lip"}};
    for (const auto& [ring, name] : rings)
        if (!(ring->width() > 100.0 * smallest_share))
            return Error{"The contour " + quoted(name) + " has no width."};

    // The frame's x runs from the person's right eye to the left one.
    const EyeCues left_cues(left, true), right_cues(right, false);
    const Span lips = outer.middle(), opening = inner.middle();
    Span outline;
    for (const Vec2 p : (*frame)(lines->outline).points)
        outline.take(p.y);

    ExpressionCues cues{};
    at(cues, Cue::mouth_width) = outer.width();
    at(cues, Cue::mouth_opening) = opening.size();
    at(cues, Cue::outer_corner_lift) = outer.corner_lift();
    at(cues, Cue::inner_corner_lift) = inner.corner_lift();
    at(cues, Cue::lip_height) = lips.size() - opening.size();
    at(cues, Cue::eye_opening) = 0.5 * (left_cues.opening + right_cues.opening);
    at(cues, Cue::lid_slope) = 0.5 * (left_cues.lid_slope + right_cues.lid_slope);
    at(cues, Cue::eye_slant) = 0.5 * (left_cues.slant + right_cues.slant);
    at(cues, Cue::chin_depth) = 0.5 * (left_cues.corners + right_cues.corners) - outline.low;
    for (const double cue : cues)
        if (!std::isfinite(cue))
            return Error{"The contours of the face are too large to be measured."};
    return cues;
}

} // namespace tp
