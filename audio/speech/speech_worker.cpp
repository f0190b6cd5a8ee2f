// SPDX-License-Identifier: Apache-2.0
#include "audio/speech/speech_worker.hpp"

#include <QLocale>

#include <algorithm>
#include <utility>

namespace tp {

namespace {
constexpr int mute_after = 2; ///< texts in a row that an engine never began
constexpr int longest_ms(qsizetype letters) { return 5000 + 200 * static_cast<int>(letters); }
} // namespace

SpeechWorker::SpeechWorker(const char* engine) : engine_(QLatin1String(engine)), too_long_(this) {
    too_long_.setSingleShot(true);
    connect(&too_long_, &QTimer::timeout, this, [this] { begun_ ? end() : not_begun(); });
}

void SpeechWorker::find_engine() {
    if (QTextToSpeech::availableEngines().contains(engine_))
        speech_ = new QTextToSpeech(engine_, this);
    if (speech_ == nullptr || speech_->state() == QTextToSpeech::Error) {
        emit failed();
        return;
    }
    connect(speech_, &QTextToSpeech::stateChanged, this, &SpeechWorker::state_became);
    speech_->setRate(rate_);
    apply_language();
    emit found();
}

void SpeechWorker::speak(quint64 id, const QString& text) {
    if (speech_ == nullptr)
        return;
    id_ = id;
    begun_ = false;
    too_long_.start(longest_ms(text.size()));
    speech_->say(text);
    if (speech_->state() == QTextToSpeech::Error)
        not_begun();
}

void SpeechWorker::cancel() {
    id_ = 0;
    too_long_.stop();
    if (speech_ != nullptr)
        speech_->stop();
}

void SpeechWorker::set_rate(double rate) {
    rate_ = std::clamp(rate, -1.0, 1.0);
    if (speech_ != nullptr)
        speech_->setRate(rate_);
}

void SpeechWorker::set_language(const QString& language) {
    language_ = language;
    apply_language();
}

/// An engine that has no voice of the language keeps the one it has.
void SpeechWorker::apply_language() {
    if (speech_ == nullptr || language_.isEmpty())
        return;
    const QLocale wanted(language_);
    for (const QLocale& locale : speech_->availableLocales())
        if (locale.language() == wanted.language()) {
            if (speech_->locale().language() != wanted.language())
                speech_->setLocale(locale);
            return;
        }
}

void SpeechWorker::state_became(QTextToSpeech::State state) {
    if (state == QTextToSpeech::Speaking) {
        begun_ = true;
        failures_ = 0;
    } else if (state == QTextToSpeech::Error) {
        not_begun();
    } else if (state == QTextToSpeech::Ready && begun_) {
        end(); // a Ready before any Speaking belongs to the text that this one replaced
    }
}

void SpeechWorker::not_begun() {
    const bool mute = id_ != 0 && ++failures_ == mute_after;
    end();
    if (mute)
        emit failed();
}

void SpeechWorker::end() {
    too_long_.stop();
    if (const quint64 id = std::exchange(id_, 0); id != 0)
        emit finished(id);
}

} // namespace tp
