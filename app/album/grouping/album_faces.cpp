// SPDX-License-Identifier: Apache-2.0
#include "app/album/grouping/album_faces.hpp"

#include <QMetaObject>

#include <chrono>
#include <utility>

namespace tp {

namespace {
constexpr std::size_t batch = 100; ///< photographs
constexpr std::chrono::milliseconds between_lists{300};
} // namespace

AlbumFaces::AlbumFaces(OpenAlbum& album) : album_(album), worker_(new GroupWorker(album.index())) {
    thread_.setObjectName("album faces");
    worker_->moveToThread(&thread_);
    connect(&thread_, &QThread::finished, worker_, &QObject::deleteLater);
    soon_.setSingleShot(true);
    soon_.setInterval(between_lists);
    connect(&soon_, &QTimer::timeout, this, &AlbumFaces::list);
    connect(&album_, &OpenAlbum::album_changed, this, &AlbumFaces::go_on);
    connect(&album_, &OpenAlbum::scanning_changed, this, &AlbumFaces::go_on);
    thread_.start();
}

AlbumFaces::~AlbumFaces() {
    thread_.quit();
    thread_.wait();
}

void AlbumFaces::set_on(bool on) {
    if (std::exchange(on_, on) == on)
        return;
    go_on();
}

void AlbumFaces::forget() {
    QMetaObject::invokeMethod(worker_, [this] {
        if (worker_->forget())
            QMetaObject::invokeMethod(this, &AlbumFaces::tell);
    });
}

void AlbumFaces::tell() {
    emit changed();
    if (wanted_)
        list();
    if (named_wanted_)
        list_named();
}

void AlbumFaces::go_on() {
    if (!on_) {
        forget();
        return;
    }
    anew_ = true;
    if (grouping_)
        return;
    grouping_ = true;
    anew_ = false;
    QMetaObject::invokeMethod(worker_, [this] {
        const GroupWorker::Report report = worker_->group(batch);
        QMetaObject::invokeMethod(this, [this, report] { take(report); });
    });
}

void AlbumFaces::take(const GroupWorker::Report& report) {
    grouping_ = false;
    if (report.changed) {
        emit changed();
        if (wanted_ && !soon_.isActive())
            soon_.start();
        if (named_wanted_)
            list_named();
    }
    if (report.more || anew_)
        go_on();
    if (!grouping_)
        emit rested();
}

void AlbumFaces::want_people(bool wanted) {
    wanted_ = wanted;
    if (wanted)
        list();
    else
        soon_.stop();
}

void AlbumFaces::list() {
    if (std::exchange(listing_, true)) {
        soon_.start();
        return;
    }
    QMetaObject::invokeMethod(worker_, [this] {
        auto found = std::make_shared<const People>(worker_->people());
        QMetaObject::invokeMethod(this, [this, found = std::move(found)] {
            listing_ = false;
            if (wanted_)
                emit people(found);
        });
    });
}

void AlbumFaces::want_named() {
    named_wanted_ = true;
    list_named();
}

void AlbumFaces::list_named() {
    QMetaObject::invokeMethod(worker_, [this] {
        QMetaObject::invokeMethod(this, [this, people = worker_->named()] { emit named(people); });
    });
}

void AlbumFaces::ask(const std::filesystem::path& photo) {
    if (!on_)
        return;
    QMetaObject::invokeMethod(worker_, [this, photo] {
        const std::vector<FaceOffer> offers = worker_->offers(photo);
        QMetaObject::invokeMethod(this, [this, photo, offers] { emit offered(photo, offers); });
    });
}

Result<GroupsChange> AlbumFaces::say(const GroupWorker::Word& word) {
    Result<GroupsChange> said = Error{};
    QMetaObject::invokeMethod(
        worker_, [&] { said = worker_->say(word); }, Qt::BlockingQueuedConnection);
    QMetaObject::invokeMethod(this, &AlbumFaces::tell);
    return said;
}

std::string AlbumFaces::undo(const GroupsChange& change) {
    std::string problem;
    QMetaObject::invokeMethod(
        worker_, [&] { problem = worker_->undo(change); }, Qt::BlockingQueuedConnection);
    QMetaObject::invokeMethod(this, &AlbumFaces::tell);
    return problem;
}

} // namespace tp
