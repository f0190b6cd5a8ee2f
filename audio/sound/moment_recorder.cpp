// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/moment_recorder.hpp"

#include <utility>

namespace tp {

MomentRecorder::MomentRecorder(MakeInput make_input, QObject* parent)
    : QObject(parent), thread_(new QThread), worker_(new MomentWorker(std::move(make_input))) {
    thread_->setObjectName("moment");
    worker_->moveToThread(thread_);
    connect(thread_, &QThread::finished, worker_, &QObject::deleteLater);
    connect(worker_, &MomentWorker::hearing_changed, this, [this](bool hears) {
        hears_ = hears;
        emit hears_changed();
    });
    connect(worker_, &MomentWorker::kept, this, &MomentRecorder::kept);
    connect(worker_, &MomentWorker::failed, this, &MomentRecorder::failed);
    thread_->start();
}

MomentRecorder::~MomentRecorder() {
    thread_->quit();
    thread_->wait(); // however long: what is being kept is brought to the disk
    delete thread_;
}

template <typename Call>
void MomentRecorder::ask(Call call) {
    QMetaObject::invokeMethod(worker_, [worker = worker_, call = std::move(call)] { call(*worker); });
}

void MomentRecorder::listen() {
    ask([](MomentWorker& worker) { worker.listen(); });
}

void MomentRecorder::rest() {
    ask([](MomentWorker& worker) { worker.rest(); });
}

quint64 MomentRecorder::shutter() {
    const quint64 number = ++last_;
    ask([number](MomentWorker& worker) { worker.shutter(number); });
    return number;
}

void MomentRecorder::keep(quint64 number, const std::filesystem::path& folder, const QDateTime& shutter) {
    ask([=](MomentWorker& worker) { worker.keep(number, folder, shutter); });
}

void MomentRecorder::drop(quint64 number) {
    ask([number](MomentWorker& worker) { worker.drop(number); });
}

} // namespace tp
