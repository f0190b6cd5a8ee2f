// SPDX-License-Identifier: Apache-2.0
#include "core/friction/friction_choices.hpp"

#include <cmath>

namespace tp {

namespace {

bool is_share(double value) { return value >= 0.0 && value <= 1.0; }
bool is_width(double value) { return value > 0.0 && std::isfinite(value); }

} // namespace

std::optional<RidgeShape> ridge_named(std::string_view name) {
    if (name == "flat")
        return RidgeShape::flat;
    if (name == "tent")
        return RidgeShape::tent;
    if (name == "rounded")
        return RidgeShape::rounded;
    return std::nullopt;
}

FrictionChoices FrictionChoices::enlarged(double scale) const {
    FrictionChoices choices = *this;
    choices.rest_mm_s *= scale;
    choices.moving_mm_s *= scale;
    choices.again_mm *= scale;
    return choices;
}

std::string FrictionChoices::problem() const {
    if (!is_width(width_mm) || !is_width(texture_mm))
        return "The width of a ridge and of a stripe must be numbers of millimetres above zero.";
    if (!is_share(strength) || !is_share(texture))
        return "The friction of a ridge and of a stripe must be numbers from 0 to 1.";
    if (!(rest_mm_s >= 0.0) || !(moving_mm_s > rest_mm_s) || !std::isfinite(moving_mm_s))
        return "The speed of a moving finger must be a number above that of a resting one.";
    if (!(again_mm >= 0.0) || !std::isfinite(again_mm))
        return "The way after which a line is told of again must be a number of millimetres, zero or more.";
    return {};
}

} // namespace tp
