// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/browse/browse_details.hpp"
#include "app/pages/browse/browse_teller.hpp"
#include "app/pages/browse/browse_trail.hpp"
#include "app/pages/browse/tag_playback.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "audio/sound/player.hpp"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace tp {

/// The recordings of the photograph that is shown, as a person hears them.
class BrowsePlayback final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")

    Q_PROPERTY(bool playing READ playing NOTIFY changed)
    /// Of the recording that is heard or paused: what it is and where; empty: none is.
    Q_PROPERTY(QString heard READ heard NOTIFY progressed)
    /// How much of it, 0 … 1.
    Q_PROPERTY(double heardValue READ heardValue NOTIFY progressed)
    Q_PROPERTY(QString speedText READ speedText NOTIFY speedChanged)
    /// What went wrong with this photograph's recordings; empty: nothing.
    Q_PROPERTY(QString notice READ notice NOTIFY noticeChanged)
public:
    /// All must outlive this; `player` is that of `tags`.
    BrowsePlayback(BrowseTrail& trail, BrowseDetails& details, BrowseTeller& teller, TagPlayback& tags,
                   Player& player, Preferences& preferences);

    bool playing() const { return tags_.playing(); }
    bool hasRecordings() const { return !tags_.tags().empty(); }
    QString heard() const;
    double heardValue() const;
    QString speedText() const;
    const QString& notice() const { return notice_; }

    /// Plays, pauses and goes on; on the detail of a recording that one alone.
    Q_INVOKABLE void play();
    Q_INVOKABLE void faster() { change_speed(1); }
    Q_INVOKABLE void slower() { change_speed(-1); }
    void pause() { tags_.pause(); }
    /// What plays ends; false where it is quiet already.
    bool stop() { return tags_.stop(); }
    /// Of the recording that is heard or paused: "memo by Tom", "3 seconds"; none is.
    struct Place {
        QString recording, time;
    };
    std::optional<Place> place() const;

signals:
    void changed();
    void progressed();
    void speedChanged();
    void noticeChanged();

private:
    void change_speed(int by);
    void set_notice(const QString& notice);
    const Tag* current() const;

    BrowseTrail& trail_;
    BrowseDetails& details_;
    BrowseTeller& teller_;
    TagPlayback& tags_;
    Preferences& preferences_;
    QString notice_;
};

} // namespace tp
