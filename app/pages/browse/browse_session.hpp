// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/open/open_album.hpp"
#include "app/pages/browse/browse_album.hpp"
#include "app/pages/browse/browse_details.hpp"
#include "app/pages/browse/browse_lists.hpp"
#include "app/pages/browse/browse_playback.hpp"
#include "app/pages/browse/browse_teller.hpp"
#include "app/pages/browse/browse_trail.hpp"
#include "app/pages/browse/tag_playback.hpp"
#include "app/parts/narration/narrator.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "audio/sound/earcon_player.hpp"
#include "audio/sound/player.hpp"

#include <QObject>
#include <QSize>
#include <QString>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// The album, one photograph at a time: the parts that decide what the browse page shows and tells, each with
/// one thing to care for, and what concerns several of them. A part knows those before it. The page only
/// binds and draws.
class BrowseSession final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(tp::BrowseAlbum* album READ album CONSTANT)
    Q_PROPERTY(tp::BrowseTrail* trail READ trail CONSTANT)
    Q_PROPERTY(tp::BrowseDetails* details READ details CONSTANT)
    Q_PROPERTY(tp::BrowsePlayback* playback READ playback CONSTANT)
    Q_PROPERTY(tp::BrowseLists* lists READ lists CONSTANT)
    /// Every key of the page, and the gestures.
    Q_PROPERTY(QString keys READ keys CONSTANT)
public:
    /// All must outlive the session; `player` and what it sounds through are its own. Pictures are read to
    /// fit `screen`.
    BrowseSession(OpenAlbum& album, Narrator& narrator, EarconPlayer& earcons, Player& player,
                  Preferences& preferences, QSize screen = {1920, 1200});

    BrowseAlbum* album() { return &album_; }
    BrowseTrail* trail() { return &trail_; }
    BrowseDetails* details() { return &details_; }
    BrowsePlayback* playback() { return &playback_; }
    BrowseLists* lists() { return &lists_; }
    QString keys() const;

    /// The page is shown: tells where one is and what can be done.
    Q_INVOKABLE void enter();
    /// Another page is shown.
    Q_INVOKABLE void leave();

    Q_INVOKABLE void whereAmI();
    Q_INVOKABLE void tellKeys();
    /// What sounds or is said ends; false where it is quiet already.
    Q_INVOKABLE bool stop();
    /// Two fingers: what sounds stops. Twice: the recordings are heard, or stop.
    Q_INVOKABLE void twoFingerTap();
    Q_INVOKABLE void twoFingerDoubleTap();

    Q_INVOKABLE void askExplore();
    Q_INVOKABLE void askCare();

signals:
    void exploreAsked(const QString& photo);
    void careAsked(const QString& photo);
    /// Folders are to be chosen.
    void settingsAsked();
    void importAsked();

private:
    BrowseTeller teller_;
    TagPlayback tags_;
    BrowseAlbum album_;
    BrowseTrail trail_;
    BrowseDetails details_;
    BrowsePlayback playback_;
    BrowseLists lists_;
    bool tap_stopped_ = false; ///< the first of two taps of two fingers
};

} // namespace tp
