// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/index/album_news.hpp"
#include "app/pages/start/first_questions.hpp"
#include "app/parts/narration/narrator.hpp"
#include "app/parts/preferences/preferences.hpp"

#include <QObject>
#include <QString>
#include <QVariantList>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// Where the program begins: at the first start five questions, then the way to each page.
class StartSession final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(tp::FirstQuestions* questions READ questions CONSTANT)
    Q_PROPERTY(bool asking READ asking NOTIFY changed)
    /// {page, title, hint}; the first two are the main ones.
    Q_PROPERTY(QVariantList destinations READ destinations NOTIFY changed)
    /// "12 new photographs, 9 with people."; empty: nothing is new
    Q_PROPERTY(QString news READ news NOTIFY changed)
public:
    /// All must outlive the session.
    StartSession(Narrator& narrator, Preferences& preferences, FirstQuestions::FindDevices find_devices);

    FirstQuestions* questions() { return &questions_; }
    bool asking() const { return questions_.asking(); }
    QVariantList destinations() const;
    QString news() const;
    /// What is new in the album. Told at once to whoever is here, when it is known whole: `looking`, people may still be
    /// found on what is new.
    void know(const News& news, bool looking);

    /// Tells where one is and the two things one can do, or the question that waits.
    Q_INVOKABLE void enter();
    Q_INVOKABLE void leave();
    Q_INVOKABLE void repeat();
    /// Asks the five once more.
    Q_INVOKABLE void askAgain();
    /// Goes to a destination by its index.
    Q_INVOKABLE void go(int index);

signals:
    void changed();
    void pageAsked(const QString& page);

private:
    Narrator& narrator_;
    Preferences& preferences_;
    FirstQuestions questions_;
    News news_;
    bool told_ = true; ///< the news that there are
    bool here_ = false;
};

} // namespace tp
