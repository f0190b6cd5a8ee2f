// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/album_watcher.hpp"

#include "app/album/index/folder_listing.hpp"
#include "core/files/file_name.hpp"

#include <QSet>

#include <utility>

namespace tp {

namespace fs = std::filesystem;

namespace {

QString name_of(const fs::path& folder) { return QString::fromStdString(name_in_utf8(folder)); }

fs::path path_of(const QString& name) { return path_named(name.toStdString()); }

} // namespace

AlbumWatcher::AlbumWatcher(Times times, QObject* parent) : QObject(parent), times_(times) {
    settle_.setSingleShot(true);
    settle_.setInterval(times.settle);
    poll_.setInterval(times.poll);
    connect(&watcher_, &QFileSystemWatcher::directoryChanged, this,
            [this](const QString& name) { note(path_of(name)); });
    connect(&settle_, &QTimer::timeout, this, &AlbumWatcher::send);
    connect(&poll_, &QTimer::timeout, this, &AlbumWatcher::poll);
}

void AlbumWatcher::set_folders(const std::vector<fs::path>& folders) {
    std::map<fs::path, std::string> unwatched;
    QStringList wanted;
    for (const fs::path& folder : folders) {
        const QString name = name_of(folder);
        // a name that is no UTF-8 cannot be told to Qt
        if (path_of(name) == folder && static_cast<std::size_t>(wanted.size()) < most_watched_)
            wanted << name;
        else
            unwatched[folder];
    }
    const QStringList before = watcher_.directories();
    const QSet<QString> now(wanted.begin(), wanted.end()), had(before.begin(), before.end());
    if (const QStringList gone = (had - now).values(); !gone.empty())
        watcher_.removePaths(gone);
    if (const QStringList added = (now - had).values(); !added.empty())
        for (const QString& refused : watcher_.addPaths(added))
            unwatched[path_of(refused)];
    for (auto& [folder, stamp] : unwatched) {
        const auto known = polled_.find(folder);
        stamp = known != polled_.end() ? known->second : folder_stamp(folder);
    }
    polled_ = std::move(unwatched);
    if (polled_.empty())
        poll_.stop();
    else if (!poll_.isActive())
        poll_.start();
    if (!polled_.empty() && !std::exchange(said_, true))
        emit limited(
            "The system watches only a part of the album's folders; changes by other programs in the "
            "others are noticed " +
            std::to_string(std::chrono::ceil<std::chrono::seconds>(times_.poll).count()) + " seconds later.");
}

void AlbumWatcher::poll() {
    for (auto& [folder, stamp] : polled_)
        if (std::string now = folder_stamp(folder); now.empty() || now != stamp) {
            stamp = std::move(now);
            note(folder);
        }
}

void AlbumWatcher::note(const fs::path& folder) {
    changed_.insert(folder);
    settle_.start();
}

void AlbumWatcher::send() {
    const std::vector<fs::path> folders(changed_.begin(), changed_.end());
    changed_.clear();
    emit changed(folders);
}

} // namespace tp
