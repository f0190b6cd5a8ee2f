// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/start/questions.hpp"
#include "app/parts/folders/folder_chooser.hpp"
#include "app/parts/narration/narrator.hpp"
#include "app/parts/preferences/preferences.hpp"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QThreadPool>
#include <QtQml/qqmlregistration.h>

#include <functional>
#include <vector>

namespace tp {

/// A force device that is plugged in.
struct FoundDevice {
    QString about, serial_number;
};

/// The five questions of the first start, one after the other; each answer is kept at once.
///
/// | state | answer | back |
/// | --- | --- | --- |
/// | a question | the next one; after the last, or with a folder, the end | the one before; none at the first |
/// | choosing a folder | is the chooser's: the end | the last question |
class FirstQuestions final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    /// From 1.
    Q_PROPERTY(int number READ number NOTIFY changed)
    Q_PROPERTY(int count READ count CONSTANT)
    Q_PROPERTY(QString question READ question NOTIFY changed)
    Q_PROPERTY(QStringList answers READ answers NOTIFY changed)
    /// The answer that holds now; -1: none.
    Q_PROPERTY(int current READ current NOTIFY changed)
    /// A folder is being chosen for the last question.
    Q_PROPERTY(bool choosing READ choosing NOTIFY changed)
    Q_PROPERTY(tp::FolderChooser* chooser READ chooser CONSTANT)
public:
    using FindDevices = std::function<std::vector<FoundDevice>()>;

    /// `find_devices` is called on another thread, one call at a time. All must outlive the questions.
    FirstQuestions(Narrator& narrator, Preferences& preferences, FindDevices find_devices);
    ~FirstQuestions() override;

    int number() const { return static_cast<int>(question_) + 1; }
    int count() const { return question_count; }
    QString question() const { return words_of(question_, facts_); }
    QStringList answers() const { return answers_of(question_, facts_); }
    int current() const;
    bool choosing() const { return choosing_; }
    FolderChooser* chooser() { return &chooser_; }

    bool asking() const { return asking_; }
    /// Asks them from the first on.
    void begin();
    /// Asks the one that waits once more.
    void go_on() { ask(question_); }
    /// Says what waits for an answer.
    void repeat();
    /// By its index; the next question follows.
    Q_INVOKABLE void answer(int index);
    /// The question before; false at the first.
    Q_INVOKABLE bool back();

signals:
    void changed();
    void ended();

private:
    void ask(Question question);
    void end();
    void look_for_device();
    void device_found(const std::vector<FoundDevice>& devices);
    void answer_device(int index);
    void answer_photos(int index);
    void take_folder(const QString& folder);

    Narrator& narrator_;
    Preferences& preferences_;
    FindDevices find_devices_;
    FolderChooser chooser_;
    QuestionFacts facts_;
    QString serial_number_;
    Question question_ = Question::voice;
    bool asking_;
    bool choosing_ = false;
    QThreadPool pool_; ///< last: it ends before what its work is for
};

} // namespace tp
