// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/settings/setting_steps.hpp"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// Who speaks, how and in which language, and what else sounds.
class SpeechSettings final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    // Each of these is an index into the options of its name.
    Q_PROPERTY(int voice READ voice NOTIFY changed)
    Q_PROPERTY(QStringList voices READ voices NOTIFY changed)
    Q_PROPERTY(int rate READ rate NOTIFY changed)
    Q_PROPERTY(QStringList rates READ rates NOTIFY changed)
    Q_PROPERTY(int language READ language NOTIFY changed)
    Q_PROPERTY(QStringList languages READ languages NOTIFY changed)

    Q_PROPERTY(double playbackSpeed READ playbackSpeed NOTIFY changed)
    Q_PROPERTY(bool earcons READ earcons NOTIFY changed)

    /// How much is said of what is on a photograph, and what first; as above.
    Q_PROPERTY(int descriptions READ descriptions NOTIFY changed)
    Q_PROPERTY(QStringList descriptionLengths READ descriptionLengths NOTIFY changed)
    Q_PROPERTY(int describedFirst READ describedFirst NOTIFY changed)
    Q_PROPERTY(QStringList firstThings READ firstThings NOTIFY changed)
public:
    /// They must outlive it.
    explicit SpeechSettings(SettingSteps& steps);

    int voice() const { return static_cast<int>(steps_.now().voice); }
    QStringList voices() const;
    int rate() const { return static_cast<int>(steps_.now().rate); }
    QStringList rates() const;
    int language() const;
    QStringList languages() const;
    double playbackSpeed() const { return steps_.now().playback_speed; }
    bool earcons() const { return steps_.now().earcons; }
    int descriptions() const { return static_cast<int>(steps_.now().descriptions); }
    QStringList descriptionLengths() const;
    int describedFirst() const { return steps_.now().place_first ? 1 : 0; }
    QStringList firstThings() const;

    Q_INVOKABLE void chooseVoice(int index);
    Q_INVOKABLE void chooseRate(int index);
    Q_INVOKABLE void chooseLanguage(int index);
    Q_INVOKABLE void setPlaybackSpeed(double speed);
    Q_INVOKABLE void setEarcons(bool on);
    Q_INVOKABLE void chooseDescriptions(int index);
    Q_INVOKABLE void chooseDescribedFirst(int index);

signals:
    void changed();

private:
    SettingSteps& steps_;
};

} // namespace tp
