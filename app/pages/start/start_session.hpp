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
#include <QVariantList>
#include <QtQml/qqmlregistration.h>

#include <functional>
#include <vector>

namespace tp {

/// A force device that is plugged in.
struct FoundDevice {
    QString about, serial_number;
};

/// Where the program begins: at the first start five questions, then the way to each page.
class StartSession final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(bool asking READ asking NOTIFY changed)
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

    /// {page, title, hint}; the first two are the main ones. `page` is empty where the page is not there yet.
    Q_PROPERTY(QVariantList destinations READ destinations NOTIFY changed)
public:
    using FindDevices = std::function<std::vector<FoundDevice>()>;

    /// `find_devices` is called on another thread, one call at a time. All must outlive the session.
    StartSession(Narrator& narrator, Preferences& preferences, FindDevices find_devices);
    ~StartSession() override;

    bool asking() const { return asking_; }
    int number() const { return static_cast<int>(question_) + 1; }
    int count() const { return question_count; }
    QString question() const { return words_of(question_, facts_); }
    QStringList answers() const { return answers_of(question_, facts_); }
    int current() const;
    bool choosing() const { return choosing_; }
    FolderChooser* chooser() { return &chooser_; }
    QVariantList destinations() const;

    /// Tells where one is and the two things one can do, or the question that waits.
    Q_INVOKABLE void enter();
    Q_INVOKABLE void leave();
    Q_INVOKABLE void repeat();
    /// By its index; the next question follows.
    Q_INVOKABLE void answer(int index);
    /// The question before; false at the first.
    Q_INVOKABLE bool back();
    /// Asks the five once more.
    Q_INVOKABLE void askAgain();
    /// Goes to a destination by its index.
    Q_INVOKABLE void go(int index);

signals:
    void changed();
    void pageAsked(const QString& page);

private:
    void ask(Question question);
    void end_asking();
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
