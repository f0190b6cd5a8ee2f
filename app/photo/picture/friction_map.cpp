// SPDX-License-Identifier: Apache-2.0
#include "app/photo/picture/friction_map.hpp"

#include "core/friction/friction_law.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace tp {

namespace {

constexpr double widest_dots_per_mm = 1000.0;
constexpr double part_of_a_dot = 1e-6; // what rounding may add to a whole number of dots

double dots_across(double mm, double dots_per_mm) {
    return std::max(1.0, std::ceil(mm * dots_per_mm - part_of_a_dot));
}

std::string number(double value) { return QString::number(value, 'g', 6).toStdString(); }

std::string map_problem(const FrictionChoices& choices, double columns, double rows, double dots_per_mm) {
    if (const std::string problem = choices.problem(); !problem.empty())
        return problem;
    if (!(dots_per_mm > 0.0 && dots_per_mm <= widest_dots_per_mm))
        return "A friction map has between 0 and 1000 dots a millimetre.";
    if (!(columns * rows <= most_friction_dots))
        return "At " + number(dots_per_mm) + " dots a millimetre the map would be " + number(columns) +
               " × " + number(rows) + " dots, more than can be drawn; choose fewer dots a millimetre.";
    if (choices.width_mm * dots_per_mm < 2.0)
        return "A ridge of " + number(choices.width_mm) + " mm is narrower than two dots at " +
               number(dots_per_mm) +
               " dots a millimetre and would have gaps; choose more dots or a wider ridge.";
    return {};
}

} // namespace

Result<QImage> draw_friction_map(const FlatScene& scene, const FrictionChoices& choices, const Rect& surface,
                                 double dots_per_mm, const std::stop_token& stop,
                                 const std::function<void(double)>& report) {
    const double columns = dots_across(surface.width(), dots_per_mm);
    const double rows = dots_across(surface.height(), dots_per_mm);
    if (const std::string problem = map_problem(choices, columns, rows, dots_per_mm); !problem.empty())
        return Error{problem};
    QImage image(static_cast<int>(columns), static_cast<int>(rows), QImage::Format_Grayscale8);
    if (image.isNull())
        return Error{"There is not enough memory for a map of so many dots; choose fewer dots a millimetre."};
    const int dots_per_metre = static_cast<int>(std::lround(1000.0 * dots_per_mm));
    image.setDotsPerMeterX(dots_per_metre);
    image.setDotsPerMeterY(dots_per_metre);

    const FrictionLaw law(scene, choices);
    const double reach = 0.5 * choices.width_mm;
    const ContourIndex index(scene, reach);
    for (int y = 0; y < image.height(); ++y) {
        if (stop.stop_requested())
            return QImage();
        if (report)
            report(static_cast<double>(y) / image.height());
        uchar* const row = image.scanLine(y);
        for (int x = 0; x < image.width(); ++x) {
            const Vec2 place(surface.min.x + (x + 0.5) / dots_per_mm,
                             surface.max.y - (y + 0.5) / dots_per_mm);
            const double level =
                law.moving_level(place, index.nearest_within(place, reach).distance, law.in_texture(place));
            row[x] = static_cast<uchar>(std::lround(255.0 * level));
        }
    }
    return image;
}

} // namespace tp
