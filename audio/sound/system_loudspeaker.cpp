// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/system_loudspeaker.hpp"

#include "audio/sound/loudspeaker_worker.hpp"

#include <utility>

namespace tp {

namespace {
constexpr int longest_goodbye_ms = 2000;
} // namespace

SystemLoudspeaker::SystemLoudspeaker(QObject* parent)
    : SoundOutput(parent), thread_(new QThread), worker_(new LoudspeakerWorker) {
    thread_->setObjectName("loudspeaker");
    worker_->moveToThread(thread_);
    connect(thread_, &QThread::finished, worker_, &QObject::deleteLater);
    connect(worker_, &LoudspeakerWorker::progress, this, &SoundOutput::progress);
    connect(worker_, &LoudspeakerWorker::drained, this, &SoundOutput::drained);
    connect(worker_, &LoudspeakerWorker::gone, this, &SoundOutput::gone);
    connect(worker_, &LoudspeakerWorker::moved, this, &SoundOutput::moved);
    connect(worker_, &LoudspeakerWorker::came, this, &SoundOutput::came);
    thread_->start(QThread::HighPriority);
}

SystemLoudspeaker::~SystemLoudspeaker() {
    thread_->quit();
    if (thread_->wait(longest_goodbye_ms))
        delete thread_;
}

void SystemLoudspeaker::start(quint64 run, std::shared_ptr<SoundSource> source) {
    QMetaObject::invokeMethod(worker_, [worker = worker_, run, source = std::move(source)]() mutable {
        worker->start(run, std::move(source));
    });
}

void SystemLoudspeaker::stop() {
    QMetaObject::invokeMethod(worker_, [worker = worker_] { worker->stop(); });
}

} // namespace tp
