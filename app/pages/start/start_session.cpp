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
                               {"hint", tr("Speech, colours, force, where your photographs are")}};
    const QVariantMap lab{
        {"page", "lab"},
        {"title", tr("Lab")},
        {"hint", tr("For researchers: guidance laws, their parameters, plots, recordings")}};
    const QVariantMap capture{{"page", "capture"},
                              {"title", tr("Take a photograph")},
                              {"hint", tr("The camera is led to a face by words and a tone")}};
    const QVariantMap study{{"page", "study"},
                            {"title", tr("Studies")},
                            {"hint", tr("For researchers: the published experiments, with people")}};
    const bool caregiver = preferences_.choices().user == Choices::User::caregiver;
    QVariantList list = caregiver ? QVariantList{care, browse, explore} : QVariantList{browse, explore, care};
    list << settings << lab << capture << study;
    return list;
}

QString StartSession::news() const {
    if (news_.photos == 0)
        return {};
    const QString photos = tr("%n new photograph(s)", nullptr, static_cast<int>(news_.photos));
    return news_.with_people == 0 ? tr("%1.").arg(photos)
                                  : tr("%1, %2.").arg(photos, tr("%n with people", nullptr,
                                                                 static_cast<int>(news_.with_people)));
}

void StartSession::know(const News& news, bool looking) {
    if (news.photos != news_.photos)
        told_ = news.photos == 0;
    if (news != news_) {
        news_ = news;
        emit changed();
    }
    if (told_ || !here_ || asking() || (looking && news.to_look > 0))
        return;
    told_ = true;
    narrator_.tell(this->news(), Priority::message);
}

void StartSession::enter() {
    here_ = true;
    if (asking())
        return questions_.go_on();
    repeat();
}

void StartSession::leave() {
    here_ = false;
    narrator_.stop();
}

void StartSession::askAgain() { questions_.begin(); }

void StartSession::repeat() {
    if (asking())
        return questions_.repeat();
    const QVariantList all = destinations();
    const QString first = all[0].toMap()["title"].toString(), second = all[1].toMap()["title"].toString();
    narrator_.tell(
        news_.photos == 0
            ? tr("TouchPhoto, start page. 1: %1. 2: %2. More below; F1 for help.").arg(first, second)
            : tr("TouchPhoto, start page. %3 1: %1. 2: %2. More below; F1 for help.")
                  .arg(first, second, news()),
        Priority::touch);
    told_ = true;
}

void StartSession::go(int index) {
    const QVariantList all = destinations();
    if (asking() || index < 0 || index >= all.size())
        return;
    emit pageAsked(all[index].toMap()["page"].toString());
}

} // namespace tp
