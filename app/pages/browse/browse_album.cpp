// SPDX-License-Identifier: Apache-2.0
#include "app/pages/browse/browse_album.hpp"

#include "app/pages/browse/photo_words.hpp"

#include <utility>

namespace tp {

BrowseAlbum::BrowseAlbum(OpenAlbum& album) : album_(album) {
    connect(&album_, &OpenAlbum::scanning_changed, this, &BrowseAlbum::scanChanged);
    connect(&album_, &OpenAlbum::progress_changed, this, &BrowseAlbum::scanChanged);
}

bool BrowseAlbum::look(bool has_photo) {
    const State now = has_photo               ? State::Ready
                      : !album_.has_folders() ? State::NoFolders
                      : album_.scanning()     ? State::Looking
                                              : State::Empty;
    if (std::exchange(state_, now) == now)
        return false;
    emit stateChanged();
    return true;
}

QString BrowseAlbum::emptyText() const {
    switch (state_) {
    case State::NoFolders:
        return tr(
            "There is no album yet. Choose the folders of your photographs on the settings page, or import "
            "photographs.");
    case State::Looking:
        return tr("Looking for photographs in your folders.");
    case State::Empty:
        return tr("There are no photographs in your folders yet. Import some, or choose other folders on the "
                  "settings page.");
    case State::Ready:
        break;
    }
    return {};
}

QString BrowseAlbum::scanText() const {
    if (!album_.scanning())
        return {};
    if (album_.total() == 0)
        return tr("Looking for what is new in your folders");
    const QString done = tr("Reading new photographs, %1 of %2").arg(album_.done()).arg(album_.total());
    if (album_.seconds_left() < 0)
        return done;
    return tr("%1, about %2 left", "progress, and a time")
        .arg(done, PhotoWords().duration(album_.seconds_left()));
}

double BrowseAlbum::scanValue() const {
    return album_.total() == 0 ? -1.0 : static_cast<double>(album_.done()) / album_.total();
}

} // namespace tp
