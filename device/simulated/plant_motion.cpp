// SPDX-License-Identifier: Apache-2.0
#include "device/simulated/plant_motion.hpp"

#include <algorithm>
#include <cmath>

namespace tp {

namespace {

constexpr double longest_slide = 0.0001; ///< s in which the direction of dry friction is held
constexpr double newtons_to_mm = 1000.0; ///< N/kg = m/s²; the state is in mm

using Matrix = std::array<std::array<double, 4>, 4>;

Matrix product(const Matrix& a, const Matrix& b) {
    Matrix c{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t k = 0; k < 4; ++k)
                c[i][j] += a[i][k] * b[k][j];
    return c;
}

/// By Taylor's series of a halved argument, squared as often as it was halved.
Matrix exponential(Matrix a) {
    double largest = 0.0;
    for (const auto& row : a)
        for (const double value : row)
            largest = std::max(largest, std::abs(value));
    int halvings = 0;
    for (; largest > 0.125 && halvings < 60; largest *= 0.5)
        ++halvings;
    for (auto& row : a)
        for (double& value : row)
            value = std::ldexp(value, -halvings);
    Matrix sum{};
    for (std::size_t i = 0; i < 4; ++i)
        sum[i][i] = 1.0;
    Matrix term = sum;
    for (int order = 1; order <= 14; ++order) {
        term = product(term, a);
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j) {
                term[i][j] /= order;
                sum[i][j] += term[i][j];
            }
    }
    for (; halvings > 0; --halvings)
        sum = product(sum, sum);
    return sum;
}

} // namespace

PlantMotion::Step PlantMotion::step_of(const PlantParameters& plant, double dt) noexcept {
    const double per_newton = newtons_to_mm / plant.mass;
    Matrix rate{};
    rate[0][1] = dt;
    rate[1] = {-dt * per_newton * plant.stiffness, -dt * plant.damping / plant.mass,
               dt * per_newton * plant.stiffness, dt * per_newton};
    if (plant.follow > 0.0) {
        rate[2][0] = dt / plant.follow;
        rate[2][2] = -dt / plant.follow;
    }
    return exponential(rate);
}

const PlantMotion::Step& PlantMotion::step(const PlantParameters& plant, double dt) noexcept {
    if (!(std::abs(dt - last_dt_) <= 1e-12 * dt) || plant != last_plant_) {
        last_ = step_of(plant, dt);
        last_dt_ = dt;
        last_plant_ = plant;
    }
    return last_;
}

void PlantMotion::apply(const Step& step, PlantState& state, Vec2 force) noexcept {
    const PlantState before = state;
    const auto row = [&](std::size_t i) {
        return step[i][0] * before.position + step[i][1] * before.velocity + step[i][2] * before.anchor +
               step[i][3] * force;
    };
    state.position = row(0);
    state.velocity = row(1);
    state.anchor = row(2);
}

double PlantMotion::slide(PlantState& state, const PlantParameters& plant, Vec2 force, double dt) noexcept {
    const Vec2 pull = force + plant.stiffness * (state.anchor - state.position);
    const double speed = length(state.velocity);
    if (!(speed > 0.0) && length(pull) <= plant.coulomb) {
        if (plant.follow > 0.0)
            state.anchor += -std::expm1(-dt / plant.follow) * (state.position - state.anchor);
        return dt;
    }
    const Vec2 way = speed > 0.0 ? state.velocity / speed : pull / length(pull);
    const Vec2 with_friction = force - plant.coulomb * way;
    PlantState after = state;
    apply(step(plant, dt), after, with_friction);
    if (!(speed > 0.0) || glm::dot(after.velocity, way) > 0.0) {
        state = after;
        return dt;
    }
    double least = 0.0; // of the step, after which it has come to rest
    double most = 1.0;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (least + most);
        after = state;
        apply(step_of(plant, middle * dt), after, with_friction);
        (glm::dot(after.velocity, way) > 0.0 ? least : most) = middle;
    }
    after.velocity -= glm::dot(after.velocity, way) * way; // what it has across its way goes on
    if (length(after.velocity) < std::max(1e-6 * speed, 1e-9))
        after.velocity = Vec2(0.0);
    state = after;
    return most * dt;
}

void PlantMotion::advance(PlantState& state, const PlantParameters& plant, Vec2 force, double dt) noexcept {
    if (!(plant.coulomb > 0.0)) {
        apply(step(plant, dt), state, force);
        return;
    }
    const double parts = std::ceil(dt / longest_slide - 1e-9);
    for (double i = 0.0; i < parts; ++i) {
        double left = dt / parts;
        for (int rests = 0; left > 1e-12 && rests < 8; ++rests)
            left -= slide(state, plant, force, left);
    }
}

} // namespace tp
