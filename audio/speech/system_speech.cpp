// SPDX-License-Identifier: Apache-2.0
#include "audio/speech/system_speech.hpp"

#include "audio/speech/speech_worker.hpp"

#include <iterator>
#include <utility>

namespace tp {

namespace {
constexpr const char* engines[] = {"speechd",
                                   "flite"}; // tried in this order; others may only pretend ("mock")
constexpr int longest_search_ms = 8000;      // speech-dispatcher takes 1–4 s
constexpr int longest_goodbye_ms = 2000;
} // namespace

SystemSpeech::SystemSpeech() {
    too_long_.setSingleShot(true);
    too_long_.setInterval(longest_search_ms);
    connect(&too_long_, &QTimer::timeout, this, &SystemSpeech::try_next);
}

SystemSpeech::~SystemSpeech() {
    QThread* thread = std::exchange(thread_, nullptr);
    if (thread == nullptr)
        return;
    thread->quit();
    if (thread->wait(longest_goodbye_ms))
        delete thread;
}

void SystemSpeech::start() {
    if (next_ == 0)
        try_next();
}

void SystemSpeech::try_next() {
    leave_behind();
    if (next_ == static_cast<int>(std::size(engines))) {
        emit none_left();
        return;
    }
    thread_ = new QThread;
    thread_->setObjectName("speech");
    worker_ = new SpeechWorker(engines[next_++]);
    worker_->moveToThread(thread_);
    connect(thread_, &QThread::started, worker_, &SpeechWorker::find_engine);
    connect(thread_, &QThread::finished, worker_, &QObject::deleteLater);
    connect(worker_, &SpeechWorker::finished, this, &SystemSpeech::finished);
    connect(worker_, &SpeechWorker::found, this, [this] {
        too_long_.stop();
        emit found();
    });
    connect(worker_, &SpeechWorker::failed, this, [this] {
        emit lost();
        try_next();
    });
    set_rate(rate_);
    set_language(language_);
    too_long_.start();
    thread_->start();
}

void SystemSpeech::leave_behind() {
    too_long_.stop();
    if (thread_ == nullptr)
        return;
    worker_->disconnect(this);
    connect(thread_, &QThread::finished, thread_, &QObject::deleteLater);
    thread_->quit();
    thread_ = nullptr;
    worker_ = nullptr;
}

void SystemSpeech::speak(quint64 id, const QString& text) {
    if (worker_ != nullptr)
        QMetaObject::invokeMethod(worker_, [worker = worker_, id, text] { worker->speak(id, text); });
}

void SystemSpeech::cancel() {
    if (worker_ != nullptr)
        QMetaObject::invokeMethod(worker_, [worker = worker_] { worker->cancel(); });
}

void SystemSpeech::set_rate(double rate) {
    rate_ = rate;
    if (worker_ != nullptr)
        QMetaObject::invokeMethod(worker_, [worker = worker_, rate] { worker->set_rate(rate); });
}

void SystemSpeech::set_language(const QString& language) {
    language_ = language;
    if (worker_ != nullptr)
        QMetaObject::invokeMethod(worker_, [worker = worker_, language] { worker->set_language(language); });
}

} // namespace tp
