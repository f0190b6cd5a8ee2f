// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/lab/lab_activity.hpp"
#include "app/pages/lab/lab_archive.hpp"
#include "app/pages/lab/lab_hand.hpp"
#include "app/pages/lab/lab_measurements.hpp"
#include "app/pages/lab/lab_playback.hpp"
#include "app/pages/lab/lab_replay.hpp"
#include "app/pages/lab/lab_teller.hpp"
#include "app/parts/work/latest_task.hpp"
#include "core/servo/clock.hpp"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace tp {

/// Plays a recording again, and says how well it could be computed again. Reading it goes beside the page.
class LabReplayer final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")
public:
    /// All must outlive it.
    LabReplayer(const LabArchive& archive, LabActivity& activity, LabHand& hand,
                LabMeasurements& measurements, Clock& clock, LabTeller& teller);

    /// `index`: of the archive's recordings.
    Q_INVOKABLE void replay(int index);
    /// What has come due since the last call is shown.
    void poll();
    /// Nothing is read or played any more.
    void end();

private:
    void play(LabReplay replay, const QString& name);

    const LabArchive& archive_;
    LabActivity& activity_;
    LabHand& hand_;
    LabMeasurements& measurements_;
    Clock& clock_;
    LabTeller& teller_;
    std::optional<LabPlayback> playback_;
    QString words_;      ///< what computing it again has shown
    LatestTask reading_; ///< last: it ends first
};

} // namespace tp
