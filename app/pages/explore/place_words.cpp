// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/place_words.hpp"

#include "app/pages/explore/feature_labels.hpp"

#include <QCoreApplication>

#include <cmath>
#include <numbers>

namespace tp {

namespace {
struct PlaceWords {
    Q_DECLARE_TR_FUNCTIONS(tp::PlaceWords)
};
} // namespace

int clock_direction(Vec2 direction) {
    const double turns = std::atan2(direction.x, direction.y) / (2.0 * std::numbers::pi);
    const int hour = static_cast<int>(std::lround(12.0 * turns + 12.0)) % 12;
    return hour == 0 ? 12 : hour;
}

Vec2 landing_place(const Polyline& line) {
    return line.closed ? line.points.front() : point_along(line, 0.5 * length_of(line));
}

QString where_am_i(const Whereabouts& place) {
    const QString person = at_the_start(place.person);
    if (place.on_it)
        return PlaceWords::tr("%1. On the %2, at its %3 o'clock, %n millimetre(s) from its middle.", nullptr,
                              place.millimetres)
            .arg(person, place.feature)
            .arg(place.hour);
    if (place.beside)
        return PlaceWords::tr("Beside %1. %2 at %3 o'clock, %n millimetre(s).", nullptr, place.millimetres)
            .arg(place.person, at_the_start(place.feature))
            .arg(place.hour);
    return PlaceWords::tr("%1. %2 at %3 o'clock, %n millimetre(s).", nullptr, place.millimetres)
        .arg(person, at_the_start(place.feature))
        .arg(place.hour);
}

} // namespace tp
