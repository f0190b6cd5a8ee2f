// SPDX-License-Identifier: Apache-2.0
#include "app/album/open/open_album.hpp"

#include "app/album/open/lies_in.hpp"
#include "audio/sentences/sentences.hpp"
#include "core/files/file_name.hpp"

#include <QMetaObject>
#include <QStandardPaths>

#include <algorithm>
#include <system_error>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_said = 3; ///< sentences of one scan; the rest is counted

AlbumIndex opened(const fs::path& cache) {
    Result<AlbumIndex> index = AlbumIndex::open(cache);
    if (!index)
        qFatal("%s", index.error().c_str());
    return std::move(index).value();
}

/// As the index writes them; folders within others left out.
std::vector<fs::path> real_folders(const QStringList& chosen) {
    std::vector<fs::path> all;
    for (const QString& folder : chosen) {
        std::error_code error;
        fs::path real = fs::weakly_canonical(path_named(folder.toStdString()), error);
        if (real.filename().empty()) // ends in a slash
            real = real.parent_path();
        all.push_back(error ? path_named(folder.toStdString()) : std::move(real));
    }
    std::vector<fs::path> outer;
    for (const fs::path& folder : all)
        if (std::none_of(all.begin(), all.end(),
                         [&](const fs::path& other) { return other != folder && lies_in(folder, other); }) &&
            std::find(outer.begin(), outer.end(), folder) == outer.end())
            outer.push_back(folder);
    return outer;
}

} // namespace

OpenAlbum::OpenAlbum(const fs::path& cache, Preferences& preferences, AlbumWatcher::Times times,
                     QObject* parent)
    : QObject(parent), preferences_(preferences), index_(opened(cache)),
      worker_(new AlbumWorker(index_, times)) {
    thread_.setObjectName("album");
    worker_->moveToThread(&thread_);
    connect(&thread_, &QThread::finished, worker_, &QObject::deleteLater);
    connect(worker_, &AlbumWorker::progress, this, &OpenAlbum::show_progress);
    connect(worker_, &AlbumWorker::done, this, &OpenAlbum::finish);
    connect(worker_, &AlbumWorker::said, this, &OpenAlbum::said);
    connect(worker_, &AlbumWorker::changed, this, [this](const std::vector<fs::path>& folders) {
        want_folders_.insert(folders.begin(), folders.end());
        go_on();
    });
    connect(worker_, &AlbumWorker::folders_came_or_went, this, &OpenAlbum::rescan);
    connect(&preferences_, &Preferences::changed, this, &OpenAlbum::follow_preferences);
    thread_.start();
    QMetaObject::invokeMethod( // when somebody listens
        this, [this] { say_new(index_.notices()); }, Qt::QueuedConnection);
    chosen_ = preferences_.choices().folders;
    folders_ = real_folders(chosen_);
    rescan();
}

OpenAlbum::~OpenAlbum() {
    stop_.request_stop();
    thread_.quit();
    thread_.wait();
}

fs::path OpenAlbum::usual_cache() {
    return QStandardPaths::writableLocation(QStandardPaths::CacheLocation).toStdString();
}

fs::path OpenAlbum::folder_of(const fs::path& photo) const {
    for (const fs::path& folder : folders_)
        if (lies_in(photo, folder))
            return folder;
    return photo.parent_path();
}

AlbumKeeper& OpenAlbum::keeper_for(const fs::path& photo) {
    const fs::path folder = folder_of(photo);
    return keepers_.try_emplace(folder, folder).first->second;
}

void OpenAlbum::rescan() {
    want_whole_ = true;
    go_on();
}

void OpenAlbum::touched(const fs::path& photo) {
    want_folders_.insert(photo.parent_path());
    if (working_whole_)
        stop(); // it goes on afterwards
    go_on();
}

void OpenAlbum::follow_preferences() {
    if (preferences_.choices().folders == chosen_)
        return;
    chosen_ = preferences_.choices().folders;
    folders_ = real_folders(chosen_);
    told_.clear();
    want_folders_.clear();
    if (working_)
        stop();
    emit folders_changed();
    rescan();
}

void OpenAlbum::stop() { stop_.request_stop(); }

/// Gives the worker its next task where it has none: what a person has just changed comes first.
void OpenAlbum::go_on() {
    if (working_)
        return;
    AlbumTask task;
    if (!want_folders_.empty()) {
        task.folders.assign(want_folders_.begin(), want_folders_.end());
        want_folders_.clear();
    } else if (std::exchange(want_whole_, false)) {
        task.whole = true;
        task.folders = folders_;
    } else {
        set_scanning(false);
        return;
    }
    working_ = true;
    working_whole_ = task.whole;
    show_progress(0, 0, -1, false);
    stop_ = std::stop_source();
    QMetaObject::invokeMethod(worker_, [worker = worker_, task = std::move(task), token = stop_.get_token()] {
        worker->work(task, token);
    });
    set_scanning(true);
}

void OpenAlbum::show_progress(qulonglong done, qulonglong total, qlonglong left_ms, bool grown) {
    done_ = static_cast<int>(done);
    total_ = static_cast<int>(total);
    seconds_left_ = left_ms < 0 ? -1 : static_cast<int>((left_ms + 999) / 1000);
    emit progress_changed();
    if (grown)
        emit album_changed();
}

void OpenAlbum::finish(const AlbumTaskReport& report) {
    working_ = false;
    if (report.stopped && working_whole_)
        want_whole_ = true;
    working_whole_ = false;
    say_new(report.problems);
    go_on();
    if (report.changed)
        emit album_changed();
}

void OpenAlbum::say_new(const std::vector<std::string>& problems) {
    std::size_t fresh = 0;
    for (const std::string& problem : problems)
        if (told_.insert(problem).second && ++fresh <= most_said)
            emit said(in_persons_language(problem));
    if (fresh > most_said)
        emit said(
            tr("%n more thing(s) in the album need checking.", nullptr, static_cast<int>(fresh - most_said)));
}

void OpenAlbum::set_scanning(bool scanning) {
    if (scanning == scanning_)
        return;
    scanning_ = scanning;
    emit scanning_changed();
}

} // namespace tp
