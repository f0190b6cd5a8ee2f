// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/lab/lab_activity.hpp"
#include "app/pages/lab/lab_servo.hpp"
#include "app/pages/lab/lab_teller.hpp"
#include "app/parts/work/latest_task.hpp"
#include "device/registry.hpp"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

namespace tp {

/// Which device is felt. What takes long, looking for devices and opening one, goes beside the page.
class LabDevices final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(int current READ current NOTIFY changed) ///< index into `names`
    Q_PROPERTY(QStringList names READ names NOTIFY changed)
    Q_PROPERTY(bool simulated READ simulated NOTIFY changed)
public:
    using Find = std::function<std::vector<ListedDevice>()>;
    using Opened = std::function<void(const Result<std::shared_ptr<DeviceChain>>&)>;

    /// `find` is called on a thread of its own. The others must outlive it.
    LabDevices(Find find, LabActivity& activity, LabTeller& teller);

    int current() const { return current_; }
    QStringList names() const;
    QString name() const { return names()[current_]; }
    bool simulated() const { return current_ == 0; }

    Q_INVOKABLE void find();
    Q_INVOKABLE void choose(int index);
    /// Opens the device in use, to be recorded into a new file where one is named. `then`: at once for the
    /// simulated one; for a real one later, on the page's thread, unless `cancel` comes first. `clock` must
    /// outlive it.
    void open(const std::filesystem::path& recording, const SurfaceSize& surface,
              const LabParameters& parameters, Clock& clock, const Opened& then);
    void cancel() { work_.cancel(); }

signals:
    void changed();

private:
    LabActivity& activity_;
    LabTeller& teller_;
    Find find_;
    std::vector<ListedDevice> found_;
    int current_ = 0;
    LatestTask work_; ///< last: it ends first
};

} // namespace tp
