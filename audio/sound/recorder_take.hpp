// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/sound/recorder.hpp"

#include <QObject>
#include <QString>

namespace tp {

/// A take: what one of several who share a recorder has it record. What the recorder does for another is not told here.
///
/// |           | begin   | the recorder hears | finish    | discard | done, failed |
/// |-----------|---------|--------------------|-----------|---------|--------------|
/// | idle      | waiting |                    |           |         |              |
/// | waiting   |         | recording          | finishing | idle    | idle         |
/// | recording |         |                    | finishing | idle    | idle         |
/// | finishing |         |                    |           | idle    | idle         |
class RecorderTake final : public QObject {
    Q_OBJECT
public:
    enum class State {
        idle,      ///< nothing is recorded for this one
        waiting,   ///< for the microphone
        recording, ///< something was recorded; the recorder says whether it is paused
        finishing  ///< the file is being made
    };

    /// The recorder must outlive it.
    explicit RecorderTake(Recorder& recorder, QObject* parent = nullptr);

    State state() const { return state_; }
    bool running() const { return state_ != State::idle; }

    /// The recorder is busy neither for this one nor for another.
    bool can_begin() const { return !running() && recorder_.state() == RecorderState::idle; }
    /// Nothing where it cannot.
    void begin(const RecordingPlan& plan);
    /// Makes the file in its own time; `done` or `failed` follows. False: nothing was running, or that was asked for before.
    bool finish();
    /// Throws away what was recorded. Ask the person first: there is no way back.
    void discard();

signals:
    /// The first sound is recorded.
    void heard();
    void said(const QString& sentence);
    /// With these it is idle again.
    void done(const tp::FinishedRecording& recording);
    void failed(const QString& sentence);

private:
    Recorder& recorder_;
    State state_ = State::idle;
};

} // namespace tp
