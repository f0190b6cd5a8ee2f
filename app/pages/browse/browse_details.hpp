// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/browse/browse_album.hpp"
#include "app/pages/browse/browse_teller.hpp"
#include "app/pages/browse/browse_trail.hpp"
#include "app/pages/browse/photo_words.hpp"
#include "app/pages/browse/tag_playback.hpp"
#include "app/photo/picture/picture_ahead.hpp"

#include <QImage>
#include <QObject>
#include <QSize>
#include <QString>
#include <QtQml/qqmlregistration.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace tp {

/// What is known of the photograph that is shown: its picture, its summary, and its details one by one.
class BrowseDetails final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")

    Q_PROPERTY(QString summary READ summary NOTIFY changed)
    /// What up and down have gone to; the summary at first.
    Q_PROPERTY(QString detail READ detail NOTIFY changed)
    Q_PROPERTY(QImage picture READ picture NOTIFY pictureChanged)
    Q_PROPERTY(QString pictureProblem READ pictureProblem NOTIFY pictureChanged)
public:
    /// All must outlive this. Pictures are read to fit `screen`.
    BrowseDetails(BrowseAlbum& album, BrowseTrail& trail, BrowseTeller& teller, TagPlayback& tags,
                  QSize screen);

    const QString& summary() const { return summary_; }
    QString detail() const;
    const QImage& picture() const { return picture_; }
    const QString& pictureProblem() const { return picture_problem_; }

    Q_INVOKABLE void next() { step(1); }
    Q_INVOKABLE void previous() { step(-1); }
    /// Tells again what `detail` is; what plays is paused for it.
    Q_INVOKABLE void tell();
    /// One finger on the photograph: tells what `detail` is, but disturbs no recording, for a second tap may
    /// follow.
    Q_INVOKABLE void tap();

    /// The recording that `detail` is about, by its place in the playing order; none: another thing.
    std::optional<std::size_t> chosen_recording() const;

signals:
    void changed();
    void pictureChanged();

private:
    void take(bool another, bool backwards);
    void step(int by);
    void tell_seen();

    BrowseAlbum& album_;
    BrowseTrail& trail_;
    BrowseTeller& teller_;
    TagPlayback& tags_;
    PictureAhead pictures_;
    QString summary_;
    std::vector<PhotoDetail> details_;
    int detail_ = -1; ///< −1: the summary
    QImage picture_;
    QString picture_problem_;
};

} // namespace tp
