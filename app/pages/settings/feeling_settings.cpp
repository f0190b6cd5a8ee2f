// SPDX-License-Identifier: Apache-2.0
#include "app/pages/settings/feeling_settings.hpp"

#include <QLocale>
#include <QString>

#include <algorithm>
#include <optional>

namespace tp {

FeelingSettings::FeelingSettings(SettingSteps& steps, const DeviceSettings& devices)
    : steps_(steps), devices_(devices) {
    connect(&steps, &SettingSteps::changed, this, &FeelingSettings::changed);
}

QStringList FeelingSettings::guides() const {
    return {tr("None"),
            tr("Beeps"),
            tr("Clock directions"),
            tr("Beeps and clock directions"),
            tr("Ticks under the finger"),
            tr("Ticks and beeps")};
}

void FeelingSettings::chooseGuide(int index) {
    if (index >= 0 && index < guides().size())
        steps_.make(tr("the guide"), guides()[index] + '.',
                    [index](Choices& choices) { choices.guide = static_cast<Choices::Guide>(index); });
}

void FeelingSettings::setMaxForce(double newtons) {
    steps_.make(tr("the strongest force"), tr("At most %1 newtons.").arg(QLocale().toString(newtons, 'f', 1)),
                [newtons](Choices& choices) { choices.max_force_n = std::clamp(newtons, 0.1, 1.5); });
}

void FeelingSettings::chooseDevice(int index) {
    if (const std::optional<QString> key = devices_.key_at(index))
        steps_.make(tr("the force device"), tr("Force device: %1.").arg(devices_.names()[index]),
                    [&key](Choices& choices) { choices.device = *key; });
}

void FeelingSettings::setBrows(bool on) {
    steps_.make(tr("brows"), on ? tr("Brows are felt.") : tr("Brows are not felt."),
                [on](Choices& choices) { choices.brows = on; });
}
void FeelingSettings::setNose(bool on) {
    steps_.make(tr("the nose"), on ? tr("The nose is felt.") : tr("The nose is not felt."),
                [on](Choices& choices) { choices.nose = on; });
}
void FeelingSettings::setIrises(bool on) {
    steps_.make(tr("irises"), on ? tr("Irises are felt.") : tr("Irises are not felt."),
                [on](Choices& choices) { choices.irises = on; });
}

} // namespace tp
