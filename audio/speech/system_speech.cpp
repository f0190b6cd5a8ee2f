// SPDX-License-Identifier: Apache-2.0
#include "audio/speech/system_speech.hpp"

#include "audio/speech/dispatcher_worker.hpp"
#include "audio/speech/qt_speech_worker.hpp"
#include "audio/speech/speech_worker.hpp"

#include <memory>
#include <utility>

namespace tp {

namespace {

constexpr int longest_search_ms = 8000; ///< to start speech-dispatcher takes about 1 s
constexpr int longest_goodbye_ms = 2000;

/// Tried in this order; others of Qt's may only pretend ("mock").
std::unique_ptr<SpeechWorker> engine(int place) {
    switch (place) {
    case 0: return std::make_unique<DispatcherWorker>();
    case 1: return std::make_unique<QtSpeechWorker>("flite");
    default: return nullptr;
    }
}

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
    std::unique_ptr<SpeechWorker> next = engine(next_);
    if (next == nullptr) {
        emit none_left();
        return;
    }
    ++next_;
    thread_ = new QThread;
    thread_->setObjectName("speech");
    worker_ = next.release();
    worker_->moveToThread(thread_);
    connect(thread_, &QThread::started, worker_, &SpeechWorker::find_engine);
    connect(thread_, &QThread::finished, worker_, &QObject::deleteLater);
    connect(worker_, &SpeechWorker::finished, this, &SystemSpeech::finished);
    connect(worker_, &SpeechWorker::found, this, [this] {
        too_long_.stop();
        emit found();
    });
    connect(worker_, &SpeechWorker::spoke, this, [this] { spoke_ = true; });
    connect(worker_, &SpeechWorker::failed, this, [this] {
        if (std::exchange(spoke_, false))
            next_ = 0;
        try_next();
    });
    set_rate(rate_);
    set_language(language_);
    set_name_languages(names_);
    too_long_.start();
    thread_->start();
    emit trying();
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
    emit lost();
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

void SystemSpeech::set_name_languages(const SpokenNames& names) {
    names_ = names;
    if (worker_ != nullptr)
        QMetaObject::invokeMethod(worker_, [worker = worker_, names] { worker->set_name_languages(names); });
}

} // namespace tp
