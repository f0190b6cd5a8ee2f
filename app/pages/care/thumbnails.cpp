// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/thumbnails.hpp"

#include "app/photo/picture/overlay.hpp"
#include "faces/decode/picture.hpp"

#include <QMetaObject>

#include <exception>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

Thumbnails::Thumbnails(Read read, QObject* parent) : QObject(parent), read_(std::move(read)) {
    if (!read_)
        read_ = [](const fs::path& photo) {
            const auto picture = read_picture_to_fit(photo, {side_px, side_px});
            return picture ? to_image(*picture) : QImage();
        };
    pool_.setMaxThreadCount(1);
}

Thumbnails::~Thumbnails() {
    pool_.clear();
    pool_.waitForDone();
}

QImage Thumbnails::picture(const fs::path& photo) {
    if (const auto known = known_.find(photo); known != known_.end())
        return known->second;
    if (!asked_.insert(photo).second)
        return {};
    pool_.start(
        [this, photo, read = read_] {
            QImage image;
            try {
                image = read(photo);
            } catch (const std::exception&) { // out of memory: the row stays without a picture
                image = QImage();
            }
            QMetaObject::invokeMethod(
                this,
                [this, photo, image] {
                    if (known_.size() >= most)
                        known_.clear();
                    asked_.erase(photo);
                    known_[photo] = image;
                    emit came(photo);
                },
                Qt::QueuedConnection);
        },
        ++next_);
    return {};
}

} // namespace tp
