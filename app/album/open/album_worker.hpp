// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/index/album_index.hpp"
#include "app/album/index/album_scan.hpp"
#include "app/album/index/album_watcher.hpp"

#include <QObject>

#include <filesystem>
#include <memory>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

namespace tp {

/// What OpenAlbum asks of its worker: the whole album, or some of its folders.
struct AlbumTask {
    bool whole = false;
    std::vector<std::filesystem::path> folders;
};

/// What became of it.
struct AlbumTaskReport {
    bool changed = false;              ///< the index says something else than before
    bool stopped = false;              ///< a next scan goes on where this one stopped
    std::vector<std::string> problems; ///< sentences
};

/// Brings an index up to date and notices what other programs change. Every call on the thread that it was
/// moved to; signals as they happen there.
class AlbumWorker final : public QObject {
    Q_OBJECT
public:
    /// Opens `index`, which must outlive this, once more for its own thread at the first task.
    AlbumWorker(const AlbumIndex& index, AlbumWatcher::Times times);

    void work(const AlbumTask& task, const std::stop_token& stop);

signals:
    /// Many a second at most; `grown`: there is more in the index than when it was true last.
    void progress(qulonglong done, qulonglong total, qlonglong left_ms, bool grown);
    void done(const tp::AlbumTaskReport& report);
    /// Other programs changed something in these folders of the album.
    void changed(const std::vector<std::filesystem::path>& folders);
    /// A chosen folder is there that was not, such as one on a stick, or the other way round.
    void folders_came_or_went();
    void said(const QString& sentence);

private:
    bool open();
    void scan(const AlbumTask& task, const std::stop_token& stop, AlbumTaskReport& report);
    void follow(const ScanTools& tools, AlbumTaskReport& report);
    void watch();
    void heed(const std::vector<std::filesystem::path>& folders);
    std::set<std::filesystem::path> absent_now() const;
    bool is_absent(const std::filesystem::path& folder) const;

    const AlbumIndex& shared_;
    AlbumWatcher::Times times_;
    std::unique_ptr<AlbumIndex> index_;
    std::unique_ptr<AlbumWatcher> watcher_;
    std::vector<std::filesystem::path> chosen_; ///< the album's folders
    std::set<std::filesystem::path> absent_;    ///< those of them that are not there
    std::set<std::filesystem::path> around_;    ///< the nearest folders around these that are
};

} // namespace tp
