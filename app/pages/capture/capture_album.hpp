// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/keeper/album_keeper.hpp"
#include "app/capture/shutter/photograph_store.hpp"

#include <QObject>
#include <QString>
#include <QThreadPool>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace tp {

/// Where photographs that are taken are kept. Its steps are done on a thread of their own, one after the other, so that the
/// page never waits for the disk; each can be taken back. It has a keeper of its own: what other pages did is theirs to
/// undo.
class CaptureAlbum final : public QObject {
    Q_OBJECT
public:
    /// A folder of the person's album; made where it is missing.
    using Folder = std::function<std::filesystem::path()>;
    /// Runs on the steps' thread. Empty when done; else the sentence that says why not.
    using Step = std::function<std::string(AlbumKeeper&, PhotographStore&)>;
    /// Runs on the thread that asked, with the same words in the person's language.
    using Then = std::function<void(const QString& problem)>;

    explicit CaptureAlbum(Folder folder) : folder_(std::move(folder)) { pool_.setMaxThreadCount(1); }
    /// Waits until everything that was asked for is on the disk.
    ~CaptureAlbum() override { pool_.waitForDone(); }

    void run(Step step, Then then);
    /// A step is being done or waits to be.
    bool busy() const { return waiting_ > 0; }
    /// Takes the newest step back. `what` it was about, in words.
    void undo(std::function<void(const QString& what, const QString& problem)> then);
    /// So many steps can be taken back.
    std::size_t steps() const { return steps_; }

signals:
    void changed();

private:
    void work(const std::filesystem::path& folder, const Step& step, const Then& then);

    Folder folder_;
    std::size_t steps_ = 0;
    int waiting_ = 0;
    std::optional<AlbumKeeper> keeper_; ///< of the steps' thread alone, and made anew for another folder
    QThreadPool pool_;                  ///< last: it ends before what its work is for
};

} // namespace tp
