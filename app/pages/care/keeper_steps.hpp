// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/keeper/album_keeper.hpp"

#include <QObject>
#include <QString>
#include <QThreadPool>

#include <functional>
#include <string>

namespace tp {

/// Does steps of an AlbumKeeper on a thread of its own, one after the other in the order asked for, so that the page
/// never waits for the disk. All calls and answers are on the thread that made it, which needs an event loop.
class KeeperSteps final : public QObject {
    Q_OBJECT
public:
    /// Runs on the steps' thread. Empty when done; else the sentence that says why not.
    using Step = std::function<std::string(AlbumKeeper&)>;
    /// Runs on the thread that asked, with the same words.
    using Then = std::function<void(const QString& problem)>;

    explicit KeeperSteps(QObject* parent = nullptr);
    /// Waits until everything that was asked for is on the disk.
    ~KeeperSteps() override;

    /// The keeper must outlive the step.
    void run(AlbumKeeper& keeper, Step step, Then then);
    /// Takes the newest step back, or does the last undone one again; of the keeper that worked last.
    void undo(Then then);
    void redo(Then then);

    /// Something is being done or waits to be.
    bool busy() const { return waiting_ > 0; }
    /// One of them is undo() or redo().
    bool steps_back() const { return stepping_back_ > 0; }
    /// What undo() and redo() would be about, in words; empty: nothing.
    const QString& next_undo() const { return next_undo_; }
    const QString& next_redo() const { return next_redo_; }
    /// The keeper that undo() and redo() are about from now on.
    void use(AlbumKeeper& keeper);

signals:
    /// A step was done or refused.
    void changed();

private:
    void begin(AlbumKeeper& keeper, Step step, Then then);
    void step_back(Step step, Then then);

    QThreadPool pool_; ///< of one thread
    AlbumKeeper* last_ = nullptr;
    int waiting_ = 0;
    int stepping_back_ = 0;
    QString next_undo_, next_redo_;
};

} // namespace tp
