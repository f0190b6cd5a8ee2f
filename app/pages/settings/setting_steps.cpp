// SPDX-License-Identifier: Apache-2.0
#include "app/pages/settings/setting_steps.hpp"

#include <cstddef>

namespace tp {

namespace {

constexpr std::size_t most_steps = 100;

} // namespace

SettingSteps::SettingSteps(Narrator& narrator, Preferences& preferences)
    : narrator_(narrator), preferences_(preferences) {
    connect(&preferences, &Preferences::changed, this, &SettingSteps::changed);
}

void SettingSteps::make(const QString& what, const QString& said,
                        const std::function<void(Choices&)>& change) {
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
    tell(said);
}

void SettingSteps::reset() {
    make(tr("the reset"), tr("All settings are reset. The album's folders stay."), [](Choices& choices) {
        Choices fresh;
        fresh.asked = true;
        fresh.folders = choices.folders;
        fresh.last_photo = choices.last_photo;
        fresh.language = choices.language; // a person must go on understanding the page
        choices = fresh;
    });
}

void SettingSteps::undo() {
    if (history_.empty())
        return tell(tr("There is nothing to undo."));
    const Step step = history_.back();
    history_.pop_back();
    Choices before = step.before;
    before.last_photo = now().last_photo; // where one is, is no setting
    preferences_.set(before);
    emit changed();
    tell(tr("Undone: %1.").arg(step.what));
}

} // namespace tp
