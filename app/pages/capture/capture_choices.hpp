// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/capture/capture_teller.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "core/aiming/aim.hpp"
#include "core/touch/tick_law.hpp"

#include <QObject>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// How the person wants photographs to be taken. Each choice is told.
class CaptureChoices final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")

    Q_PROPERTY(QStringList aims READ aims NOTIFY changed)
    Q_PROPERTY(int aim READ aim_index NOTIFY changed)
    /// The photograph is taken by itself when all is well.
    Q_PROPERTY(bool byItself READ by_itself NOTIFY changed)
    /// The sound round it is kept with it.
    Q_PROPERTY(bool moment READ moment NOTIFY changed)
public:
    /// Both must outlive it.
    CaptureChoices(Preferences& preferences, CaptureTeller& teller);

    QStringList aims() const;
    int aim_index() const { return static_cast<int>(aim_); }
    Aim aim() const { return aim_; }
    bool by_itself() const { return preferences_.choices().shutter_by_itself; }
    bool moment() const { return preferences_.choices().keep_moment; }
    /// The tone guides beside the words.
    bool tone() const;
    /// Its beats are felt, where something there can tick.
    bool ticks() const;
    /// By key_of; the output that ticks.
    const QString& touch() const { return preferences_.choices().touch; }
    /// How it ticks.
    TickChoices tick_choices() const;

    Q_INVOKABLE void chooseAim(int index);
    Q_INVOKABLE void setByItself(bool by_itself);
    Q_INVOKABLE void setMoment(bool moment);

signals:
    void changed();

private:
    Preferences& preferences_;
    CaptureTeller& teller_;
    Aim aim_ = Aim::middle;
};

} // namespace tp
