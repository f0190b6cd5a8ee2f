// SPDX-License-Identifier: Apache-2.0
#include "app/pages/capture/capture_choices.hpp"

#include "app/pages/capture/aim_words.hpp"

namespace tp {

CaptureChoices::CaptureChoices(Preferences& preferences, CaptureTeller& teller)
    : preferences_(preferences), teller_(teller) {
    connect(&preferences_, &Preferences::changed, this, &CaptureChoices::changed);
}

QStringList CaptureChoices::aims() const { return AimWords::aims(); }

bool CaptureChoices::tone() const {
    const Choices::Guide guide = preferences_.choices().guide;
    return guide == Choices::Guide::sonar || guide == Choices::Guide::both ||
           guide == Choices::Guide::ticks_and_sonar;
}

bool CaptureChoices::ticks() const {
    const Choices::Guide guide = preferences_.choices().guide;
    return guide == Choices::Guide::ticks || guide == Choices::Guide::ticks_and_sonar;
}

TickChoices CaptureChoices::tick_choices() const {
    return {preferences_.choices().touch_strength, preferences_.choices().touch_sharpness};
}

void CaptureChoices::chooseAim(int index) {
    if (index < 0 || index >= aims().size())
        return;
    aim_ = static_cast<Aim>(index);
    emit changed();
    teller_.answer(tr("%1.").arg(aims()[index]));
}

void CaptureChoices::setByItself(bool by_itself) {
    if (by_itself == this->by_itself())
        return;
    preferences_.change([&](Choices& choices) { choices.shutter_by_itself = by_itself; });
    teller_.answer(by_itself ? tr("The photograph is taken automatically when all is well.")
                             : tr("The photograph is taken when you press Space or touch the screen."));
}

void CaptureChoices::setMoment(bool moment) {
    if (moment == this->moment())
        return;
    preferences_.change([&](Choices& choices) { choices.keep_moment = moment; });
    teller_.answer(moment
                       ? tr("The microphone is on. The sound from five seconds before a photograph to five "
                            "seconds after it is kept with it.")
                       : tr("The microphone is off. Photographs are kept without sound."));
}

} // namespace tp
