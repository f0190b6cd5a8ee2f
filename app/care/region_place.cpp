// SPDX-License-Identifier: Apache-2.0
#include "app/care/region_place.hpp"

#include <QPointF>

#include <algorithm>

namespace tp {

namespace {

/// Where a point of a picture goes by an EXIF orientation (CIPA DC-008, 4.6.4); 0 … 1, y down.
QPointF oriented(QPointF p, int orientation) {
    switch (orientation) {
    case 2:
        return {1.0 - p.x(), p.y()};
    case 3:
        return {1.0 - p.x(), 1.0 - p.y()};
    case 4:
        return {p.x(), 1.0 - p.y()};
    case 5:
        return {p.y(), p.x()};
    case 6:
        return {1.0 - p.y(), p.x()};
    case 7:
        return {1.0 - p.y(), 1.0 - p.x()};
    case 8:
        return {p.y(), 1.0 - p.x()};
    default:
        return p;
    }
}

int orientation_back(int orientation) { return orientation == 6 ? 8 : orientation == 8 ? 6 : orientation; }

int orientation_of(int turned_degrees) {
    return turned_degrees == 90 ? 6 : turned_degrees == 180 ? 3 : turned_degrees == 270 ? 8 : 1;
}

QRectF oriented_part(const QRectF& part, int orientation) {
    return QRectF(oriented(part.topLeft(), orientation), oriented(part.bottomRight(), orientation)).normalized();
}

double area(const QRectF& part) { return part.width() * part.height(); }

} // namespace

QRectF shown_part(const FaceRegion& region, const PictureTurn& turn) {
    const QRectF stored(region.x - 0.5 * region.width, region.y - 0.5 * region.height, region.width, region.height);
    return oriented_part(oriented_part(stored, turn.orientation), orientation_of(turn.turned_degrees));
}

FaceRegion stored_region(const QRectF& part, const PictureTurn& turn) {
    const QRectF inside = part.normalized() & QRectF(0.0, 0.0, 1.0, 1.0);
    const QRectF stored = oriented_part(oriented_part(inside, orientation_back(orientation_of(turn.turned_degrees))),
                                        orientation_back(turn.orientation));
    return {stored.center().x(), stored.center().y(), stored.width(), stored.height(), {}};
}

bool same_face(const QRectF& a, const QRectF& b) {
    const QRectF both = a & b;
    const double shared = both.isEmpty() ? 0.0 : area(both);
    const double smaller = std::min(area(a), area(b));
    const double larger = std::max(area(a), area(b));
    constexpr double much = 0.6;     // of the smaller one inside of the larger one
    constexpr double alike = 1.0 / 6.0; // a head with hair has up to five times the area of its face
    return smaller > 0.0 && shared >= much * smaller && smaller >= alike * larger;
}

} // namespace tp
