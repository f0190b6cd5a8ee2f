// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/continuity.hpp"

namespace tp {

std::string Continuity::problem() const {
    constexpr double widest_mm = 5.0;
    for (const double width : {hold_mm, blend_mm})
        if (!(width >= 0.0 && width <= widest_mm))
            return "The widths of hysteresis and blending are from 0 to 5 mm.";
    if (hold_mm > 0.0 && blend_mm > 0.0)
        return "Hysteresis and blending are two answers to the same jump; choose one of them.";
    return {};
}

} // namespace tp
