// SPDX-License-Identifier: Apache-2.0
#include "app/pages/capture/capture_album.hpp"

#include "audio/sentences/sentences.hpp"

#include <QMetaObject>

#include <exception>
#include <memory>
#include <utility>

namespace tp {

void CaptureAlbum::run(Step step, Then then) {
    ++waiting_;
    pool_.start([this, folder = folder_(), step = std::move(step), then = std::move(then)] {
        work(folder, step, then);
    });
}

void CaptureAlbum::work(const std::filesystem::path& folder, const Step& step, const Then& then) {
    std::string problem;
    std::size_t steps = 0;
    try {
        if (!keeper_ || keeper_->album() != folder)
            keeper_.emplace(folder);
        PhotographStore store(*keeper_, folder);
        problem = step(*keeper_, store);
        steps = keeper_->history().steps();
    } catch (const std::exception& fault) { // out of memory, mostly
        problem = std::string("This could not be done, because the computer reports: ") + fault.what();
    }
    QMetaObject::invokeMethod(this, [this, then, steps, problem = in_persons_language(problem)] {
        --waiting_;
        steps_ = steps;
        then(problem);
        emit changed();
    });
}

void CaptureAlbum::undo(std::function<void(const QString& what, const QString& problem)> then) {
    const auto what = std::make_shared<std::string>();
    run(
        [what](AlbumKeeper& keeper, PhotographStore&) {
            std::string problem = keeper.history().undo();
            *what = keeper.history().next_redo();
            return problem;
        },
        [what, then = std::move(then)](const QString& problem) {
            then(in_persons_language(*what), problem);
        });
}

} // namespace tp
