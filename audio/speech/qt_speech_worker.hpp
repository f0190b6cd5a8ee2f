// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/speech/speech_worker.hpp"

#include <QTextToSpeech>

namespace tp {

/// An engine of Qt TextToSpeech.
class QtSpeechWorker final : public SpeechWorker {
    Q_OBJECT
public:
    /// `engine` as Qt names it.
    explicit QtSpeechWorker(QString engine);

private:
    bool open() override;
    void say(quint64 id, const QString& text) override;
    void silence() override;
    void use_rate(double rate) override;
    void use_language(const QString& language) override;
    void state_became(QTextToSpeech::State state);

    QString engine_;
    QTextToSpeech* speech_ = nullptr; ///< a child, so that it dies on this thread
    quint64 id_ = 0;
    bool speaks_ = false; ///< it has said that it speaks `id_`
};

} // namespace tp
