// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/capture/capture_choices.hpp"
#include "app/pages/capture/capture_teller.hpp"
#include "app/parts/devices/touch_connector.hpp"
#include "core/servo/clock.hpp"
#include "core/touch/touch_output.hpp"

#include <QObject>
#include <QString>

#include <memory>
#include <string>

namespace tp {

/// What is felt while one aims: pulses as ticks of the output that the person chose, or of the first one under a finger. It is
/// found, opened and given back while the page is in sight and the person has chosen ticks. The drawn finger is none: here is no
/// surface that it could lie on.
///
/// |          | enter, ticks are chosen | none is there | refused | opened | lost    | leave, other guide |
/// |----------|-------------------------|---------------|---------|--------|---------|--------------------|
/// | Away     | Expected                |               |         |        |         |                    |
/// | Expected |                         | Awaited       | Awaited | InUse  |         | Away               |
/// | Awaited  |                         |               |         | InUse  |         | Away               |
/// | InUse    |                         |               |         |        | Awaited | Away               |
class CaptureTouch final : public QObject {
    Q_OBJECT
public:
    enum class State {
        Away,     ///< none is wanted
        Expected, ///< the person has just come or chosen
        Awaited,  ///< there is none, or it was refused or lost
        InUse     ///< it is felt
    };

    /// Choices and teller must outlive it.
    CaptureTouch(CaptureChoices& choices, CaptureTeller& teller, TouchAccess access);
    /// Nothing is felt behind it.
    ~CaptureTouch() override;

    State state() const { return state_; }
    bool in_use() const { return state_ == State::InUse; }

    /// The page comes into sight; it goes out of sight, and nothing is felt any more.
    void enter();
    void leave();
    /// Time has passed: whether it is still there.
    void watch();
    /// One pulse of this strength, 0 … 1, in place of one that is under way; it ends by itself. Nothing where none is in use.
    void pulse(double strength);
    /// Nothing is felt, now.
    void still();

private:
    void follow_wish();
    void want();
    void give_back();
    void look();
    void use(OpenTouch& open);
    void refuse(const QString& sentence);
    void lose();

    CaptureChoices& choices_;
    CaptureTeller& teller_;
    SteadyClock clock_;
    State state_ = State::Away;
    bool here_ = false;
    bool pulsed_ = false;    ///< since it was still
    bool was_lost_ = false;  ///< that it is there again is told
    bool none_told_ = false; ///< that there is none, once
    QString about_;          ///< of the one in use
    QString key_;            ///< what was chosen when it was asked for
    std::string asked_;      ///< name of the one that is being opened
    std::string refused_;    ///< name of the one that could not be opened; it is not asked again by itself
    std::unique_ptr<TouchOutput> output_;
    TouchConnector connector_; ///< last: its work ends first
};

} // namespace tp
