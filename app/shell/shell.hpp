// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/narration/narrator.hpp"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

#include <functional>
#include <map>
#include <vector>

namespace tp {

/// Which page is open, and the ways from one to another. Home is the page named first.
class Shell final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(QString page READ page NOTIFY pageChanged)
    Q_PROPERTY(QString title READ title NOTIFY pageChanged)
    Q_PROPERTY(bool home READ home NOTIFY pageChanged)
    Q_PROPERTY(QString sentence READ sentence NOTIFY told)
    Q_PROPERTY(QString voiceProblem READ voiceProblem NOTIFY voiceChanged)
public:
    struct Page {
        QString name; ///< by which it is asked for
        std::function<QString()> title;
        std::function<void()> enter, leave;
    };

    /// The narrator must outlive the shell.
    explicit Shell(Narrator& narrator);

    void add(Page page);

    QString page() const { return page_; }
    QString title() const;
    bool home() const { return !order_.empty() && page_ == order_.front(); }
    QString sentence() const { return narrator_.sentence(); }
    QString voiceProblem() const { return narrator_.voice_problem(); }

    /// Leaves the page that is open and enters another; one that is open already is entered anew.
    Q_INVOKABLE void open(const QString& page);
    /// To the page before this one, at the end home.
    Q_INVOKABLE void back();
    Q_INVOKABLE void goHome();
    /// The page that is open ends what it is doing; none is open then.
    void leave();
    /// Says what can be done here: the page's own words, then the keys that hold everywhere.
    Q_INVOKABLE void help(const QString& of_page);
    Q_INVOKABLE void repeat() { narrator_.repeat(); }
    /// The program's voice on or off, from everywhere.
    Q_INVOKABLE void toggleVoice();
    /// The texts of all pages have changed their language.
    void retranslated();

signals:
    void pageChanged();
    void told();
    void voiceChanged();
    /// The person has switched the program's voice on or off.
    void voice_toggled(bool on);

private:
    void enter(const QString& page);

    Narrator& narrator_;
    std::map<QString, Page> pages_;
    std::vector<QString> order_;
    std::vector<QString> before_; ///< the pages that back() goes to, the last one first
    QString page_;
};

} // namespace tp
