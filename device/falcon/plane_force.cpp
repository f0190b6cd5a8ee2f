// SPDX-License-Identifier: Apache-2.0
#include "device/falcon/plane_force.hpp"

#include "device/falcon/falcon_frame.hpp"
#include "device/falcon/stamper.hpp"

#include <algorithm>
#include <cmath>

namespace tp::falcon {

std::array<std::int16_t, 3> motors_for(const glm::dmat3& jacobian, const glm::dvec3& force) {
    const glm::dvec3 wanted = -units_per_newton_metre * torques(jacobian, force);
    const double largest = std::max({std::abs(wanted.x), std::abs(wanted.y), std::abs(wanted.z)});
    if (!std::isfinite(wanted.x + wanted.y + wanted.z))
        return {};
    const double part = largest > most_motor ? most_motor / largest : 1.0;
    return {motor_units(part * wanted.x), motor_units(part * wanted.y), motor_units(part * wanted.z)};
}

void Pane::feed(double time, double z) noexcept {
    if (!std::isfinite(time) || !std::isfinite(z))
        return;
    const double dt = time - time_;
    if (dt > VelocityFilter::longest_silence)
        speed_ = VelocityFilter{};
    speed_.feed(time, {z, 0.0});
    if (!known_ || dt > 0.0) {
        time_ = time;
        z_ = z;
    }
    known_ = true;
}

double Pane::force(double share) noexcept {
    const double depth = plane_z - z_;
    double wanted = 0.0;
    if (known_ && depth > 0.0 && share > 0.0)
        wanted =
            std::min(share, 1.0) * std::clamp(stiffness * depth - damping * speed_.velocity().x, 0.0, most);
    last_ = std::min(wanted, last_ + most_rise);
    return last_;
}

} // namespace tp::falcon
