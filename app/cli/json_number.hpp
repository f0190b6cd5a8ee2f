// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace tp {

/// A number as JSON shows it: to the nearest thousandth.
inline double in_thousandths(double value) { return std::round(value * 1000.0) / 1000.0; }

} // namespace tp
