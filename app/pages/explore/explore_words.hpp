// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/finger/page_clock.hpp"
#include "app/parts/narration/narrator.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "audio/sound/earcon_player.hpp"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// What the explore page tells, and when it will have been spoken. Out of sight it is only shown.
class ExploreWords final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")

    Q_PROPERTY(QString sentence READ sentence NOTIFY sentenceChanged)
    Q_PROPERTY(bool voiceOn READ voiceOn WRITE setVoiceOn NOTIFY voiceChanged)
    Q_PROPERTY(QString voiceProblem READ voiceProblem NOTIFY voiceChanged)
public:
    /// All must outlive this.
    ExploreWords(Narrator& narrator, EarconPlayer& earcons, Preferences& preferences, const PageClock& now);

    const QString& sentence() const { return sentence_; }
    bool voiceOn() const { return narrator_.voice_on(); }
    void setVoiceOn(bool on);
    QString voiceProblem() const { return narrator_.voice_problem(); }

    /// The page comes into sight, or goes out of it.
    void enter() { here_ = true; }
    void leave() { here_ = false; }

    /// Shows and tells; returns when it will have been spoken, s.
    double tell(const QString& sentence, Priority priority);
    /// The same behind an earcon.
    void tell(Earcon earcon, const QString& sentence, Priority priority);
    /// A word to the finger that the page need not show.
    void murmur(const QString& words);
    /// Tells something that went wrong on the page itself.
    Q_INVOKABLE void tellProblem(const QString& sentence);
    /// Ends what is being said.
    void hush() { narrator_.stop(); }
    /// When all that was told will have been spoken, s.
    double busy_until() const { return busy_until_; }

signals:
    void sentenceChanged();
    void voiceChanged();

private:
    double spoken_at(const QString& words);

    Narrator& narrator_;
    EarconPlayer& earcons_;
    Preferences& preferences_;
    const PageClock& now_;
    QString sentence_;
    bool here_ = true; ///< the page is in sight
    double busy_until_ = 0.0;
};

} // namespace tp
