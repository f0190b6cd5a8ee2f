// SPDX-License-Identifier: Apache-2.0
#include "app/shell/shell.hpp"

#include <utility>

namespace tp {

Shell::Shell(Narrator& narrator) : narrator_(narrator) {
    connect(&narrator_, &Narrator::told, this, &Shell::told);
    connect(&narrator_, &Narrator::changed, this, &Shell::voiceChanged);
}

void Shell::add(Page page) {
    order_.push_back(page.name);
    pages_[page.name] = std::move(page);
}

QString Shell::title() const {
    const auto found = pages_.find(page_);
    return found == pages_.end() ? QString() : found->second.title();
}

void Shell::leave() {
    if (const auto left = pages_.find(std::exchange(page_, {})); left != pages_.end())
        left->second.leave();
}

void Shell::enter(const QString& page) {
    leave();
    page_ = page;
    emit pageChanged();
    pages_.at(page).enter();
}

void Shell::open(const QString& page) {
    if (pages_.count(page) == 0)
        return;
    if (page == order_.front())
        before_.clear();
    else if (!page_.isEmpty() && page != page_)
        before_.push_back(page_);
    enter(page);
}

void Shell::back() {
    if (before_.empty())
        return open(order_.front());
    const QString page = before_.back();
    before_.pop_back();
    enter(page);
}

void Shell::goHome() { open(order_.front()); }

void Shell::help(const QString& of_page) {
    narrator_.tell(
        title() + ". " + of_page + ' ' +
            tr("On every page: Escape stops whatever sounds or moves, then leads home. F1: this help. F2: "
               "repeat the last sentence. F3: voice on or off. Alt+Left: previous page."),
        Priority::touch);
}

void Shell::toggleVoice() {
    narrator_.set_voice_on(!narrator_.voice_on());
    emit voice_toggled(narrator_.voice_on());
}

void Shell::retranslated() { emit pageChanged(); }

} // namespace tp
