// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QTextToSpeech>
#include <QTimer>

namespace tp {

/// One engine's QTextToSpeech; every call on the thread that the worker was moved to.
class SpeechWorker final : public QObject {
    Q_OBJECT
public:
    /// `engine` as Qt names it.
    explicit SpeechWorker(const char* engine);

    void find_engine();
    void speak(quint64 id, const QString& text);
    void cancel();
    void set_rate(double rate);
    /// Empty: as the engine is.
    void set_language(const QString& language);

signals:
    void found();
    /// There is no such engine, or it is mute: without a sound card one calls itself ready until it must
    /// speak.
    void failed();
    void finished(quint64 id);

private:
    void apply_language();
    void state_became(QTextToSpeech::State state);
    void end();
    void not_begun();

    QString engine_;
    QTextToSpeech* speech_ = nullptr; ///< a child, so that it dies on this thread
    QTimer too_long_; ///< an engine that never says that it has ended must not silence the rest
    double rate_ = 0.0;
    QString language_;
    quint64 id_ = 0;     ///< what is being spoken; 0: nothing
    bool begun_ = false; ///< the engine has said that it speaks `id_`
    int failures_ = 0;   ///< texts in a row that were never begun
};

} // namespace tp
