// SPDX-License-Identifier: Apache-2.0
#include "core/participant/way_belief.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace tp {
namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;
// Before anything is felt: shapes lie somewhere about the middle and are of the size of a hand (assumed).
constexpr double usual_mm = 50.0, size_mm = 40.0, off_middle_mm = 30.0;

Vec2 at_angle(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// One place after the other, and how much each counts.
struct Way {
    std::span<const FeltPlace> felt;
    double place_weight = 0.0, heading_weight = 0.0;
    double most_mm = 0.0,
           most_rad = 0.0; ///< what is farther off was no place of the line, and tells nothing more
};

/// Centre and size: of a circle its radius, of a polygon that of the circle in it.
struct Fit {
    Vec2 centre{0.0};
    double size = usual_mm;
};

/// The normal equations of residuals u·p − u·centre − size with one weight, and of what is known before.
class Normal {
public:
    explicit Normal(const Fit& fit, double weight) : fit_(fit), weight_(weight) {
        a_[0][0] = a_[1][1] = 1.0 / (off_middle_mm * off_middle_mm);
        a_[2][2] = 1.0 / (size_mm * size_mm);
        b_[0] = -fit.centre.x * a_[0][0];
        b_[1] = -fit.centre.y * a_[1][1];
        b_[2] = (usual_mm - fit.size) * a_[2][2];
    }
    void add(Vec2 u, double rest) {
        const double row[3]{u.x, u.y, 1.0};
        for (int i = 0; i < 3; ++i) {
            b_[i] += weight_ * row[i] * rest;
            for (int k = 0; k < 3; ++k)
                a_[i][k] += weight_ * row[i] * row[k];
        }
    }
    Fit solved() {
        for (int i = 0; i < 3; ++i)
            for (int k = i + 1; k < 3; ++k) {
                const double share = a_[k][i] / a_[i][i];
                for (int c = i; c < 3; ++c)
                    a_[k][c] -= share * a_[i][c];
                b_[k] -= share * b_[i];
            }
        double x[3];
        for (int i = 2; i >= 0; --i) {
            x[i] = b_[i];
            for (int c = i + 1; c < 3; ++c)
                x[i] -= a_[i][c] * x[c];
            x[i] /= a_[i][i];
        }
        return {fit_.centre + Vec2(x[0], x[1]), std::max(5.0, fit_.size + x[2])};
    }

private:
    Fit fit_;
    double weight_;
    double a_[3][3]{};
    double b_[3]{};
};

double prior_cost(const Fit& fit) {
    return glm::dot(fit.centre, fit.centre) / (off_middle_mm * off_middle_mm) +
           (fit.size - usual_mm) * (fit.size - usual_mm) / (size_mm * size_mm);
}

/// A regular polygon's outward normals, or those of a circle.
class Normals {
public:
    Normals(int corners, double turn) {
        for (int side = 0; side < corners; ++side)
            sides_.push_back(at_angle(turn + full_turn * side / corners));
    }
    /// Of the side, or the part of the circle, that is seen from the centre in this direction.
    Vec2 at(Vec2 from_centre) const {
        if (sides_.empty()) {
            const double away = length(from_centre);
            return away > 0.0 ? from_centre / away : Vec2(1.0, 0.0);
        }
        return *std::ranges::max_element(sides_, {}, [&](Vec2 side) { return glm::dot(side, from_centre); });
    }

private:
    std::vector<Vec2> sides_;
};

/// `fit` is where it begins; where it ends afterwards.
double cost_of(const Way& way, int corners, double turn, double turned, Fit& fit) {
    constexpr int steps = 5, rough = 3; // at first what is far off may be so because the fit is
    const Normals normals(corners, turn);
    for (int step = 0; step < steps; ++step) {
        Normal normal(fit, way.place_weight);
        for (const FeltPlace& felt : way.felt) {
            const Vec2 u = normals.at(felt.place - fit.centre);
            const double rest = glm::dot(u, felt.place - fit.centre) - fit.size;
            if (step < rough || std::abs(rest) < way.most_mm)
                normal.add(u, rest);
        }
        fit = normal.solved();
    }
    double cost = prior_cost(fit);
    for (const FeltPlace& felt : way.felt) {
        const Vec2 u = normals.at(felt.place - fit.centre);
        const Vec2 along = turned * Vec2(-u.y, u.x);
        const double off = std::atan2(cross(along, felt.heading), glm::dot(along, felt.heading));
        const double apart = std::min(std::abs(glm::dot(u, felt.place - fit.centre) - fit.size), way.most_mm),
                     turn_off = std::min(std::abs(off), way.most_rad);
        cost += way.place_weight * apart * apart + way.heading_weight * turn_off * turn_off;
    }
    return cost;
}

} // namespace

