// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/grouping/group_worker.hpp"
#include "app/album/open/open_album.hpp"

#include <QObject>
#include <QThread>
#include <QTimer>

#include <filesystem>
#include <memory>
#include <vector>

namespace tp {

/// The faces of the person's album grouped by person while there is time, on a thread of its own. Belongs to the page's
/// thread and never blocks it; only what a person says waits, on the thread that says it.
///
/// | state   | on, faces came | all are grouped | off                             |
/// |---------|----------------|-----------------|---------------------------------|
/// | resting | grouping       |                 | all that is kept of faces goes  |
/// | grouping|                | resting         | the same, when a batch is ended |
class AlbumFaces final : public QObject {
    Q_OBJECT
public:
    /// `album` must outlive it. On at first.
    explicit AlbumFaces(OpenAlbum& album);
    ~AlbumFaces() override;

    /// Off: nothing is kept of faces, and nobody is offered.
    void set_on(bool on);
    bool on() const { return on_; }
    /// Faces may have come, or somebody may have said who they are. Off: what came all the same goes.
    void go_on();
    bool grouping() const { return grouping_; }

    /// `people` follows, now and whenever they have changed, until nobody wants them any more.
    void want_people(bool wanted);
    /// `named` follows, now and whenever somebody may be known by other faces than before.
    void want_named();
    /// `offered` follows.
    void ask(const std::filesystem::path& photo);

    // From any thread but the page's; they wait for their answer. Never after this object is gone.
    Result<GroupsChange> say(const GroupWorker::Word& word);
    std::string undo(const GroupsChange& change);

signals:
    void people(const std::shared_ptr<const tp::People>& people);
    /// By what people who have names are known in a picture of today.
    void named(const std::vector<tp::NamedFaces>& people);
    void offered(const std::filesystem::path& photo, const std::vector<tp::FaceOffer>& offers);
    /// Somebody may be offered now who was not before.
    void changed();
    void rested();

private:
    void take(const GroupWorker::Report& report);
    void forget();
    void tell();
    void list();
    void list_named();

    OpenAlbum& album_;
    QThread thread_;
    GroupWorker* worker_; ///< thread_ deletes it
    bool on_ = true;
    bool grouping_ = false;
    bool anew_ = false; ///< something came since the batch was begun
    bool wanted_ = false;
    bool named_wanted_ = false;
    bool listing_ = false;
    QTimer soon_; ///< people are listed at most so often
};

} // namespace tp
