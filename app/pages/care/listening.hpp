// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/photo_record.hpp"
#include "app/pages/care/care_teller.hpp"
#include "audio/sound/player.hpp"

#include <QtQml/qqmlregistration.h>

#include <filesystem>
#include <limits>

namespace tp {

/// A recording that is listened to, or a part of it. One at a time, on the program's player.
class Listening final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(bool playing READ playing NOTIFY changed)
    Q_PROPERTY(double position READ position NOTIFY moved) ///< s, in the recording; 0 while nothing plays
public:
    /// Both must outlive it.
    Listening(Player& player, CareTeller& teller);

    bool playing() const { return playing_; }
    double position() const { return playing_ ? player_.position_s() : 0.0; }

    /// From one place to another, both in seconds.
    void play(const std::filesystem::path& file, const Tag& tag, double from_s = 0.0,
              double to_s = std::numeric_limits<double>::infinity());
    Q_INVOKABLE void stop();

signals:
    void changed();
    void moved();

private:
    void end();

    Player& player_;
    CareTeller& teller_;
    bool playing_ = false; ///< the player plays for this page
    double to_s_ = 0.0;
};

} // namespace tp
