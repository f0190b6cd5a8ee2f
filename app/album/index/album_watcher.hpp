// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include <chrono>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace tp {

/// Notices when other programs change an album: files that come, go or are renamed, also sidecars and
/// recordings; not those whose bytes are written over in place, which the next scan finds. Where the system
/// watches no more folders, the rest is looked at from time to time. Belongs to a thread with an event loop.
class AlbumWatcher : public QObject {
    Q_OBJECT
public:
    struct Times {
        std::chrono::milliseconds settle{1500}; ///< without events before `changed` is sent
        std::chrono::milliseconds poll{30'000}; ///< between looks at what the system does not watch
    };
    explicit AlbumWatcher(Times times, QObject* parent = nullptr);

    /// Watches these folders and no others: `AlbumIndex::folders`, before a scan and again after it, so that
    /// nothing falls between the two.
    void set_folders(const std::vector<std::filesystem::path>& folders);
    /// For tests: how many folders the system may watch.
    void set_most_watched(std::size_t most) { most_watched_ = most; }
    std::size_t polled_count() const { return polled_.size(); }

    /// Looks now at what the system does not watch.
    void poll();

signals:
    /// In these folders something changed and nothing has for a while (`rescan_folders`).
    void changed(const std::vector<std::filesystem::path>& folders);
    /// A sentence, said once: not everything can be watched.
    void limited(const std::string& sentence);

private:
    void note(const std::filesystem::path& folder);
    void send();

    Times times_;
    QFileSystemWatcher watcher_;
    QTimer settle_;
    QTimer poll_;
    std::size_t most_watched_ = 100'000;
    std::map<std::filesystem::path, std::string> polled_; ///< with their stamps
    std::set<std::filesystem::path> changed_;
    bool said_ = false;
};

} // namespace tp
