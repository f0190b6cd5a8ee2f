// SPDX-License-Identifier: Apache-2.0
#include "app/pages/start/start_session.hpp"

#include <QVariantMap>

#include <utility>

namespace tp {

StartSession::StartSession(Narrator& narrator, Preferences& preferences,
                           FirstQuestions::FindDevices find_devices)
    : narrator_(narrator), preferences_(preferences),
      questions_(narrator, preferences, std::move(find_devices)) {
    connect(&questions_, &FirstQuestions::changed, this, &StartSession::changed);
    connect(&questions_, &FirstQuestions::ended, this, &StartSession::enter);
}

QVariantList StartSession::destinations() const {
    const QVariantMap browse{{"page", "browse"},
                             {"title", tr("Listen to photographs")},
                             {"hint", tr("One photograph after the other, with what was recorded for it")}};
    const QVariantMap explore{{"page", "explore"},
                              {"title", tr("Feel a face")},
                              {"hint", tr("Your last photograph, under your finger")}};
    const QVariantMap care{{"page", "care"},
                           {"title", tr("Look after the album")},
                           {"hint", tr("Import photographs, name people, record")}};
    const QVariantMap settings{{"page", "settings"},
                               {"title", tr("Settings")},
                               {"hint", tr("Speech, colours, force, where photographs are")}};
    const QVariantMap lab{
        {"page", "lab"},
        {"title", tr("Lab")},
        {"hint", tr("For researchers: guidance laws, their parameters, plots, recordings")}};
    const QVariantMap capture{{"page", ""},
                              {"title", tr("Take a photograph")},
                              {"hint", tr("Not available yet: photographs of any camera can be imported")}};
    const QVariantMap study{{"page", ""}, {"title", tr("Studies")}, {"hint", tr("Not available yet")}};
    const bool caregiver = preferences_.choices().user == Choices::User::caregiver;
    QVariantList list = caregiver ? QVariantList{care, browse, explore} : QVariantList{browse, explore, care};
    list << settings << lab << capture << study;
    return list;
}

void StartSession::enter() {
    if (asking())
        return questions_.go_on();
    repeat();
}

void StartSession::leave() { narrator_.stop(); }

void StartSession::askAgain() { questions_.begin(); }

void StartSession::repeat() {
    if (asking())
        return questions_.repeat();
    const QVariantList all = destinations();
    narrator_.tell(tr("TouchPhoto, start page. 1: %1. 2: %2. More below; F1 for help.")
                       .arg(all[0].toMap()["title"].toString(), all[1].toMap()["title"].toString()),
                   Priority::touch);
}

void StartSession::go(int index) {
    const QVariantList all = destinations();
    if (asking() || index < 0 || index >= all.size())
        return;
    const QVariantMap destination = all[index].toMap();
    if (destination["page"].toString().isEmpty())
        return narrator_.tell(destination["title"].toString() + ": " + destination["hint"].toString() + ".",
                              Priority::touch);
    emit pageAsked(destination["page"].toString());
}

} // namespace tp
