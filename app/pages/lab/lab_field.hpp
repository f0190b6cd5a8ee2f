// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/work/latest_task.hpp"
#include "core/geometry/polyline.hpp"
#include "core/guidance/haptic_scene.hpp"

#include <QImage>

#include <functional>
#include <memory>

namespace tp {

/// The picture of a scene's force field with its legend below, painted beside the page.
class LabField {
public:
    static constexpr int legend_pixels = 44; ///< of draw_force_field

    /// `painted` is called on the owner's thread for each picture that is new.
    LabField(const Rect& surface, std::function<void()> painted)
        : surface_(surface), painted_(std::move(painted)) {}

    /// Null before the first one is painted.
    const QImage& image() const { return image_; }
    void show(std::shared_ptr<const HapticScene> scene);
    /// Pixels a millimetre.
    void set_scale(double pixels_per_mm);

private:
    void paint();
    void paint_finely();
    void take(const QImage& image);

    Rect surface_;
    std::function<void()> painted_;
    std::shared_ptr<const HapticScene> scene_;
    double scale_ = 4.0;
    QImage image_;
    LatestTask work_; ///< last: it ends first
};

} // namespace tp
