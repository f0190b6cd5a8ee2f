// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/care/care_teller.hpp"
#include "app/pages/care/cared_photo.hpp"
#include "app/pages/care/listening.hpp"
#include "app/pages/care/recording_list.hpp"
#include "app/pages/care/sound_peaks.hpp"
#include "app/parts/work/latest_task.hpp"

#include <QList>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// The chosen recording as a drawing of its loudness, and the part of it that is to stay.
class Trimming final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(QList<float> peaks READ peaks NOTIFY drawn) ///< 0–1; empty until they are known
    Q_PROPERTY(double duration READ duration NOTIFY changed) ///< s
    Q_PROPERTY(double begin READ begin NOTIFY changed)       ///< s
    Q_PROPERTY(double end READ end NOTIFY changed)           ///< s
    Q_PROPERTY(QString beginText READ beginText NOTIFY changed)
    Q_PROPERTY(QString endText READ endText NOTIFY changed)
    Q_PROPERTY(QString staysText READ staysText NOTIFY changed)
    Q_PROPERTY(bool cuts READ cuts NOTIFY changed) ///< something would be cut off
    Q_PROPERTY(bool playing READ playing NOTIFY playingChanged)     ///< the chosen recording, or a part of it
    Q_PROPERTY(double position READ position NOTIFY positionChanged) ///< s, of what plays
public:
    /// Shortest part that may stay, s.
    static constexpr double shortest_s = 0.1;

    /// All must outlive it.
    Trimming(CaredPhoto& photo, RecordingList& list, Listening& listening, CareTeller& teller);

    QList<float> peaks() const { return peaks_; }
    double duration() const { return duration_s_; }
    double begin() const { return begin_s_; }
    double end() const { return end_s_; }
    QString beginText() const;
    QString endText() const;
    QString staysText() const;
    bool cuts() const { return begin_s_ > 0.0 || end_s_ < duration_s_; }
    bool playing() const { return listening_.playing(); }
    double position() const { return listening_.position(); }

    /// To a place in seconds, as far as the other end lets it; said where it is now.
    Q_INVOKABLE void setBegin(double seconds);
    Q_INVOKABLE void setEnd(double seconds);
    /// Everything stays.
    Q_INVOKABLE void whole();
    /// Plays the chosen recording, or stops it.
    Q_INVOKABLE void playOrStop();
    /// Plays what stays, or stops it.
    Q_INVOKABLE void playPartOrStop();
    /// Keeps the part; the whole recording goes to the trash.
    Q_INVOKABLE void cut();

signals:
    void changed();
    void drawn();
    void playingChanged();
    void positionChanged();

private:
    void begin_anew();
    void draw(const std::filesystem::path& file);
    std::filesystem::path file() const;

    CaredPhoto& photo_;
    RecordingList& list_;
    Listening& listening_;
    CareTeller& teller_;
    QList<float> peaks_;
    double duration_s_ = 0.0, begin_s_ = 0.0, end_s_ = 0.0;
    LatestTask drawing_; ///< last: it ends before what its work is for
};

} // namespace tp
