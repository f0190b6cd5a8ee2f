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
///
/// What the hand has reached:
///
/// |          | a frame that is not good | a good frame | taken | begin    |
/// |----------|--------------------------|--------------|-------|----------|
/// | Sought   |                          | Reached      | Taken |          |
/// | Reached  | Sought                   |              | Taken | Sought   |
/// | Taken    | Sought                   |              |       | Again    |
/// | Again    | Sought, after a while    |              | Taken |          |
///
/// Again is for whoever comes back to the page, or to its window, and may still hold the camera before what was taken: a second
/// photograph of that would be a surprise, so it is told that Space takes one. A camera that looks to the other side begins with
/// Sought.
///
/// Whether words are said:
///
/// |        | one comes over other words | silence at a frame | hush   | listen | begin |
/// |--------|----------------------------|--------------------|--------|--------|-------|
/// | Open   | Owed                       |                    | Hushed |        |       |
/// | Owed   |                            | Open               | Hushed |        | Open  |
/// | Hushed |                            |                    |        | Owed   | Open  |
class CaptureAiming final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")

    /// What is to be done now, said or not; empty before the first frame.
    Q_PROPERTY(QString advice READ advice NOTIFY changed)
    Q_PROPERTY(bool good READ good NOTIFY changed)
public:
    enum class Aimed {
        Sought,  ///< the frame is not as it was wished
        Reached, ///< it is
        Taken,   ///< it has been since the photograph was taken: that all is well is told no more
        Again    ///< a camera began anew after that, and has not looked elsewhere yet
    };
    enum class Words {
        Open,  ///< each is said as it comes
        Owed,  ///< what is to be done is said anew as soon as nothing else is being said
        Hushed ///< neither words nor tone nor ticks
    };

    /// All must outlive it.
    CaptureAiming(CaptureChoices& choices, CaptureTeller& teller, SonifiedGuide& guide, CaptureTouch& touch);
    /// Nothing sounds or is felt behind it.
    ~CaptureAiming() override { quiet(); }

    QString advice() const;
    bool good() const { return now_ && good_since_; }
    Aimed aimed() const { return aimed_; }
    Words words() const { return words_; }

    /// A camera begins that lies so in the hand.
    void begin(HeldCamera held);
    void end();
    void see(const AimFrame& frame);
    /// False where it was so already.
    bool hush();
    void listen();
    /// The photograph was taken.
    void taken() { aimed_ = Aimed::Taken; }
    /// Says who is seen, what is cut off, and what to do.
    void tell_all();

signals:
    void changed();
    /// The frame was good for a while, and no photograph was taken of it, where the shutter acts by itself.
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
    Aimed aimed_ = Aimed::Sought;
    bool front_ = false; ///< the camera that began last looks to the person's side
    Words words_ = Words::Open;
    double now_s_ = 0.0;               ///< the last frame's
    std::optional<double> good_since_, bad_since_; ///< s
    bool whole_ = true;   ///< the next way is said in a whole sentence
    bool another_told_ = false; ///< since the camera began
    QString people_;      ///< who was told of last
};

} // namespace tp
