// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/tent_profile.hpp"

#include <cmath>

namespace tp {

double TentProfile::force(double r) const {
    if (!(r >= 0.0) || r >= band())
        return 0.0;
    return stiffness * (r <= range ? r : band() - r);
}

double TentProfile::energy(double r) const {
    if (!(r >= 0.0))
        return 0.0;
    if (r <= range)
        return 0.5 * stiffness * r * r;
    const double left = r < band() ? band() - r : 0.0;
    return stiffness * range * range - 0.5 * stiffness * left * left;
}

bool TentProfile::valid() const {
    return std::isfinite(stiffness) && std::isfinite(range) && stiffness > 0.0 && range > 0.0;
}

} // namespace tp
