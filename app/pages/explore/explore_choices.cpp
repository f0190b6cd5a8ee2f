// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/explore_choices.hpp"

#include "app/parts/devices/touch_access.hpp"

#include <algorithm>

namespace tp {

ExploreChoices::ExploreChoices(Preferences& preferences, FingerServo& servo, ExploreWords& words,
                               const ExploreSettings& settings)
    : preferences_(preferences), servo_(servo), words_(words), more_(settings.extras),
      strongest_(settings.servo.limits.max_force) {
    servo_.set_max_force(maxForce());
    connect(&preferences_, &Preferences::changed, this, [this] {
        servo_.set_max_force(maxForce());
        emit changed();
    });
}

double ExploreChoices::maxForce() const {
    return std::clamp(preferences_.choices().max_force_n, 0.0, strongest_);
}

void ExploreChoices::setMaxForce(double newtons) {
    preferences_.change([&](Choices& choices) { choices.max_force_n = std::clamp(newtons, 0.1, 1.5); });
}

QStringList ExploreChoices::guideNames() const {
    return {tr("None"),
            tr("Beeps"),
            tr("Clock directions"),
            tr("Beeps and clock directions"),
            tr("Ticks under the finger"),
            tr("Ticks and beeps")};
}

void ExploreChoices::setGuide(int guide) {
    if (guide >= 0 && guide < guideNames().size())
        preferences_.change([&](Choices& choices) { choices.guide = static_cast<Choices::Guide>(guide); });
}

void ExploreChoices::nextGuide() {
    setGuide((guide() + 1) % static_cast<int>(guideNames().size()));
    words_.tell(tr("Guide: %1.").arg(guideNames()[guide()]), Priority::touch);
}

bool ExploreChoices::beeps() const {
    const Choices::Guide kind = preferences_.choices().guide;
    return kind == Choices::Guide::sonar || kind == Choices::Guide::both ||
           kind == Choices::Guide::ticks_and_sonar || (ticks() && !servo_.by_touch());
}

bool ExploreChoices::ticks() const {
    const Choices::Guide kind = preferences_.choices().guide;
    return kind == Choices::Guide::ticks || kind == Choices::Guide::ticks_and_sonar;
}

TouchSettings ExploreChoices::touch_settings(const ListedTouchOutput& output) const {
    const Choices& choices = preferences_.choices();
    TouchSettings settings;
    settings.choices = {choices.touch_strength, choices.touch_sharpness};
    settings.latency_s = touch_latency_s(choices, key_of(output), output.delay);
    return settings;
}

bool ExploreChoices::speaks() const {
    const Choices::Guide kind = preferences_.choices().guide;
    return kind == Choices::Guide::clock_voice || kind == Choices::Guide::both;
}

ExtraFeatures ExploreChoices::extras() const {
    const Choices& choices = preferences_.choices();
    return {choices.brows || more_.brows, choices.nose || more_.nose, choices.irises || more_.irises};
}

} // namespace tp
