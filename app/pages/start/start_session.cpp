// SPDX-License-Identifier: Apache-2.0
#include "app/pages/start/start_session.hpp"

#include <QMetaObject>
#include <QVariantMap>

#include <utility>

namespace tp {

StartSession::StartSession(Narrator& narrator, Preferences& preferences, FindDevices find_devices)
    : narrator_(narrator), preferences_(preferences), find_devices_(std::move(find_devices)), chooser_(narrator),
      asking_(!preferences.choices().asked) {
    pool_.setMaxThreadCount(1);
    facts_.pictures = FolderChooser::pictures_folder();
    connect(&preferences_, &Preferences::changed, this, &StartSession::changed);
    connect(&chooser_, &FolderChooser::chosen, this, &StartSession::take_folder);
    connect(&chooser_, &FolderChooser::cancelled, this, [this] { ask(Question::photos); });
}

StartSession::~StartSession() { pool_.waitForDone(); }

int StartSession::current() const { return answer_in(question_, preferences_.choices()); }

// --- the questions ---

void StartSession::ask(Question question) {
    question_ = question;
    choosing_ = false;
    if (question == Question::device && facts_.device.isEmpty())
        look_for_device();
    emit changed();
    repeat();
}

void StartSession::askAgain() {
    asking_ = true;
    ask(Question::voice);
}

void StartSession::answer(int index) {
    if (!asking_ || choosing_ || index < 0 || index >= answers().size())
        return;
    if (question_ == Question::device)
        return answer_device(index);
    if (question_ == Question::photos)
        return answer_photos(index);
    preferences_.change([&](Choices& choices) { take_answer(question_, index, choices); });
    ask(static_cast<Question>(static_cast<int>(question_) + 1));
}

bool StartSession::back() {
    if (!asking_)
        return false;
    if (choosing_) {
        ask(Question::photos);
        return true;
    }
    if (question_ == Question::voice)
        return false;
    ask(static_cast<Question>(static_cast<int>(question_) - 1));
    return true;
}

void StartSession::end_asking() {
    asking_ = false;
    choosing_ = false;
    preferences_.change([](Choices& choices) { choices.asked = true; });
    emit changed();
    enter();
}

void StartSession::look_for_device() {
    if (facts_.looking_for_device)
        return;
    facts_.looking_for_device = true;
    pool_.start([this] {
        std::vector<FoundDevice> devices = find_devices_();
        QMetaObject::invokeMethod(this, [this, devices = std::move(devices)] { device_found(devices); });
    });
}

void StartSession::device_found(const std::vector<FoundDevice>& devices) {
    facts_.looking_for_device = false;
    facts_.device = devices.empty() ? QString() : devices.front().about;
    serial_number_ = devices.empty() ? QString() : devices.front().serial_number;
    emit changed();
    if (asking_ && question_ == Question::device)
        repeat();
}

void StartSession::answer_device(int index) {
    if (index == 1) {
        facts_.device.clear();
        return ask(Question::device);
    }
    if (!serial_number_.isEmpty())
        preferences_.change([&](Choices& choices) { choices.device = serial_number_; });
    ask(Question::photos);
}

void StartSession::answer_photos(int index) {
    const int other = facts_.pictures.isEmpty() ? 0 : 1;
    if (index < other)
        return take_folder(facts_.pictures);
    if (index > other)
        return end_asking();
    choosing_ = true;
    emit changed();
    chooser_.begin();
}

void StartSession::take_folder(const QString& folder) {
    preferences_.change([&](Choices& choices) {
        if (!choices.folders.contains(folder))
            choices.folders << folder;
    });
    end_asking();
}

// --- the way to each page ---

QVariantList StartSession::destinations() const {
    const QVariantMap browse{{"page", "browse"},
                             {"title", tr("Listen to photographs")},
                             {"hint", tr("One photograph after the other, with what was recorded for it")}};
    const QVariantMap explore{{"page", "explore"},
                              {"title", tr("Feel a face")},
                              {"hint", tr("The photograph that you were at last, under your finger")}};
    const QVariantMap care{{"page", "care"},
                           {"title", tr("Look after the album")},
                           {"hint", tr("Import photographs, name people, record")}};
    const QVariantMap settings{{"page", "settings"},
                               {"title", tr("Settings")},
                               {"hint", tr("Speech, colours, force, where photographs are")}};
    const QVariantMap lab{{"page", "lab"},
                          {"title", tr("Lab")},
                          {"hint", tr("For researchers: guidance laws, their parameters, plots, recordings")}};
    const QVariantMap capture{{"page", ""},
                              {"title", tr("Take a photograph")},
                              {"hint", tr("Not there yet: photographs of any camera can be imported")}};
    const QVariantMap study{{"page", ""},
                            {"title", tr("Studies")},
                            {"hint", tr("Not there yet")}};
    const bool caregiver = preferences_.choices().user == Choices::User::caregiver;
    QVariantList list = caregiver ? QVariantList{care, browse, explore} : QVariantList{browse, explore, care};
    list << settings << lab << capture << study;
    return list;
}

void StartSession::enter() {
    if (asking_)
        return ask(question_);
    repeat();
}

void StartSession::leave() { narrator_.stop(); }

void StartSession::repeat() {
    if (choosing_)
        return narrator_.repeat();
    if (asking_)
        return narrator_.tell(spoken(question_, facts_), Priority::touch);
    const QVariantList all = destinations();
    narrator_.tell(tr("TouchPhoto, start page. 1: %1. 2: %2. More below; F1 for help.")
                       .arg(all[0].toMap()["title"].toString(), all[1].toMap()["title"].toString()),
                   Priority::touch);
}

void StartSession::go(int index) {
    const QVariantList all = destinations();
    if (asking_ || index < 0 || index >= all.size())
        return;
    const QVariantMap destination = all[index].toMap();
    if (destination["page"].toString().isEmpty())
        return narrator_.tell(destination["title"].toString() + ": " + destination["hint"].toString() + ".",
                              Priority::touch);
    emit pageAsked(destination["page"].toString());
}

} // namespace tp
