// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/speech/speech_engine.hpp"
#include "audio/speech/spoken_names.hpp"

#include <QObject>
#include <QString>
#include <QThread>
#include <QTimer>

namespace tp {

class SpeechWorker;

/// The speech engine of this system (speech-dispatcher, then Qt TextToSpeech's flite), each tried on a thread
/// of its own, because finding one takes seconds and one that hangs may hang for ever. An engine that does
/// not answer in time, or turns out to be mute, is left behind and the next one tried. When one goes that has
/// spoken, they are all tried again: a speech server that died can be started anew.
class SystemSpeech final : public QObject, public SpeechEngine {
    Q_OBJECT
public:
    SystemSpeech();
    /// Leaves an engine that hangs where it hangs rather than keep the program from ending.
    ~SystemSpeech() override;

    /// Looks for an engine; `trying` and then `found` or `none_left` follow. Once only.
    void start();
    void speak(quint64 id, const QString& text) override;
    void cancel() override;
    void set_rate(double rate);
    void set_language(const QString& language);
    void set_name_languages(const SpokenNames& names);

signals:
    /// An engine is being looked for and speaks what it is given meanwhile, unless it is `lost`.
    void trying();
    void found();
    /// The engine that was found or tried is no longer used; another is looked for.
    void lost();
    void none_left();
    void finished(quint64 id);

private:
    void try_next();
    void leave_behind();

    QThread* thread_ = nullptr;
    SpeechWorker* worker_ = nullptr; ///< lives on thread_, whose end deletes it
    int next_ = 0;                   ///< engine to be tried when this one fails
    bool spoke_ = false;             ///< this one has
    QTimer too_long_;
    double rate_ = 0.0;
    QString language_;
    SpokenNames names_;
};

} // namespace tp
