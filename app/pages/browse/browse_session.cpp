// SPDX-License-Identifier: Apache-2.0
#include "app/pages/browse/browse_session.hpp"

#include <optional>
#include <utility>

namespace tp {

BrowseSession::BrowseSession(OpenAlbum& album, Narrator& narrator, EarconPlayer& earcons, Player& player,
                             Preferences& preferences, QSize screen)
    : teller_(narrator, earcons), tags_(player, narrator, preferences), album_(album),
      trail_(album_, teller_, tags_, preferences), details_(album_, trail_, teller_, tags_, screen),
      playback_(trail_, details_, teller_, tags_, player, preferences),
      lists_(album_, trail_, details_, teller_, tags_) {
    trail_.look_at_album();
}

// --- the page ---

void BrowseSession::enter() {
    trail_.enter();
    lists_.refresh();
    emit trail_.levelChanged();
    if (!trail_.ready())
        return teller_.tell(album_.emptyText(), Priority::message);
    if (trail_.view() != BrowseTrail::View::Photos)
        return lists_.tell();
    if (teller_.narrator().by() ==
        Narrator::By::screen_reader) // the photograph has the focus, and is read by itself
        return teller_.tell(tr("Your photographs."), Priority::message);
    const QString can =
        playback_.hasRecordings()
            ? tr("Swipe or use the arrow keys to move on; double tap or press Enter to listen.")
            : tr("Swipe or use the arrow keys to move on.");
    teller_.tell(tr("Your photographs, %1: %2 %3", "place, summary, what can be done")
                     .arg(trail_.placeText(), details_.summary(), can),
                 Priority::message);
}

void BrowseSession::leave() {
    trail_.leave();
    playback_.stop();
    teller_.narrator().stop();
}

void BrowseSession::whereAmI() {
    playback_.pause();
    if (!trail_.ready())
        return teller_.tell(album_.emptyText());
    if (trail_.view() != BrowseTrail::View::Photos)
        return lists_.tell();
    const QString where = tr("%1, %2: %3", "list, place in it, summary")
                              .arg(trail_.title(), trail_.placeText(), details_.summary());
    const std::optional<BrowsePlayback::Place> paused = playback_.place();
    teller_.tell(paused ? tr("%1 Paused: %2, at %3.", "where one is; the recording and the time in it")
                              .arg(where, paused->recording, paused->time)
                        : where);
}

bool BrowseSession::stop() {
    const bool spoke = teller_.narrator().speaking();
    const bool sounded = playback_.stop();
    teller_.narrator().stop();
    return spoke || sounded;
}

void BrowseSession::twoFingerTap() {
    tap_stopped_ = playback_.playing();
    stop();
}

void BrowseSession::twoFingerDoubleTap() {
    if (!std::exchange(tap_stopped_, false))
        playback_.play();
}

// --- the keys ---

QString BrowseSession::keys() const {
    return tr(
        "Left and right: previous and next photograph. Up and down: its details. Enter: play the recordings, "
        "or pause. Escape: stop. Plus and minus: faster and slower. Home and End: first and last photograph. "
        "S: search. P: people. Y: years. L: places. K: keywords. R: surprise me. A: all photographs. "
        "Backspace: back. E: feel the face. C: look after this photograph. W: where am I. H: these keys. A "
        "swipe does what its arrow key does, a double tap plays, a two-finger tap stops, a Z drawn with two "
        "fingers goes back, a three-finger tap says where you are.");
}

void BrowseSession::tellKeys() {
    playback_.pause();
    teller_.tell(keys());
}

// --- other pages ---

void BrowseSession::askExplore() {
    if (trail_.ready_or_refuse())
        emit exploreAsked(trail_.photo());
}

void BrowseSession::askCare() {
    if (trail_.ready_or_refuse())
        emit careAsked(trail_.photo());
}

} // namespace tp
