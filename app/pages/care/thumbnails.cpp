// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/thumbnails.hpp"

#include "app/photo/picture/overlay.hpp"
#include "faces/decode/picture.hpp"

#include <QMetaObject>
#include <QRectF>

#include <algorithm>
#include <exception>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr double around = 0.25;       ///< of a part's longer side, shown with it
constexpr double largest_px = 2048.0; ///< of the photograph that a part is cut from

/// The part and some of what is round it.
QImage read_part(const PicturePart& wish) {
    const bool whole = wish.part.min == Vec2(0.0) && wish.part.max == Vec2(1.0);
    const double longer = std::clamp(std::max(wish.part.width(), wish.part.height()), 0.01, 1.0);
    const int px =
        static_cast<int>(whole ? Thumbnails::side_px : std::min(Thumbnails::side_px / longer, largest_px));
    const auto picture = read_picture_to_fit(wish.photo, {px, px});
    if (!picture)
        return {};
    const QImage image = to_image(turned(*picture, wish.turned_degrees));
    if (whole)
        return image;
    const QRectF part(wish.part.min.x * image.width(), wish.part.min.y * image.height(),
                      wish.part.width() * image.width(), wish.part.height() * image.height());
    const double margin = around * std::max(part.width(), part.height());
    return image.copy(part.adjusted(-margin, -margin, margin, margin).toAlignedRect() & image.rect());
}

} // namespace

Thumbnails::Thumbnails(Read read, QObject* parent) : QObject(parent), read_(std::move(read)) {
    if (!read_)
        read_ = read_part;
    pool_.setMaxThreadCount(1);
}

Thumbnails::~Thumbnails() {
    pool_.clear();
    pool_.waitForDone();
}

QImage Thumbnails::picture(const PicturePart& part) {
    if (const auto known = known_.find(part); known != known_.end())
        return known->second;
    if (!asked_.insert(part).second)
        return {};
    pool_.start(
        [this, part, read = read_] {
            QImage image;
            try {
                image = read(part);
            } catch (const std::exception&) { // out of memory: the row stays without a picture
                image = QImage();
            }
            QMetaObject::invokeMethod(
                this,
                [this, part, image] {
                    if (known_.size() >= most)
                        known_.clear();
                    asked_.erase(part);
                    known_[part] = image;
                    emit came(part.photo);
                },
                Qt::QueuedConnection);
        },
        ++next_);
    return {};
}

} // namespace tp
