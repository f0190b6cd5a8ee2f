// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/lab/lab_activity.hpp"
#include "app/pages/lab/lab_devices.hpp"
#include "app/pages/lab/lab_hand.hpp"
#include "app/pages/lab/lab_measurements.hpp"
#include "app/pages/lab/lab_scene.hpp"
#include "app/pages/lab/lab_servo.hpp"
#include "app/pages/lab/lab_teller.hpp"
#include "app/pages/lab/lab_tuning.hpp"
#include "app/parts/preferences/preferences.hpp"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

#include <filesystem>
#include <memory>
#include <string>

namespace tp {

/// The servo on the device in use, from its start to its end.
class LabRun final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")
public:
    /// What it works with; all must outlive it.
    struct Around {
        LabActivity& activity;
        LabTuning& tuning;
        LabScene& scene;
        LabDevices& devices;
        LabHand& hand;
        LabMeasurements& measurements;
        LabTeller& teller;
        const Preferences& preferences; ///< the person's own strongest force holds for every real device
        Clock& clock;
        bool virtual_time; ///< nothing happens but by run_for()
    };
    explicit LabRun(const Around& around);

    Q_INVOKABLE void start();
    /// The simulated device's next write takes 200 ms.
    Q_INVOKABLE void hang();

    /// As start(), into a new file. Nothing must go on.
    void record(const std::filesystem::path& file) { open(file); }
    /// The loop ends; false where the last recording is not whole.
    bool end();
    /// Takes what was measured; a fault is told, and what it disables stops.
    void poll();
    /// So much virtual time passes; false where nothing runs.
    bool run_for(double seconds);
    /// What was felt and how, as JSON for a file.
    std::string setup() const;

private:
    LabParameters allowed() const;
    void open(const std::filesystem::path& recording);
    void run(const std::shared_ptr<DeviceChain>& chain, bool recorded, bool goes_on);
    void turn(bool anew);
    void flush();
    void watch(Fault fault);

    Around around_;
    std::unique_ptr<LabServo> servo_;
    bool whole_ = true; ///< every tick of the recording is on its way to the disk
    Fault fault_ = Fault::none;
    Fault told_ = Fault::none;
    double told_at_ = -1e9; ///< s
};

} // namespace tp
