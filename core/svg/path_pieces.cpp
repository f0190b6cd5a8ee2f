// SPDX-License-Identifier: Apache-2.0
#include "core/svg/path_pieces.hpp"

#include "core/svg/arc_pieces.hpp"

#include <2geom/path-sink.h>
#include <2geom/svg-path-parser.h>

#include <cmath>
#include <exception>
#include <string>

namespace tp::svg {

namespace {

Vec2 vec(const Geom::Point& p) { return {p.x(), p.y()}; }

/// Takes lib2geom's commands, which are absolute and have their shorthands spelt out, as pieces.
class PieceSink final : public Geom::PathSink {
public:
    PieceSink(double tolerance, std::size_t piece_limit) : tolerance_(tolerance), piece_limit_(piece_limit) {}

    void moveTo(const Geom::Point& p) override {
        flush();
        begin(vec(p));
    }
    void lineTo(const Geom::Point& p) override { append(Line{here(), vec(p)}); }
    void quadTo(const Geom::Point& control, const Geom::Point& p) override {
        append(Quadratic{here(), vec(control), vec(p)});
    }
    void curveTo(const Geom::Point& control_a, const Geom::Point& control_b, const Geom::Point& p) override {
        append(Cubic{here(), vec(control_a), vec(control_b), vec(p)});
    }
    void arcTo(double rx, double ry, double rotation, bool large, bool clockwise,
               const Geom::Point& p) override {
        const Vec2 from = here();
        infinite_ = infinite_ || !std::isfinite(rx) || !std::isfinite(ry) || !std::isfinite(rotation);
        if (infinite_) // as an arc it would become a line, unseen
            return;
        std::vector<Piece> arc;
        append_path_arc(arc, from, rx, ry, rotation, large, clockwise, vec(p), tolerance_);
        for (const Piece& piece : arc)
            append(piece);
    }
    void closePath() override {
        if (!drawing_)
            return;
        current_.closed = true;
        const Vec2 start = current_.start;
        flush();
        at_ = start;
    }
    void flush() override {
        if (drawing_ && (current_.closed || !current_.pieces.empty()) && roomy())
            subpaths_.push_back(std::move(current_));
        drawing_ = false;
    }

    /// A place, a radius or an angle is not finite.
    bool infinite() const { return infinite_; }
    /// The limit was met; what came after it is missing.
    bool overfull() const { return overfull_; }
    std::vector<Subpath> take() { return std::move(subpaths_); }

private:
    void begin(Vec2 p) {
        current_ = Subpath{p, {}, false};
        infinite_ = infinite_ || !is_finite(p);
        at_ = p;
        drawing_ = true;
    }

    /// The pen's place; after a closepath, drawing goes on at the start of the closed subpath.
    Vec2 here() {
        if (!drawing_)
            begin(at_);
        return at_;
    }

    bool roomy() {
        overfull_ = overfull_ || ++count_ > piece_limit_;
        return !overfull_;
    }

    void append(const Piece& piece) {
        at_ = end_of(piece);
        infinite_ = infinite_ || !is_finite(piece);
        if (roomy()) // the parser must not be left by an exception: it would leak
            current_.pieces.push_back(piece);
    }

    double tolerance_;
    std::size_t piece_limit_;
    std::size_t count_ = 0;
    bool infinite_ = false;
    bool overfull_ = false;
    bool drawing_ = false;
    Vec2 at_{0.0};
    Subpath current_;
    std::vector<Subpath> subpaths_;
};

} // namespace

Result<std::vector<Subpath>> subpaths_from(std::string_view path_data, double tolerance,
                                           std::size_t piece_limit) {
    try {
        PieceSink sink(tolerance, piece_limit);
        Geom::SVGPathParser parser(sink);
        parser.setZSnapThreshold(0.0); // closed ends are joined later, in units of the sheet
        parser.parse(std::string(path_data));
        if (sink.infinite())
            return Error{"reaches beyond what can be computed with"};
        if (sink.overfull())
            return Error{"has more pieces than a sheet may hold"};
        return sink.take();
    } catch (const std::exception&) {
        return Error{"has path data that is broken"};
    }
}

} // namespace tp::svg
