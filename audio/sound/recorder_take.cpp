// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/recorder_take.hpp"

#include <utility>

namespace tp {

RecorderTake::RecorderTake(Recorder& recorder, QObject* parent) : QObject(parent), recorder_(recorder) {
    connect(&recorder_, &Recorder::state_changed, this, [this] {
        if (state_ != State::waiting || recorder_.state() != RecorderState::recording)
            return;
        state_ = State::recording;
        emit heard();
    });
    connect(&recorder_, &Recorder::said, this, [this](const QString& sentence) {
        if (running())
            emit said(sentence);
    });
    connect(&recorder_, &Recorder::done, this, [this](const FinishedRecording& recording) {
        if (std::exchange(state_, State::idle) != State::idle)
            emit done(recording);
    });
    connect(&recorder_, &Recorder::failed, this, [this](const QString& sentence) {
        if (std::exchange(state_, State::idle) != State::idle)
            emit failed(sentence);
    });
}

void RecorderTake::begin(const RecordingPlan& plan) {
    if (!can_begin())
        return;
    state_ = State::waiting;
    recorder_.start(plan);
}

bool RecorderTake::finish() {
    if (state_ == State::idle || std::exchange(state_, State::finishing) == State::finishing)
        return false;
    recorder_.finish();
    return true;
}

void RecorderTake::discard() {
    if (std::exchange(state_, State::idle) != State::idle)
        recorder_.discard();
}

} // namespace tp
