// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/mend_view.hpp"

#include <algorithm>

namespace tp {

namespace {
constexpr double room = 0.66; ///< share of the window that what is shown takes
} // namespace

MendView::MendView(const MendedPhoto& photo) {
    connect(&photo, &MendedPhoto::replaced, this,
            [this, &photo] { set_photo(photo.work().width, photo.work().height); });
}

void MendView::setWindow(double width, double height) {
    const Vec2 centre = to_photo(middle());
    width_ = std::max(1.0, width);
    height_ = std::max(1.0, height);
    scale_ = std::max(scale_, smallest_scale());
    centre_on(centre);
    emit changed();
}

void MendView::set_photo(double width, double height) {
    photo_width_ = std::max(1.0, width);
    photo_height_ = std::max(1.0, height);
    showAll();
}

double MendView::smallest_scale() const { return std::min(width_ / photo_width_, height_ / photo_height_); }

void MendView::centre_on(Vec2 place) { origin_ = place - 0.5 * Vec2(width_, height_) / scale_; }

void MendView::showAll() {
    scale_ = smallest_scale();
    centre_on({0.5 * photo_width_ - 0.5, 0.5 * photo_height_ - 0.5});
    emit changed();
}

void MendView::show(const Rect& part) {
    const double across = room * width_ / std::max(part.width(), 1.0);
    const double down = room * height_ / std::max(part.height(), 1.0);
    scale_ = std::clamp(std::min(across, down), std::min(smallest_scale(), largest_scale), largest_scale);
    centre_on(part.centre());
    emit changed();
}

void MendView::zoomAt(double factor, double x, double y) {
    if (!(factor > 0.0))
        return;
    const Vec2 place = to_photo({x, y});
    scale_ = std::clamp(scale_ * factor, std::min(smallest_scale(), largest_scale), largest_scale);
    origin_ = place - Vec2(x, y) / scale_;
    emit changed();
}

void MendView::panBy(double dx, double dy) {
    const Vec2 centre = to_photo(middle()) - Vec2(dx, dy) / scale_;
    centre_on(glm::clamp(centre, Vec2(-0.5), Vec2(photo_width_ - 0.5, photo_height_ - 0.5)));
    emit changed();
}

void MendView::bring_in_sight(Vec2 place) {
    const QPointF at = to_window(place);
    const auto out = [](double value, double size) {
        return value < 0.1 * size ? value - 0.1 * size : std::max(0.0, value - 0.9 * size);
    };
    origin_ += Vec2(out(at.x(), width_), out(at.y(), height_)) / scale_;
    emit changed();
}

QRectF MendView::photo_rect() const {
    return {to_window(Vec2(-0.5)), to_window({photo_width_ - 0.5, photo_height_ - 0.5})};
}

} // namespace tp
