// SPDX-License-Identifier: Apache-2.0
#include "device/falcon/stamper.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace tp::falcon {

namespace {

constexpr double a = 0.060;    ///< m, thigh
constexpr double b = 0.1025;   ///< m, shin
constexpr double c = 0.01443;  ///< m, from the grip's axis to where a shin holds it
constexpr double d = 0.01125;  ///< m, from the shin to its upper joint
constexpr double e = 0.01125;  ///< m, and to its lower one
constexpr double f = -0.025;   ///< m, along the motor's axis
constexpr double r = 0.040;    ///< m, from the base's axis to a motor's
constexpr double s = -0.02309; ///< m, along the motor's axis
constexpr double degree = std::numbers::pi / 180.0;
constexpr std::array<double, 3> leg_azimuth{105.0 * degree, -15.0 * degree, -135.0 * degree};

constexpr double singular = 1e-3;      ///< of the volume that three directions at right angles would span
constexpr double close_enough = 1e-13; ///< m
constexpr double one_step = 0.03;      ///< m at most: farther than that the equations say little

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// An arm with its grip somewhere: the grip in the arm's own frame, with the constant c in u and f in v.
struct Leg {
    double u, v, w;
    double reach; ///< from the thigh's end to the grip, across the motor's axis
    double shin_across;
    glm::dvec3 u_way, v_way;

    Leg(std::size_t number, const Place& place) {
        const double cosine = std::cos(leg_azimuth[number]);
        const double sine = std::sin(leg_azimuth[number]);
        u_way = {cosine, sine, 0.0};
        v_way = {-sine, cosine, 0.0};
        u = glm::dot(u_way, place) - r + c;
        v = glm::dot(v_way, place) - s + f;
        w = place.z;
        shin_across = b * b > v * v ? std::sqrt(b * b - v * v) : 0.0;
        reach = d + e + shin_across;
    }
    bool can_be() const { return shin_across > 0.0; }

    /// (u − a·cosθ)² + (w − a·sinθ)² − reach², zero where the arm holds together; and what changes it.
    double gap(double angle) const {
        const double du = u - a * std::cos(angle);
        const double dw = w - a * std::sin(angle);
        return du * du + dw * dw - reach * reach;
    }
    glm::dvec3 gap_by_place(double angle) const {
        const double du = 2.0 * (u - a * std::cos(angle));
        const double dv = 2.0 * reach * v / shin_across;
        const double dw = 2.0 * (w - a * std::sin(angle));
        return du * u_way + dv * v_way + glm::dvec3(0.0, 0.0, dw);
    }
    double gap_by_angle(double angle) const { return 2.0 * a * (u * std::sin(angle) - w * std::cos(angle)); }
};

/// Rows: how each arm's gap changes with the place. Nothing where the rows lie in a plane.
std::optional<glm::dmat3> rows_inverse(const std::array<glm::dvec3, 3>& rows) {
    const double across = glm::dot(rows[0], glm::cross(rows[1], rows[2]));
    const double size = glm::length(rows[0]) * glm::length(rows[1]) * glm::length(rows[2]);
    if (!(std::abs(across) > singular * size))
        return std::nullopt;
    return glm::inverse(glm::transpose(glm::dmat3(rows[0], rows[1], rows[2])));
}

} // namespace

std::optional<Angles> angles_at(const Place& place) {
    if (!finite(place))
        return std::nullopt;
    Angles angles;
    for (std::size_t i = 0; i < 3; ++i) {
        const Leg leg(i, place);
        const double distance = std::hypot(leg.u, leg.w);
        const double cosine = (distance * distance + a * a - leg.reach * leg.reach) / (2.0 * a * distance);
        if (!leg.can_be() || !(std::abs(cosine) <= 1.0))
            return std::nullopt;
        angles[static_cast<int>(i)] = std::atan2(leg.w, leg.u) - std::acos(cosine);
    }
    return angles;
}

std::optional<Place> place_of(const Angles& angles, const Place& near) {
    if (!finite(angles) || !finite(near))
        return std::nullopt;
    Place place = near;
    for (int i = 0; i < most_steps; ++i) {
        std::array<glm::dvec3, 3> rows;
        glm::dvec3 gaps;
        for (std::size_t k = 0; k < 3; ++k) {
            const Leg leg(k, place);
            if (!leg.can_be())
                return std::nullopt;
            rows[k] = leg.gap_by_place(angles[static_cast<int>(k)]);
            gaps[static_cast<int>(k)] = leg.gap(angles[static_cast<int>(k)]);
        }
        const std::optional<glm::dmat3> inverse = rows_inverse(rows);
        if (!inverse)
            return std::nullopt;
        glm::dvec3 step = *inverse * gaps;
        const double size = glm::length(step);
        if (size > one_step)
            step *= one_step / size;
        place -= step;
        if (size > close_enough)
            continue;
        const std::optional<Angles> back = angles_at(place);
        if (!back)
            return std::nullopt;
        for (int k = 0; k < 3; ++k)
            if (std::abs(std::remainder((*back)[k] - angles[k], 2.0 * std::numbers::pi)) > 1e-6)
                return std::nullopt;
        return place;
    }
    return std::nullopt;
}

std::optional<glm::dmat3> jacobian(const Place& place, const Angles& angles) {
    if (!finite(place) || !finite(angles))
        return std::nullopt;
    std::array<glm::dvec3, 3> rows;
    glm::dvec3 by_angle;
    for (std::size_t i = 0; i < 3; ++i) {
        const Leg leg(i, place);
        if (!leg.can_be())
            return std::nullopt;
        rows[i] = leg.gap_by_place(angles[static_cast<int>(i)]);
        by_angle[static_cast<int>(i)] = leg.gap_by_angle(angles[static_cast<int>(i)]);
    }
    std::optional<glm::dmat3> inverse = rows_inverse(rows);
    if (!inverse)
        return std::nullopt;
    for (int i = 0; i < 3; ++i)
        (*inverse)[i] *= -by_angle[i];
    return inverse;
}

glm::dvec3 torques(const glm::dmat3& jacobian, const glm::dvec3& force) {
    return glm::transpose(jacobian) * force;
}

namespace {
constexpr double angle_at_no_count = 35.0 * degree;
constexpr double angle_of_a_count = 14.25 / 110.0 * 360.0 / 1280.0 * degree;
} // namespace

double angle_of(double counts) { return angle_at_no_count + angle_of_a_count * counts; }
double counts_of(double angle) { return (angle - angle_at_no_count) / angle_of_a_count; }

} // namespace tp::falcon
