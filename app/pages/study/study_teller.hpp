// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/narration/narrator.hpp"
#include "audio/sound/earcon_player.hpp"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// How the study page speaks. What was told last is shown too, so that a researcher beside the participant can read it.
/// Out of sight it says nothing.
class StudyTeller final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")

    Q_PROPERTY(QString sentence READ sentence NOTIFY told)
public:
    /// Both must outlive it.
    StudyTeller(Narrator& narrator, EarconPlayer& earcons) : narrator_(narrator), earcons_(earcons) {}

    const QString& sentence() const { return sentence_; }

    void set_here(bool here) { here_ = here; }
    /// What the person waits for; it ends what is being said.
    void tell(const QString& sentence);
    /// Said when what is being said has ended.
    void add(const QString& sentence);
    void did(Earcon earcon, const QString& sentence);
    /// What was asked for was not done, and what to do.
    void problem(const QString& sentence) { did(Earcon::error, sentence); }
    void sound(Earcon earcon);
    void hush() { narrator_.stop(); }

signals:
    void told();

private:
    void say(const QString& sentence, Priority priority);

    Narrator& narrator_;
    EarconPlayer& earcons_;
    QString sentence_;
    bool here_ = false;
};

} // namespace tp
