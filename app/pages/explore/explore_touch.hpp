// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/explore/explore_choices.hpp"
#include "app/pages/explore/explore_device.hpp"
#include "app/pages/explore/explore_ear.hpp"
#include "app/pages/explore/explore_settings.hpp"
#include "app/pages/explore/explore_tour.hpp"
#include "app/pages/explore/explore_view.hpp"
#include "app/pages/explore/explore_words.hpp"
#include "app/parts/devices/touch_connector.hpp"
#include "app/parts/finger/finger_servo.hpp"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

#include <memory>
#include <string>

namespace tp {

/// The output under a bare finger, found, opened and given back while the page is in sight, the person has chosen ticks, and no
/// force device is in use: a hand that is pulled is not ticked at as well.
///
/// |          | enter, engage, ticks are chosen | none is there | refused | opened | lost    | leave, other guide, force device |
/// |----------|---------------------------------|---------------|---------|--------|---------|----------------------------------|
/// | Away     | Expected                        |               |         |        |         |                                  |
/// | Expected |                                 | Awaited       | Awaited | InUse  |         | Away                             |
/// | Awaited  | Expected                        |               |         | InUse  |         | Away                             |
/// | InUse    |                                 |               |         |        | Awaited | Away                             |
class ExploreTouch final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")

    /// The output that is felt; empty where there is none.
    Q_PROPERTY(QString name READ name NOTIFY changed)
public:
    enum class State {
        Away,     ///< none is wanted
        Expected, ///< the person has just come or asked
        Awaited,  ///< there is none, or it was refused or lost
        InUse     ///< it is felt
    };

    /// All must outlive this.
    ExploreTouch(FingerServo& servo, ExploreView& view, ExploreTour& tour, ExploreEar& ear,
                 ExploreChoices& choices, ExploreWords& words, ExploreDevice& device,
                 const ExploreSettings& settings);

    State state() const { return state_; }
    QString name() const { return state_ == State::InUse ? about_ : QString(); }

    /// The page comes into sight; it goes out of sight.
    void enter();
    void leave();
    /// Time has passed: whether it is still there.
    void watch();

signals:
    void changed();

private:
    void follow_wish();
    void want();
    void give_back();
    void look();
    void use(OpenTouch& open);
    void refuse(const QString& sentence);
    void lose();
    void tell_gone();
    void follow_choices();

    FingerServo& servo_;
    ExploreView& view_;
    ExploreTour& tour_;
    ExploreEar& ear_;
    ExploreChoices& choices_;
    ExploreWords& words_;
    ExploreDevice& device_;
    Vec2 surface_; ///< mm
    State state_ = State::Away;
    bool here_ = false;
    QString about_;            ///< of the one in use
    ListedTouchOutput used_;   ///< the one in use, or the last one
    QString key_;              ///< of the one in use: what was chosen
    QString gone_;             ///< the one that was lost, until that is told
    std::string refused_;      ///< name of the one that could not be opened; it is not asked again by itself
    TouchConnector connector_; ///< last: its work ends first
};

} // namespace tp
