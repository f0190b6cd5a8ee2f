// SPDX-License-Identifier: Apache-2.0
#include "app/pages/settings/settings_session.hpp"

#include <QLocale>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <system_error>
#include <utility>

namespace tp {

namespace {

constexpr std::array language_codes{"", "en", "de", "ko"};
constexpr std::size_t most_steps = 100;

QString native(const std::filesystem::path& path) { return QString::fromStdU16String(path.u16string()); }

/// Bytes of all files in a folder, those below it too.
std::uintmax_t bytes_in(const std::filesystem::path& folder) {
    std::uintmax_t bytes = 0;
    std::error_code error;
    for (std::filesystem::recursive_directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        std::error_code of_file;
        if (at->is_regular_file(of_file))
            bytes += at->file_size(of_file);
    }
    return bytes;
}

} // namespace

SettingsSession::SettingsSession(Narrator& narrator, Preferences& preferences, Stored stored,
                                 DeviceSettings::Setup devices)
    : narrator_(narrator), preferences_(preferences), stored_(std::move(stored)), chooser_(narrator),
      devices_(narrator, preferences, std::move(devices)) {
    connect(&preferences_, &Preferences::changed, this, &SettingsSession::changed);
    connect(&chooser_, &FolderChooser::cancelled, this, [this] {
        set_choosing(false);
        narrator_.tell(tr("No folder was chosen."), Priority::touch);
    });
    connect(&chooser_, &FolderChooser::chosen, this, [this](const QString& folder) {
        set_choosing(false);
        if (now().folders.contains(folder))
            return narrator_.tell(tr("The album has this folder already."), Priority::touch);
        make(tr("the album's new folder"), tr("%1 belongs to the album now.").arg(folder),
             [&](Choices& choices) { choices.folders << folder; });
    });
}

template <typename Change>
void SettingsSession::make(const QString& what, const QString& said, Change change) {
    Choices changed_choices = now();
    change(changed_choices);
    if (changed_choices == now())
        return;
    // A slider that is moved on is one step, not many.
    if (history_.empty() || history_.back().what != what)
        history_.push_back({what, now()});
    if (history_.size() > most_steps)
        history_.erase(history_.begin());
    preferences_.set(changed_choices);
    narrator_.tell(said, Priority::touch);
}

void SettingsSession::enter() {
    narrator_.tell(tr("Settings. Go through them by Tab; each change is kept at once. Control Z takes the last one back."),
                   Priority::touch);
    emit storedChanged();
    devices_.enter();
}

void SettingsSession::leave() {
    devices_.leave();
    narrator_.stop();
    set_choosing(false);
}

// --- speech ---

QStringList SettingsSession::voices() const {
    return {tr("TouchPhoto speaks"), tr("My screen reader speaks"), tr("Nobody speaks")};
}
QStringList SettingsSession::rates() const {
    return {tr("Very slow"), tr("Slow"), tr("Normal"), tr("Fast"), tr("Very fast")};
}
QStringList SettingsSession::languages() const {
    return {tr("As the system"), "English", "Deutsch", "한국어"};
}
int SettingsSession::language() const {
    const auto found = std::find(language_codes.begin(), language_codes.end(), now().language);
    return found == language_codes.end() ? 0 : static_cast<int>(found - language_codes.begin());
}

void SettingsSession::chooseVoice(int index) {
    if (index >= 0 && index < voices().size())
        make(tr("who speaks"), voices()[index] + '.',
             [&](Choices& choices) { choices.voice = static_cast<Choices::Voice>(index); });
}

void SettingsSession::chooseRate(int index) {
    if (index >= 0 && index < rates().size())
        make(tr("the speed of speech"), tr("%1. This is how fast I speak.").arg(rates()[index]),
             [&](Choices& choices) { choices.rate = static_cast<Choices::Rate>(index); });
}

void SettingsSession::chooseLanguage(int index) {
    if (index < 0 || index >= languages().size())
        return;
    const QString code = language_codes[static_cast<std::size_t>(index)];
    make(tr("the language"), {}, [&](Choices& choices) { choices.language = code; });
    narrator_.tell(languages()[index] + '.', Priority::touch); // said in the new language
}

void SettingsSession::setPlaybackSpeed(double speed) {
    make(tr("the speed of recordings"), tr("Recordings play at %1 times their speed.").arg(QLocale().toString(speed, 'g', 3)),
         [&](Choices& choices) { choices.playback_speed = std::clamp(speed, 0.5, 2.0); });
}

void SettingsSession::setEarcons(bool on) {
    make(tr("sounds"), on ? tr("Sounds on.") : tr("Sounds off."), [&](Choices& choices) { choices.earcons = on; });
}

// --- who, and what it looks like ---

QStringList SettingsSession::users() const {
    return {tr("Somebody who listens and feels"), tr("Somebody who looks after the album")};
}
QStringList SettingsSession::themes() const { return {tr("Dark"), tr("Light"), tr("Yellow on black")}; }

void SettingsSession::chooseUser(int index) {
    if (index >= 0 && index < users().size())
        make(tr("who uses the tablet"), users()[index] + '.',
             [&](Choices& choices) { choices.user = static_cast<Choices::User>(index); });
}

void SettingsSession::chooseTheme(int index) {
    if (index >= 0 && index < themes().size())
        make(tr("the colours"), themes()[index] + '.',
             [&](Choices& choices) { choices.theme = static_cast<Choices::Theme>(index); });
}

void SettingsSession::setTextScale(double scale) {
    make(tr("the size of text"), tr("Text at %1 percent.").arg(qRound(100.0 * scale)),
         [&](Choices& choices) { choices.text_scale = std::clamp(scale, 1.0, 2.0); });
}

void SettingsSession::setMotion(bool on) {
    make(tr("motion"), on ? tr("Pictures may move.") : tr("Nothing moves by itself."),
         [&](Choices& choices) { choices.motion = on; });
}

// --- feeling ---

QStringList SettingsSession::guides() const {
    return {tr("Nothing"), tr("Beeps"), tr("Spoken clock directions"), tr("Both")};
}

void SettingsSession::chooseGuide(int index) {
    if (index >= 0 && index < guides().size())
        make(tr("what guides the finger"), guides()[index] + '.',
             [&](Choices& choices) { choices.guide = static_cast<Choices::Guide>(index); });
}

void SettingsSession::setMaxForce(double newtons) {
    make(tr("the strongest force"), tr("At most %1 newtons.").arg(QLocale().toString(newtons, 'f', 1)),
         [&](Choices& choices) { choices.max_force_n = std::clamp(newtons, 0.1, 1.5); });
}

void SettingsSession::chooseDevice(int index) {
    if (const std::optional<QString> key = devices_.key_at(index))
        make(tr("the force device"), tr("Force device: %1.").arg(devices_.names()[index]),
             [&](Choices& choices) { choices.device = *key; });
}

void SettingsSession::setBrows(bool on) {
    make(tr("brows"), on ? tr("Brows are felt.") : tr("Brows are not felt."), [&](Choices& choices) { choices.brows = on; });
}
void SettingsSession::setNose(bool on) {
    make(tr("the nose"), on ? tr("The nose is felt.") : tr("The nose is not felt."),
         [&](Choices& choices) { choices.nose = on; });
}
void SettingsSession::setIrises(bool on) {
    make(tr("irises"), on ? tr("Irises are felt.") : tr("Irises are not felt."),
         [&](Choices& choices) { choices.irises = on; });
}

// --- the album ---

void SettingsSession::set_choosing(bool choosing) {
    if (choosing_ == choosing)
        return;
    choosing_ = choosing;
    emit choosingChanged();
}

void SettingsSession::addFolder() {
    set_choosing(true);
    chooser_.begin();
}

bool SettingsSession::back() {
    if (devices_.stop())
        return true;
    if (!choosing_)
        return false;
    chooser_.cancel();
    return true;
}

void SettingsSession::removeFolder(int index) {
    if (index < 0 || index >= folders().size())
        return;
    const QString folder = folders()[index];
    make(tr("the folder that left the album"),
         tr("%1 no longer belongs to the album. Its photographs and recordings stay where they are.").arg(folder),
         [&](Choices& choices) { choices.folders.removeAt(index); });
}

// --- all of it ---

void SettingsSession::reset() {
    make(tr("the reset"), tr("All settings are as they were at first. The album's folders stay."), [&](Choices& choices) {
        Choices fresh;
        fresh.asked = true;
        fresh.folders = choices.folders;
        fresh.last_photo = choices.last_photo;
        fresh.language = choices.language; // a person must go on understanding the page
        choices = fresh;
    });
}

void SettingsSession::undo() {
    if (history_.empty())
        return narrator_.tell(tr("There is nothing to take back."), Priority::touch);
    const Step step = history_.back();
    history_.pop_back();
    Choices before = step.before;
    before.last_photo = now().last_photo; // where one is, is no setting
    preferences_.set(before);
    emit changed();
    narrator_.tell(tr("Taken back: %1.").arg(step.what), Priority::touch);
}

QStringList SettingsSession::stored() const {
    QStringList list{tr("Nothing leaves this computer: TouchPhoto opens no connection to any other.")};
    list << tr("These settings, in %1.").arg(native(stored_.preferences));
    list << tr("An index of the album, in %1 (%2). It can be thrown away at any time.")
                .arg(native(stored_.cache), QLocale().formattedDataSize(static_cast<qint64>(bytes_in(stored_.cache))));
    if (std::error_code error; std::filesystem::exists(devices_.calibrations(), error))
        list << tr("Where your force device lies on the screen, in %1.").arg(native(devices_.calibrations()));
    for (const QString& folder : folders())
        list << tr("Names, descriptions and recordings, beside the photographs in %1.").arg(folder);
    if (!now().last_photo.isEmpty())
        list << tr("The photograph that you were at last: %1.").arg(now().last_photo);
    return list;
}

void SettingsSession::discardIndex() {
    stored_.discard_index();
    narrator_.tell(tr("The index is thrown away when TouchPhoto ends, and made anew from the photographs at the next start."),
                   Priority::message);
}

} // namespace tp
