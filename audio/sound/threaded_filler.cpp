// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/threaded_filler.hpp"

#include "audio/sound/filling_worker.hpp"

#include <utility>

namespace tp {

namespace {
constexpr int longest_last_fill_ms = 2000;
} // namespace

ThreadedFiller::ThreadedFiller(QObject* parent)
    : StreamFiller(parent), thread_(new QThread), worker_(new FillingWorker) {
    thread_->setObjectName("decoding");
    worker_->moveToThread(thread_);
    connect(thread_, &QThread::finished, worker_, &QObject::deleteLater);
    connect(worker_, &FillingWorker::ready, this, &StreamFiller::ready);
    connect(worker_, &FillingWorker::unreadable, this, &StreamFiller::unreadable);
    thread_->start();
}

ThreadedFiller::~ThreadedFiller() {
    thread_->quit();
    if (thread_->wait(longest_last_fill_ms))
        delete thread_;
}

void ThreadedFiller::begin(quint64 run, std::shared_ptr<PlaybackStream> stream) {
    QMetaObject::invokeMethod(worker_, [worker = worker_, run, stream = std::move(stream)]() mutable {
        worker->begin(run, std::move(stream));
    });
}

void ThreadedFiller::leave() {
    QMetaObject::invokeMethod(worker_, [worker = worker_] { worker->leave(); });
}

} // namespace tp
