// SPDX-License-Identifier: Apache-2.0
#include "app/pages/start/first_questions.hpp"

#include <QMetaObject>

#include <utility>

namespace tp {

FirstQuestions::FirstQuestions(Narrator& narrator, Preferences& preferences, FindDevices find_devices)
    : narrator_(narrator), preferences_(preferences), find_devices_(std::move(find_devices)),
      chooser_(narrator), asking_(!preferences.choices().asked) {
    pool_.setMaxThreadCount(1);
    facts_.pictures = FolderChooser::pictures_folder();
    connect(&preferences_, &Preferences::changed, this, &FirstQuestions::changed);
    connect(&chooser_, &FolderChooser::chosen, this, &FirstQuestions::take_folder);
    connect(&chooser_, &FolderChooser::cancelled, this, [this] { ask(Question::photos); });
}

FirstQuestions::~FirstQuestions() { pool_.waitForDone(); }

int FirstQuestions::current() const { return answer_in(question_, preferences_.choices()); }

void FirstQuestions::ask(Question question) {
    question_ = question;
    choosing_ = false;
    if (question == Question::device && facts_.device.isEmpty())
        look_for_device();
    emit changed();
    repeat();
}

void FirstQuestions::begin() {
    asking_ = true;
    ask(Question::voice);
}

void FirstQuestions::answer(int index) {
    if (!asking_ || choosing_ || index < 0 || index >= answers().size())
        return;
    if (question_ == Question::device)
        return answer_device(index);
    if (question_ == Question::photos)
        return answer_photos(index);
    preferences_.change([&](Choices& choices) { take_answer(question_, index, choices); });
    ask(static_cast<Question>(static_cast<int>(question_) + 1));
}

bool FirstQuestions::back() {
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

void FirstQuestions::end() {
    asking_ = false;
    choosing_ = false;
    preferences_.change([](Choices& choices) { choices.asked = true; });
    emit changed();
    emit ended();
}

void FirstQuestions::look_for_device() {
    if (facts_.looking_for_device)
        return;
    facts_.looking_for_device = true;
    pool_.start([this] {
        std::vector<FoundDevice> devices = find_devices_();
        QMetaObject::invokeMethod(this, [this, devices = std::move(devices)] { device_found(devices); });
    });
}

void FirstQuestions::device_found(const std::vector<FoundDevice>& devices) {
    facts_.looking_for_device = false;
    facts_.device = devices.empty() ? QString() : devices.front().about;
    serial_number_ = devices.empty() ? QString() : devices.front().serial_number;
    emit changed();
    if (asking_ && question_ == Question::device)
        repeat();
}

void FirstQuestions::answer_device(int index) {
    if (index == 1) {
        facts_.device.clear();
        return ask(Question::device);
    }
    if (!serial_number_.isEmpty())
        preferences_.change([&](Choices& choices) { choices.device = serial_number_; });
    ask(Question::photos);
}

void FirstQuestions::answer_photos(int index) {
    const int other = facts_.pictures.isEmpty() ? 0 : 1;
    if (index < other)
        return take_folder(facts_.pictures);
    if (index > other)
        return end();
    choosing_ = true;
    emit changed();
    chooser_.begin();
}

void FirstQuestions::take_folder(const QString& folder) {
    preferences_.change([&](Choices& choices) {
        if (!choices.folders.contains(folder))
            choices.folders << folder;
    });
    end();
}

void FirstQuestions::repeat() {
    if (choosing_)
        narrator_.repeat();
    else
        narrator_.tell(spoken(question_, facts_), Priority::touch);
}

} // namespace tp
