// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/settings/device_settings.hpp"
#include "app/pages/settings/setting_steps.hpp"

#include <QObject>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// What is felt of a face, how strongly and by which device, and what guides the finger where no force does.
class FeelingSettings final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(int guide READ guide NOTIFY changed) ///< index into `guides`
    Q_PROPERTY(QStringList guides READ guides NOTIFY changed)
    Q_PROPERTY(double maxForce READ maxForce NOTIFY changed) ///< N
    Q_PROPERTY(bool brows READ brows NOTIFY changed)
    Q_PROPERTY(bool nose READ nose NOTIFY changed)
    Q_PROPERTY(bool irises READ irises NOTIFY changed)
public:
    /// Both must outlive it.
    FeelingSettings(SettingSteps& steps, const DeviceSettings& devices);

    int guide() const { return static_cast<int>(steps_.now().guide); }
    QStringList guides() const;
    double maxForce() const { return steps_.now().max_force_n; }
    bool brows() const { return steps_.now().brows; }
    bool nose() const { return steps_.now().nose; }
    bool irises() const { return steps_.now().irises; }

    Q_INVOKABLE void chooseGuide(int index);
    Q_INVOKABLE void setMaxForce(double newtons);
    /// Index into the devices' names.
    Q_INVOKABLE void chooseDevice(int index);
    Q_INVOKABLE void setBrows(bool on);
    Q_INVOKABLE void setNose(bool on);
    Q_INVOKABLE void setIrises(bool on);

signals:
    void changed();

private:
    SettingSteps& steps_;
    const DeviceSettings& devices_;
};

} // namespace tp
