// SPDX-License-Identifier: Apache-2.0
#include "app/album/looking/album_looks.hpp"

#include <QMetaObject>

#include <chrono>
#include <utility>

namespace tp {

namespace {
constexpr std::chrono::seconds rest_after{30};
} // namespace

AlbumLooks::AlbumLooks(OpenAlbum& album, std::function<Look()> make_look)
    : album_(album), worker_(new LookWorker(album.index(), std::move(make_look))) {
    thread_.setObjectName("album looks");
    worker_->moveToThread(&thread_);
    connect(&thread_, &QThread::finished, worker_, &QObject::deleteLater);
    rest_.setSingleShot(true);
    rest_.setInterval(rest_after);
    connect(&rest_, &QTimer::timeout, worker_, &LookWorker::rest);
    connect(&album_, &OpenAlbum::album_changed, this, &AlbumLooks::begin_anew);
    connect(&album_, &OpenAlbum::scanning_changed, this, &AlbumLooks::begin_anew);
    thread_.start();
}

AlbumLooks::~AlbumLooks() {
    stop_.request_stop();
    thread_.quit();
    thread_.wait();
}

void AlbumLooks::set_on(bool on) {
    if (std::exchange(on_, on) == on)
        return;
    if (!on)
        stop_.request_stop();
    begin_anew();
}

void AlbumLooks::set_language(QLocale::Language language) {
    if (std::exchange(language_, language) != language)
        begin_anew();
}

void AlbumLooks::set_marks(Marks marks) {
    if (std::exchange(marks_, marks) == marks)
        return;
    stop_.request_stop(); // what is under way knows the old choice
    begin_anew();
}

void AlbumLooks::want(const std::filesystem::path& photo) {
    wanted_ = photo;
    go_on();
}

void AlbumLooks::begin_anew() {
    before_.reset();
    left_ = anew_ = true;
    go_on();
}

void AlbumLooks::go_on() {
    const bool wanted = !wanted_.empty();
    if (!on_ || working_ || (!wanted && (!left_ || album_.scanning())))
        return;
    working_ = true;
    anew_ = false;
    rest_.stop();
    stop_ = std::stop_source();
    const LookTask task{std::exchange(wanted_, {}), before_, language_, marks_, stop_.get_token()};
    QMetaObject::invokeMethod(worker_, [this, task, wanted] {
        const LookReport report = worker_->work(task);
        QMetaObject::invokeMethod(this, [this, report, wanted] { take(report, wanted); });
    });
}

void AlbumLooks::take(const LookReport& report, bool wanted) {
    working_ = false;
    if (!report.photo.empty())
        emit looked(report.photo);
    if (!wanted && !anew_) {
        left_ = report.place.has_value();
        before_ = report.place;
    }
    go_on();
    if (!working_) {
        rest_.start();
        emit rested();
    }
}

} // namespace tp
