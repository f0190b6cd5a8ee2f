// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/lab/lab_activity.hpp"
#include "app/pages/lab/lab_archive.hpp"
#include "app/pages/lab/lab_devices.hpp"
#include "app/pages/lab/lab_hand.hpp"
#include "app/pages/lab/lab_measurements.hpp"
#include "app/pages/lab/lab_replayer.hpp"
#include "app/pages/lab/lab_run.hpp"
#include "app/pages/lab/lab_scene.hpp"
#include "app/pages/lab/lab_teller.hpp"
#include "app/pages/lab/lab_tuning.hpp"
#include "app/parts/narration/narrator.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "device/registry.hpp"

#include <QObject>
#include <QString>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

#include <filesystem>

namespace tp {

struct LabSettings {
    SurfaceSize surface{220.0, 160.0, 8.0, {}};
    std::filesystem::path folder;                 ///< of recordings and tables; made when it is needed
    LabDevices::Find find_devices = list_devices; ///< called on a thread of its own
    VirtualClock* time = nullptr;                 ///< for tests: nothing happens but by advance()
};

/// The lab: a scene under a device, the law and its parameters, what the servo does, and its files. Each part
/// does one thing; what goes on is polled and stopped here.
class LabSession final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(tp::LabActivity* activity READ activity CONSTANT)
    Q_PROPERTY(tp::LabTuning* tuning READ tuning CONSTANT)
    Q_PROPERTY(tp::LabScene* scene READ scene CONSTANT)
    Q_PROPERTY(tp::LabDevices* devices READ devices CONSTANT)
    Q_PROPERTY(tp::LabHand* hand READ hand CONSTANT)
    Q_PROPERTY(tp::LabMeasurements* plots READ plots CONSTANT)
    Q_PROPERTY(tp::LabRun* servo READ servo CONSTANT)
    Q_PROPERTY(tp::LabArchive* files READ files CONSTANT)
    Q_PROPERTY(tp::LabReplayer* playback READ playback CONSTANT)
    /// What goes on, in a sentence.
    Q_PROPERTY(QString status READ status NOTIFY statusChanged)
public:
    /// Both must outlive the session.
    LabSession(Narrator& narrator, Preferences& preferences, const LabSettings& settings);

    LabActivity* activity() { return &activity_; }
    LabTuning* tuning() { return &tuning_; }
    LabScene* scene() { return &scene_; }
    LabDevices* devices() { return &devices_; }
    LabHand* hand() { return &hand_; }
    LabMeasurements* plots() { return &plots_; }
    LabRun* servo() { return &run_; }
    LabArchive* files() { return &archive_; }
    LabReplayer* playback() { return &replayer_; }
    QString status() const { return teller_.status(); }

    Q_INVOKABLE void enter();
    Q_INVOKABLE void leave();
    /// Escape: stops what runs; false where nothing does.
    Q_INVOKABLE bool stop();
    /// So much virtual time passes.
    void advance(double seconds);

signals:
    void statusChanged();
    /// Another page is wanted; emitted by the page.
    void pageAsked(const QString& page);

private:
    void poll();

    bool virtual_time_;
    SteadyClock steady_;
    Clock& clock_;
    LabTeller teller_;
    LabActivity activity_;
    LabTuning tuning_;
    LabScene scene_;
    LabDevices devices_;
    LabHand hand_;
    LabMeasurements plots_;
    LabRun run_;
    LabArchive archive_;
    LabReplayer replayer_;
    QTimer timer_;
};

} // namespace tp
