// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/settings/setting_steps.hpp"
#include "app/pages/settings/tap_test.hpp"
#include "app/parts/devices/touch_connector.hpp"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

#include <functional>
#include <memory>
#include <optional>

namespace tp {

/// Outputs under a bare finger on the settings page: which there are, how they tick, one tick to feel, and how late it is felt.
///
/// |            | asked for        | open      | time passes                  | last tick answered or not |
/// |------------|------------------|-----------|------------------------------|---------------------------|
/// | nothing    | opening_to_…     |           |                              |                           |
/// | opening_…  |                  | feeling, or measuring |                  |                           |
/// | feeling    |                  |           | nothing                      |                           |
/// | measuring  |                  |           | the next tick                | nothing                   |
///
/// Escape, a page that is left, a refusal and a lost output lead from each to nothing, and nothing has no output open.
class TickSettings final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    /// What is there.
    Q_PROPERTY(QStringList names READ names NOTIFY changed)
    Q_PROPERTY(int current READ current NOTIFY changed)        ///< -1: nothing is there
    Q_PROPERTY(double strength READ strength NOTIFY changed)   ///< 0.1 … 1
    Q_PROPERTY(double sharpness READ sharpness NOTIFY changed) ///< 0 … 1
    Q_PROPERTY(double latency READ latency NOTIFY changed)     ///< s, 0 … 0.15, of the current one
    Q_PROPERTY(bool measuring READ measuring NOTIFY changed)
public:
    struct Setup {
        TouchAccess access;
        std::function<double()> now;                                          ///< s; empty: the machine's
        std::function<double(int tick)> pause_before = TapTest::pause_before; ///< s
    };
    /// Both must outlive it.
    TickSettings(SettingSteps& steps, Narrator& narrator, Setup setup);

    QStringList names() const;
    int current() const;
    double strength() const { return steps_.now().touch_strength; }
    double sharpness() const { return steps_.now().touch_sharpness; }
    double latency() const;
    bool measuring() const { return doing_ == Doing::measuring; }

    void enter();
    void leave();
    /// Index into `names`.
    Q_INVOKABLE void choose(int index);
    Q_INVOKABLE void setStrength(double share);
    Q_INVOKABLE void setSharpness(double share);
    Q_INVOKABLE void setLatency(double seconds);
    /// One tick as it is chosen.
    Q_INVOKABLE void feelIt() { open(Doing::opening_to_feel); }
    /// Ticks that the person answers with `tap`.
    Q_INVOKABLE void measure() { open(Doing::opening_to_measure); }
    Q_INVOKABLE void tap();
    /// Ends what is done; false where nothing is.
    bool stop();

signals:
    void changed();

private:
    enum class Doing { nothing, opening_to_feel, feeling, opening_to_measure, measuring };

    /// The current one; null for none.
    const ListedTouchOutput* chosen() const;
    void set_latency(const QString& key, double seconds);
    void open(Doing wish);
    void use(OpenTouch& open);
    void end(const QString& sentence = {});
    void go_on();
    void finish_measuring();

    SettingSteps& steps_;
    Narrator& narrator_;
    std::function<double()> now_;
    std::function<double(int)> pause_before_;
    Doing doing_ = Doing::nothing;
    QString measured_; ///< key_of the one that is open
    TapTest taps_;
    int ticks_ = 0; ///< sent of the test
    std::unique_ptr<TouchDrive> drive_;
    QTimer next_;              ///< until the next tick, or the end
    TouchConnector connector_; ///< last: its work ends first
};

} // namespace tp
