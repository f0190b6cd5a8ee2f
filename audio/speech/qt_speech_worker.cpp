// SPDX-License-Identifier: Apache-2.0
#include "audio/speech/qt_speech_worker.hpp"

#include <QLocale>

#include <utility>

namespace tp {

QtSpeechWorker::QtSpeechWorker(QString engine) : engine_(std::move(engine)) {}

bool QtSpeechWorker::open() {
    if (QTextToSpeech::availableEngines().contains(engine_))
        speech_ = new QTextToSpeech(engine_, this);
    if (speech_ == nullptr || speech_->state() == QTextToSpeech::Error)
        return false;
    connect(speech_, &QTextToSpeech::stateChanged, this, &QtSpeechWorker::state_became);
    return true;
}

void QtSpeechWorker::say(quint64 id, const QString& text) {
    id_ = id;
    speaks_ = false;
    speech_->say(text);
    if (speech_->state() == QTextToSpeech::Error)
        not_begun(id_);
}

void QtSpeechWorker::silence() { speech_->stop(); }

void QtSpeechWorker::use_rate(double rate) { speech_->setRate(rate); }

void QtSpeechWorker::use_language(const QString& language) {
    const QLocale wanted(language);
    for (const QLocale& locale : speech_->availableLocales())
        if (locale.language() == wanted.language()) {
            if (speech_->locale().language() != wanted.language())
                speech_->setLocale(locale);
            return;
        }
}

void QtSpeechWorker::state_became(QTextToSpeech::State state) {
    if (state == QTextToSpeech::Speaking) {
        speaks_ = true;
        begun(id_);
    } else if (state == QTextToSpeech::Error) {
        not_begun(id_);
    } else if (state == QTextToSpeech::Ready && speaks_) {
        ended(id_); // a Ready before any Speaking belongs to the text that this one replaced
    }
}

} // namespace tp
