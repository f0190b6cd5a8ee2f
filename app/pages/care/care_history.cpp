// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/care_history.hpp"

#include "app/pages/care/care_words.hpp"

#include <system_error>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

CareHistory::CareHistory(KeeperSteps& steps, CaredPhoto& photo, OpenAlbum& album, RecordingWait& recording,
                         CareTeller& teller)
    : steps_(steps), photo_(photo), album_(album), recording_(recording), teller_(teller) {
    connect(&steps_, &KeeperSteps::changed, this, &CareHistory::changed);
}

void CareHistory::undo() {
    if (!recording_.refused())
        steps_.undo([this](const QString& problem) { stepped(Way::back, steps_.next_redo(), problem); });
}

void CareHistory::redo() {
    if (!recording_.refused())
        steps_.redo([this](const QString& problem) { stepped(Way::forth, steps_.next_undo(), problem); });
}

void CareHistory::delete_photo(const PhotoPlace& place) {
    recording_.after([this, place] {
        photo_.change(
            place, [](AlbumKeeper& keeper, const fs::path& photo) { return keeper.delete_photo(photo); },
            [this, place](const QString& problem) {
                if (!problem.isEmpty()) {
                    teller_.problem(problem);
                    if (!photo_.is_open())
                        photo_.open(place);
                    return;
                }
                gone_ = place.photo;
                teller_.did(Earcon::deleted,
                            tr("Deleted: %1. Undo brings it back.").arg(CareWords::file_name(place.photo)));
            });
    });
}

void CareHistory::stepped(Way way, const QString& what, const QString& problem) {
    if (!problem.isEmpty()) {
        teller_.problem(problem);
        return;
    }
    follow_photo();
    if (!gone_.empty())
        album_.touched(gone_);
    if (photo_.is_open())
        album_.touched(photo_.place().photo);
    else
        album_.rescan(); // it may have been about many photographs
    teller_.did(Earcon::undone, way == Way::back ? tr("Undone: %1.").arg(what) : tr("Redone: %1.").arg(what));
}

/// The open photograph may have gone with the step, or the one that had gone may be there again.
void CareHistory::follow_photo() {
    std::error_code error;
    if (photo_.is_open() && !fs::exists(photo_.place().photo, error)) {
        gone_ = photo_.place().photo;
        photo_.close();
    } else if (!gone_.empty() && fs::exists(gone_, error)) {
        const fs::path photo = std::exchange(gone_, {});
        album_.touched(photo);
        photo_.open({photo, &album_.keeper_for(photo)});
    } else {
        photo_.read_again();
    }
}

} // namespace tp
