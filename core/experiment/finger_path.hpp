// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// The finger at one moment of a trial, in the surface frame (origin at its centre, x right, y up).
struct FingerSample {
    double time_s = 0.0; ///< since the trial began
    double x_mm = 0.0, y_mm = 0.0;
    double fx_n = 0.0, fy_n = 0.0; ///< the force that the device was told to give
    bool operator==(const FingerSample&) const = default;
};

} // namespace tp
