// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/index/album_index.hpp"
#include "app/album/index/album_queries.hpp"
#include "app/album/index/album_watcher.hpp"
#include "app/album/keeper/album_keeper.hpp"
#include "app/album/open/album_worker.hpp"
#include "app/parts/preferences/preferences.hpp"

#include <QObject>
#include <QString>
#include <QThread>

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

namespace tp {

/// The person's album while the program runs: the folders that were chosen (Preferences), their index for the
/// pages to ask, and the keepers that change them. Scans on a thread of its own when the folders change, when
/// other programs or our own pages change something in them, and when asked to. Belongs to the page's thread
/// and never blocks it.
class OpenAlbum final : public QObject {
    Q_OBJECT
    Q_PROPERTY(bool hasFolders READ has_folders NOTIFY folders_changed)
    Q_PROPERTY(bool scanning READ scanning NOTIFY scanning_changed)
    Q_PROPERTY(int done READ done NOTIFY progress_changed)
    Q_PROPERTY(int total READ total NOTIFY progress_changed)
    Q_PROPERTY(int secondsLeft READ seconds_left NOTIFY progress_changed)
public:
    /// Opens or makes the index in the folder `cache` and begins to scan. `preferences` must outlive this.
    /// Without Qt's driver for SQLite, which the program is installed with, the program ends with a message.
    OpenAlbum(const std::filesystem::path& cache, Preferences& preferences,
              AlbumWatcher::Times times = AlbumWatcher::Times(), QObject* parent = nullptr);
    ~OpenAlbum() override;
    /// In the user's folder for what may be thrown away.
    static std::filesystem::path usual_cache();

    AlbumIndex& index() { return index_; }
    AlbumQueries queries() { return AlbumQueries(index_); }

    /// A person has chosen folders for the album.
    bool has_folders() const { return !folders_.empty(); }
    /// The chosen folders as the index knows them: absolute, without symbolic links, none within another.
    const std::vector<std::filesystem::path>& folders() const { return folders_; }
    /// The album's folder that a photograph lies in; of one that lies in none, its own folder.
    std::filesystem::path folder_of(const std::filesystem::path& photo) const;
    /// Who changes things in that folder; the same one every time, so that what was done can be taken back.
    /// Tell `touched` afterwards.
    AlbumKeeper& keeper_for(const std::filesystem::path& photo);

    /// Looks through the whole album for what is new.
    Q_INVOKABLE void rescan();
    /// A page changed something about this photograph: the index learns it, before anything else.
    void touched(const std::filesystem::path& photo);

    bool scanning() const { return scanning_; }
    /// Of the scan that is going on: photographs read of those that are new or changed; both 0 while it only
    /// looks.
    int done() const { return done_; }
    int total() const { return total_; }
    int seconds_left() const { return seconds_left_; } ///< −1: not known

signals:
    void folders_changed();
    void scanning_changed();
    void progress_changed();
    /// What pages show of the album may have changed: to be asked anew.
    void album_changed();
    /// A whole sentence for the person who looks after the album; each is said once until other folders are
    /// chosen.
    void said(const QString& sentence);

private:
    void follow_preferences();
    void go_on();
    void stop();
    void show_progress(qulonglong done, qulonglong total, qlonglong left_ms, bool grown);
    void finish(const AlbumTaskReport& report);
    void say_new(const std::vector<std::string>& problems);
    void set_scanning(bool scanning);

    Preferences& preferences_;
    AlbumIndex index_;
    QStringList chosen_; ///< as the preferences have them
    std::vector<std::filesystem::path> folders_;
    std::map<std::filesystem::path, AlbumKeeper> keepers_;

    QThread thread_;
    AlbumWorker* worker_;   ///< thread_ deletes it
    std::stop_source stop_; ///< of the task that the worker has
    bool working_ = false;  ///< the worker has a task
    bool working_whole_ = false;
    bool want_whole_ = false;                      ///< to be scanned next, after
    std::set<std::filesystem::path> want_folders_; ///< these
    std::set<std::string> told_;

    bool scanning_ = false;
    int done_ = 0, total_ = 0, seconds_left_ = -1;
};

} // namespace tp
