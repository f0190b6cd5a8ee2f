// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/looking/look_worker.hpp"
#include "app/album/open/open_album.hpp"

#include <QLocale>
#include <QObject>
#include <QThread>
#include <QTimer>

#include <filesystem>
#include <functional>
#include <stop_token>

namespace tp {

/// Looks through the person's album while there is time: the photograph that is shown now first, then the newest on. On
/// a thread of its own that gives way to others; it begins when the album is scanned, and rests when all is
/// looked at. Belongs to the page's thread and never blocks it.
///
/// | state   | on, photographs to look at | a look ends, more  | nothing left | off            |
/// |---------|----------------------------|--------------------|--------------|----------------|
/// | resting | looking                    |                    |              |                |
/// | looking |                            | looking            | resting      | resting (soon) |
class AlbumLooks final : public QObject {
    Q_OBJECT
public:
    /// `album` must outlive it. `make_look` is for tests.
    explicit AlbumLooks(OpenAlbum& album, std::function<Look()> make_look = photo_look);
    ~AlbumLooks() override;

    /// Off at first.
    void set_on(bool on);
    /// In which language the search knows what was seen.
    void set_language(QLocale::Language language);
    /// Whether faces are to be known again; off at first.
    void set_marks(Marks marks);
    /// This one before all others: somebody is there.
    void want(const std::filesystem::path& photo);
    bool looking() const { return working_; }

signals:
    /// The index knows now what is on it.
    void looked(const std::filesystem::path& photo);
    void rested();

private:
    void begin_anew();
    void go_on();
    void take(const LookReport& report, bool wanted);

    OpenAlbum& album_;
    QThread thread_;
    LookWorker* worker_; ///< thread_ deletes it
    std::stop_source stop_;
    QLocale::Language language_ = QLocale::English;
    Marks marks_ = Marks::no;
    bool on_ = false;
    bool working_ = false;
    bool left_ = false;                 ///< there may be more to look at
    bool anew_ = false;                 ///< the way began anew since the task was given
    std::optional<PlaceInList> before_; ///< where the way through the album is
    std::filesystem::path wanted_;
    QTimer rest_; ///< the nets are given back when nobody has wanted them for a while
};

} // namespace tp
