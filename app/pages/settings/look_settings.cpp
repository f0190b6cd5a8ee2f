// SPDX-License-Identifier: Apache-2.0
#include "app/pages/settings/look_settings.hpp"

#include <QString>

#include <algorithm>

namespace tp {

LookSettings::LookSettings(SettingSteps& steps) : steps_(steps) {
    connect(&steps, &SettingSteps::changed, this, &LookSettings::changed);
}

QStringList LookSettings::users() const {
    return {tr("Somebody who listens and feels"), tr("Somebody who looks after the album")};
}
QStringList LookSettings::themes() const { return {tr("Dark"), tr("Light"), tr("Yellow on black")}; }

void LookSettings::chooseUser(int index) {
    if (index >= 0 && index < users().size())
        steps_.make(tr("who uses the tablet"), users()[index] + '.',
                    [index](Choices& choices) { choices.user = static_cast<Choices::User>(index); });
}

void LookSettings::chooseTheme(int index) {
    if (index >= 0 && index < themes().size())
        steps_.make(tr("the colours"), themes()[index] + '.',
                    [index](Choices& choices) { choices.theme = static_cast<Choices::Theme>(index); });
}

void LookSettings::setTextScale(double scale) {
    steps_.make(tr("the text size"), tr("Text size: %1 percent.").arg(qRound(100.0 * scale)),
                [scale](Choices& choices) { choices.text_scale = std::clamp(scale, 1.0, 2.0); });
}

void LookSettings::setMotion(bool on) {
    steps_.make(tr("animations"), on ? tr("Animations on.") : tr("Animations off."),
                [on](Choices& choices) { choices.motion = on; });
}

} // namespace tp
