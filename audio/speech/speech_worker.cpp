// SPDX-License-Identifier: Apache-2.0
#include "audio/speech/speech_worker.hpp"

#include <algorithm>

namespace tp {

namespace {
constexpr int mute_after = 2; ///< texts in a row that an engine never began
constexpr int longest_ms(qsizetype letters) { return 5000 + 200 * static_cast<int>(letters); }
} // namespace

SpeechWorker::SpeechWorker() : too_long_(this) {
    too_long_.setSingleShot(true);
    connect(&too_long_, &QTimer::timeout, this, [this] { begun_ ? ended(id_) : not_begun(id_); });
}

void SpeechWorker::find_engine() {
    open_ = open();
    if (!open_) {
        emit failed();
        return;
    }
    use_rate(rate_);
    if (!language_.isEmpty())
        use_language(language_);
    emit found();
}

void SpeechWorker::speak(quint64 id, const QString& text) {
    if (!open_)
        return;
    id_ = id;
    begun_ = false;
    too_long_.start(longest_ms(text.size()));
    say(id, text);
}

void SpeechWorker::cancel() {
    id_ = 0;
    too_long_.stop();
    if (open_)
        silence();
}

void SpeechWorker::set_rate(double rate) {
    rate_ = std::clamp(rate, -1.0, 1.0);
    if (open_)
        use_rate(rate_);
}

void SpeechWorker::set_language(const QString& language) {
    language_ = language;
    if (open_ && !language_.isEmpty())
        use_language(language_);
}

void SpeechWorker::begun(quint64 id) {
    if (id != id_)
        return;
    begun_ = true;
    failures_ = 0;
    emit spoke();
}

void SpeechWorker::not_begun(quint64 id) {
    if (id == 0 || id != id_)
        return;
    const bool mute = ++failures_ == mute_after;
    ended(id);
    if (mute)
        emit failed();
}

void SpeechWorker::ended(quint64 id) {
    if (id == 0 || id != id_)
        return;
    too_long_.stop();
    id_ = 0;
    emit finished(id);
}

} // namespace tp
