// SPDX-License-Identifier: Apache-2.0
#include "app/pages/settings/speech_settings.hpp"

#include <QLocale>

#include <algorithm>
#include <array>
#include <cstddef>

namespace tp {

namespace {

constexpr std::array language_codes{"", "en", "de", "ko"};

} // namespace

SpeechSettings::SpeechSettings(SettingSteps& steps) : steps_(steps) {
    connect(&steps, &SettingSteps::changed, this, &SpeechSettings::changed);
}

QStringList SpeechSettings::voices() const {
    return {tr("TouchPhoto speaks"), tr("My screen reader speaks"), tr("Nobody speaks")};
}
QStringList SpeechSettings::rates() const {
    return {tr("Very slow"), tr("Slow"), tr("Normal"), tr("Fast"), tr("Very fast")};
}
QStringList SpeechSettings::languages() const {
    return {tr("Same as the system"), "English", "Deutsch", "한국어"};
}
QStringList SpeechSettings::descriptionLengths() const { return {tr("None"), tr("Short"), tr("Full")}; }
QStringList SpeechSettings::firstThings() const { return {tr("People"), tr("Time and place")}; }

int SpeechSettings::language() const {
    const auto found = std::find(language_codes.begin(), language_codes.end(), steps_.now().language);
    return found == language_codes.end() ? 0 : static_cast<int>(found - language_codes.begin());
}

void SpeechSettings::chooseVoice(int index) {
    if (index >= 0 && index < voices().size())
        steps_.make(tr("who speaks"), voices()[index] + '.',
                    [index](Choices& choices) { choices.voice = static_cast<Choices::Voice>(index); });
}

void SpeechSettings::chooseRate(int index) {
    if (index >= 0 && index < rates().size())
        steps_.make(tr("the speed of speech"), tr("%1. This is how fast I speak.").arg(rates()[index]),
                    [index](Choices& choices) { choices.rate = static_cast<Choices::Rate>(index); });
}

void SpeechSettings::chooseLanguage(int index) {
    if (index < 0 || index >= languages().size())
        return;
    const QString code = language_codes[static_cast<std::size_t>(index)];
    steps_.make(tr("the language"), {}, [&code](Choices& choices) { choices.language = code; });
    steps_.tell(languages()[index] + '.'); // said in the new language
}

void SpeechSettings::setPlaybackSpeed(double speed) {
    steps_.make(tr("the speed of recordings"),
                tr("Recordings play at %1 times normal speed.").arg(QLocale().toString(speed, 'g', 3)),
                [speed](Choices& choices) { choices.playback_speed = std::clamp(speed, 0.5, 2.0); });
}

void SpeechSettings::setEarcons(bool on) {
    steps_.make(tr("sound effects"), on ? tr("Sound effects on.") : tr("Sound effects off."),
                [on](Choices& choices) { choices.earcons = on; });
}

void SpeechSettings::chooseDescriptions(int index) {
    if (index < 0 || index >= descriptionLengths().size())
        return;
    const std::array said{tr("Only what people wrote about a photograph is said."),
                          tr("What a photograph shows is said briefly."),
                          tr("What a photograph shows is said in full.")};
    steps_.make(tr("descriptions"), said[static_cast<std::size_t>(index)], [index](Choices& choices) {
        choices.descriptions = static_cast<Choices::Descriptions>(index);
    });
}

void SpeechSettings::chooseDescribedFirst(int index) {
    if (index >= 0 && index < firstThings().size())
        steps_.make(tr("what is said first"),
                    index == 0 ? tr("People come first.") : tr("Time and place come first."),
                    [index](Choices& choices) { choices.place_first = index == 1; });
}

} // namespace tp
