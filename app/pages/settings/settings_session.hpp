// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/settings/device_settings.hpp"
#include "app/pages/settings/feeling_settings.hpp"
#include "app/pages/settings/look_settings.hpp"
#include "app/pages/settings/setting_steps.hpp"
#include "app/pages/settings/speech_settings.hpp"
#include "app/pages/settings/storage_settings.hpp"
#include "app/pages/settings/tick_settings.hpp"
#include "app/parts/narration/narrator.hpp"
#include "app/parts/preferences/preferences.hpp"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// The settings page: what a person has chosen, part by part.
class SettingsSession final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(tp::SettingSteps* steps READ steps CONSTANT)
    Q_PROPERTY(tp::SpeechSettings* speech READ speech CONSTANT)
    Q_PROPERTY(tp::LookSettings* looks READ looks CONSTANT)
    Q_PROPERTY(tp::DeviceSettings* devices READ devices CONSTANT)
    Q_PROPERTY(tp::TickSettings* ticks READ ticks CONSTANT)
    Q_PROPERTY(tp::FeelingSettings* feeling READ feeling CONSTANT)
    Q_PROPERTY(tp::StorageSettings* storage READ storage CONSTANT)
public:
    /// Narrator and preferences must outlive the session.
    SettingsSession(Narrator& narrator, Preferences& preferences, StorageSettings::Stored stored,
                    DeviceSettings::Setup devices = {}, TickSettings::Setup ticks = {});

    SettingSteps* steps() { return &steps_; }
    SpeechSettings* speech() { return &speech_; }
    LookSettings* looks() { return &looks_; }
    DeviceSettings* devices() { return &devices_; }
    TickSettings* ticks() { return &ticks_; }
    FeelingSettings* feeling() { return &feeling_; }
    StorageSettings* storage() { return &storage_; }

    Q_INVOKABLE void enter();
    Q_INVOKABLE void leave();
    /// Ends what is done with a device, or choosing a folder; false where there is nothing to end.
    Q_INVOKABLE bool back();

signals:
    void pageAsked(const QString& page);
    /// The five questions of the first start are wanted once more.
    void questionsAsked();

private:
    Narrator& narrator_;
    SettingSteps steps_;
    SpeechSettings speech_;
    LookSettings looks_;
    DeviceSettings devices_;
    TickSettings ticks_;
    FeelingSettings feeling_;
    StorageSettings storage_;
};

} // namespace tp
