// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/recorder.hpp"

#include "audio/sound/sound_words.hpp"
#include "audio/sound/system_microphone.hpp"

#include <QDateTime>

#include <utility>

namespace tp {

Recorder::Recorder(MakeInput make_input, QObject* parent)
    : QObject(parent), thread_(new QThread), worker_(new RecorderWorker(std::move(make_input))) {
    thread_->setObjectName("recorder");
    worker_->moveToThread(thread_);
    connect(thread_, &QThread::finished, worker_, &QObject::deleteLater);
    connect(worker_, &RecorderWorker::state_changed, this, [this](RecorderState state) {
        state_ = state;
        emit state_changed();
    });
    connect(worker_, &RecorderWorker::level_changed, this, [this](double rms_dbfs, double peak_dbfs) {
        rms_dbfs_ = rms_dbfs;
        peak_dbfs_ = peak_dbfs;
        emit level_changed();
    });
    connect(worker_, &RecorderWorker::time_changed, this, [this](double recorded_s, double left_s) {
        recorded_s_ = recorded_s;
        left_s_ = left_s;
        emit time_changed();
    });
    connect(worker_, &RecorderWorker::said, this, &Recorder::said);
    connect(worker_, &RecorderWorker::done, this, &Recorder::done);
    connect(worker_, &RecorderWorker::failed, this, &Recorder::failed);
    thread_->start();
}

Recorder::~Recorder() {
    thread_->quit();
    thread_->wait(); // however long: what was recorded is being brought to the disk
    delete thread_;
}

template <typename Call>
void Recorder::ask(Call call) {
    QMetaObject::invokeMethod(worker_, [worker = worker_, call = std::move(call)] { call(*worker); });
}

void Recorder::start(const RecordingPlan& plan) {
    RecordingPlan now = plan;
    if (now.notes.label.recorded.empty())
        now.notes.label.recorded = time_text(QDateTime::currentDateTime());
    ask([now](RecorderWorker& worker) { worker.start(now); });
}

void Recorder::pause() {
    ask([](RecorderWorker& worker) { worker.pause(); });
}

void Recorder::go_on() {
    ask([](RecorderWorker& worker) { worker.go_on(); });
}

void Recorder::finish() {
    ask([](RecorderWorker& worker) { worker.finish(); });
}

void Recorder::discard() {
    ask([](RecorderWorker& worker) { worker.discard(); });
}

std::unique_ptr<SoundInput> system_microphone() { return std::make_unique<SystemMicrophone>(); }

} // namespace tp
