// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/finger/sheet_frame.hpp"
#include "core/geometry/calibration.hpp"
#include "core/geometry/transform.hpp"

#include <optional>

namespace tp {

/// Where the sheet lies on the screen, for a device that lies there too.
class SheetPlace {
public:
    explicit SheetPlace(const SheetFrame& frame) : frame_(frame) {}

    /// Its top left corner lies there, mm from the screen's (x right, y down), and each of its millimetres is
    /// `scale` real ones; a scale that is not above 0 is ignored. Whether it lies elsewhere than before.
    bool lies(double left, double top, double scale);
    /// The device's frame → surface; nothing where the sheet is drawn so small or large that the device's
    /// stiffness, which the map changes by its square, would be another thing.
    std::optional<Affine> from_device(const Calibration& calibration) const;
    bool operator==(const SheetPlace& other) const;

private:
    SheetFrame frame_;
    Affine screen_to_surface_; ///< mm
};

} // namespace tp
