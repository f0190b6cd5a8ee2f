// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/lab/lab_teller.hpp"

#include <QObject>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// What goes on in the lab, one thing at a time:
///
///                     | start()   | record()          | the device is open | replay()  | stop(), the end, a
///                     failure
///     Stopped         | Opening * | OpeningToRecord * | –                  | Replaying | Stopped
///     Opening         | Opening   | OpeningToRecord * | Running            | Replaying | Stopped
///     Running         | Running   | OpeningToRecord * | –                  | Replaying | Stopped
///     OpeningToRecord | the same  | Stopped           | Recording          | Replaying | Stopped
///     Recording       | Recording | Stopped           | –                  | Replaying | Stopped
///     Replaying       | Opening * | OpeningToRecord * | –                  | Replaying | Stopped
///
/// * The simulated device is open at once: Running or Recording follows without it. What comes after
/// something else has stopped that first. A recording that is to be replayed is read before; what began
/// meanwhile goes on instead.
class LabActivity final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(State state READ state NOTIFY changed)
    Q_PROPERTY(bool stopped READ stopped NOTIFY changed)
    /// The servo serves a device, be it recorded or not.
    Q_PROPERTY(bool running READ running NOTIFY changed)
    Q_PROPERTY(bool recording READ recording NOTIFY changed)
    /// Nothing may be changed: what a recording was begun with stays, so that it can be computed again.
    Q_PROPERTY(bool fixed READ fixed NOTIFY changed)
public:
    enum State {
        Stopped,
        Opening, ///< a real device is being opened
        Running,
        OpeningToRecord,
        Recording,
        Replaying,
    };
    Q_ENUM(State)

    /// It must outlive the activity.
    explicit LabActivity(LabTeller& teller) : teller_(teller) {}

    State state() const { return state_; }
    bool stopped() const { return state_ == Stopped; }
    bool opening() const { return state_ == Opening || state_ == OpeningToRecord; }
    bool running() const { return state_ == Running || state_ == Recording; }
    bool recording() const { return state_ == OpeningToRecord || state_ == Recording; }
    bool fixed() const { return recording() || state_ == Replaying; }

    void become(State state);
    /// Stops what goes on, before this returns.
    void stop() { emit stopAsked(); }
    /// True, and told, where nothing may be changed.
    bool refuses_change();

signals:
    void changed();
    void stopAsked();

private:
    LabTeller& teller_;
    State state_ = Stopped;
};

} // namespace tp
