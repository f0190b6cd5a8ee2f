// SPDX-License-Identifier: Apache-2.0
#include "app/photo/picture/picture_ahead.hpp"

#include "app/photo/picture/overlay.hpp"
#include "core/files/file_system.hpp"
#include "faces/decode/picture.hpp"

#include <QMetaObject>

#include <algorithm>
#include <exception>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

namespace {

/// The one that is wanted, and beside it one that was begun when another was.
constexpr int threads = 2;

/// Another one, another content: size, and when it was written.
std::string stamp_of(const fs::path& file) {
    const auto facts = facts_of(file);
    return facts ? std::to_string(facts->bytes) + " " + std::to_string(facts->written_ns) : std::string{};
}

std::size_t bytes_of(const ShownPicture& picture) { return static_cast<std::size_t>(picture.image.sizeInBytes()); }

ShownPicture read_to_fit(const fs::path& photo, QSize screen) {
    ShownPicture shown;
    const auto picture = read_picture_to_fit(photo, {screen.width(), screen.height()});
    if (picture)
        shown.image = to_image(*picture);
    else
        shown.problem = picture.error();
    return shown;
}

} // namespace

PictureAhead::PictureAhead(QSize screen, std::size_t most_bytes, Read read, QObject* parent)
    : QObject(parent), screen_(screen), most_bytes_(most_bytes), read_(read ? std::move(read) : read_to_fit) {
    pool_.setMaxThreadCount(threads);
}

PictureAhead::~PictureAhead() {
    pool_.clear();
    pool_.waitForDone();
}

void PictureAhead::show(const fs::path& photo, std::vector<fs::path> next) {
    wanted_ = photo;
    next_ = std::move(next);
    answered_ = false;
    if (const auto held = find(photo); held != held_.end()) {
        held_.splice(held_.begin(), held_, held);
        answered_ = true;
        emit ready(held_.front());
    }
    go_on();
}

std::size_t PictureAhead::held_bytes() const {
    std::size_t bytes = 0;
    for (const auto& picture : held_)
        if (picture->photo != wanted_)
            bytes += bytes_of(*picture);
    return bytes;
}

PictureAhead::Held::iterator PictureAhead::find(const fs::path& photo) {
    const auto held = std::find_if(held_.begin(), held_.end(), [&](const auto& one) { return one->photo == photo; });
    if (held == held_.end() || (*held)->stamp == stamp_of(photo))
        return held;
    held_.erase(held); // it was changed since
    return held_.end();
}

void PictureAhead::go_on() {
    if (reading_.size() >= threads)
        return;
    if (!answered_) {
        if (!reading_.contains(wanted_))
            start(wanted_);
        return; // nothing takes the time of the one that a person waits for
    }
    const std::size_t largest = 4 * static_cast<std::size_t>(screen_.width()) * static_cast<std::size_t>(screen_.height());
    std::size_t bytes = 0; // of those that are likelier
    for (const fs::path& photo : next_) {
        if (reading_.contains(photo))
            return;
        const auto held = find(photo);
        if (held == held_.end()) {
            if (bytes + largest > most_bytes_)
                break;
            start(photo);
            return;
        }
        bytes += bytes_of(**held);
    }
    if (reading_.empty())
        emit idle();
}

void PictureAhead::start(const fs::path& photo) {
    reading_.insert(photo);
    pool_.start([this, photo, screen = screen_, read = read_] {
        auto picture = std::make_shared<ShownPicture>();
        const std::string stamp = stamp_of(photo); // before it is read: a change meanwhile shows
        try {
            *picture = read(photo, screen);
        } catch (const std::exception&) { // out of memory, mostly
            picture->problem = "This picture could not be read. It may be too large for this computer.";
        }
        picture->photo = photo;
        picture->stamp = stamp;
        QMetaObject::invokeMethod(this, [this, picture] { take(picture); }, Qt::QueuedConnection);
    });
}

void PictureAhead::take(std::shared_ptr<const ShownPicture> picture) {
    reading_.erase(picture->photo);
    if (const auto before = std::find_if(held_.begin(), held_.end(),
                                         [&](const auto& one) { return one->photo == picture->photo; });
        before != held_.end())
        held_.erase(before);
    const bool wanted = picture->photo == wanted_;
    held_.push_front(picture);
    make_room();
    if (wanted) {
        answered_ = true;
        emit ready(std::move(picture));
    }
    go_on();
}

/// Forgets what was shown longest ago, and what may be next only after that, the likeliest last; never the one that is
/// wanted.
void PictureAhead::make_room() {
    const auto rank = [this](const fs::path& photo) {
        return std::find(next_.begin(), next_.end(), photo) - next_.begin();
    };
    while (held_bytes() > most_bytes_) {
        auto worst = held_.end();
        for (auto one = held_.begin(); one != held_.end(); ++one)
            if ((*one)->photo != wanted_ && (worst == held_.end() || rank((*one)->photo) >= rank((*worst)->photo)))
                worst = one;
        held_.erase(worst);
    }
}

} // namespace tp
