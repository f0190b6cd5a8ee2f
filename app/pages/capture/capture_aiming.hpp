// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/capture/aim_pulses.hpp"
#include "app/pages/capture/capture_choices.hpp"
#include "app/pages/capture/capture_teller.hpp"
#include "app/pages/capture/capture_touch.hpp"
#include "audio/guide/sonified_guide.hpp"
#include "core/aiming/aiming.hpp"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace tp {

/// Leads the hand: of each frame one instruction, said where nothing else is being said, and a tone, which is also felt, or
/// felt instead, where the person has chosen ticks.
class CaptureAiming final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")

    /// What is to be done now, said or not; empty before the first frame.
    Q_PROPERTY(QString advice READ advice NOTIFY changed)
    Q_PROPERTY(bool good READ good NOTIFY changed)
public:
    /// All must outlive it.
    CaptureAiming(CaptureChoices& choices, CaptureTeller& teller, SonifiedGuide& guide, CaptureTouch& touch);
    /// Nothing sounds or is felt behind it.
    ~CaptureAiming() override { quiet(); }

    QString advice() const;
    bool good() const { return now_ && good_; }

    /// A camera begins that lies so in the hand.
    void begin(HeldCamera held);
    void end();
    void see(const AimFrame& frame);
    /// Neither words nor tone nor ticks until `listen`. False where it was so already.
    bool hush();
    void listen();
    /// The photograph was taken: that all is well is told no more until it was not.
    void taken() { taken_ = true; }
    /// Says who is seen, what is cut off, and what to do.
    void tell_all();

signals:
    void changed();
    /// The frame was good for a while.
    void take_asked();

private:
    void say(const AimInstruction& instruction);
    void hear(const AimTone& tone);
    void feel(const AimTone& tone);
    bool tone() const;
    void quiet();

    CaptureChoices& choices_;
    CaptureTeller& teller_;
    SonifiedGuide& guide_;
    CaptureTouch& touch_;
    Aiming aiming_;
    AimPulses pulses_;
    Aim aim_;
    std::optional<AimInstruction> now_;
    bool good_ = false;
    double now_s_ = 0.0;               ///< the last frame's
    std::optional<double> good_since_; ///< s
    bool hushed_ = false;
    bool unsaid_ = false; ///< something was to be said while something else was being said
    bool taken_ = false;  ///< and the frame is good since
    bool whole_ = true;   ///< the next way is said in a whole sentence
    QString people_;      ///< who was told of last
};

} // namespace tp