ShapeBeliefs beliefs_of(std::span<const FeltPlace> way, const std::array<WayError, 2>& places,
                        const std::array<WayError, 2>& headings) {
    ShapeBeliefs beliefs{};
    beliefs.fill(1.0 / static_cast<double>(beliefs.size()));
    double length_mm = 0.0, turned = 0.0;
    for (std::size_t i = 1; i < way.size(); ++i) {
        length_mm += length(way[i].place - way[i - 1].place);
        turned += std::atan2(cross(way[i - 1].heading, way[i].heading),
                             glm::dot(way[i - 1].heading, way[i].heading));
    }
    constexpr double least_mm = 60.0;
    if (length_mm < least_mm)
        return beliefs;
    const double radian = std::numbers::pi / 180.0;
    const double share = length_mm / static_cast<double>(way.size());
    const Way weighed{way, share / (places[0].loss() + places[1].loss()),
                      share / (radian * radian * (headings[0].loss() + headings[1].loss())),
                      2.0 * std::hypot(places[0].deviation, places[1].deviation),
                      2.0 * radian * std::hypot(headings[0].deviation, headings[1].deviation)};
    Fit begin;
    for (const FeltPlace& felt : way)
        begin.centre += felt.place / static_cast<double>(way.size());
    begin.centre *= 0.5; // between the way and the middle
    const double sign = turned < 0.0 ? -1.0 : 1.0;
    const double circle_cost = cost_of(weighed, 0, 0.0, sign, begin); // which lies about where the others do
    std::array<double, shape_corners.size()> likelihood{};
    for (std::size_t shape = 0; shape < shape_corners.size(); ++shape) {
        const int corners = shape_corners[shape];
        double best = corners == 0 ? circle_cost : std::numeric_limits<double>::infinity();
        double best_turn = 0.0;
        const auto try_turn = [&](double turn) {
            Fit fit = begin;
            fit.size *= 0.5 + 0.5 * std::cos(0.5 * full_turn / corners);
            if (const double cost = cost_of(weighed, corners, turn, sign, fit); cost < best) {
                best = cost;
                best_turn = turn;
            }
        };
        if (corners > 0) {
            const int phases = 36 / corners;
            double step = full_turn / corners / phases;
            for (int phase = 0; phase < phases; ++phase)
                try_turn(step * phase);
            for (int halved = 0; halved < 4; ++halved) {
                step *= 0.5;
                const double middle = best_turn;
                try_turn(middle - step);
                try_turn(middle + step);
            }
        }
        const double chosen = corners == 0 ? 3.0 : 4.0;
        likelihood[shape] = -0.5 * best - 0.5 * chosen * std::log(1.0 + 2.0 * length_mm / least_mm);
    }
    const double most = *std::ranges::max_element(likelihood);
    double sum = 0.0;
    for (std::size_t shape = 0; shape < beliefs.size(); ++shape)
        sum += beliefs[shape] = std::exp(likelihood[shape] - most);
    for (double& belief : beliefs)
        belief /= sum;
    return beliefs;
}

} // namespace tp
