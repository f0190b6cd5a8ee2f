// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/sound/recorder_types.hpp"
#include "audio/sound/recorder_worker.hpp"

#include <QObject>
#include <QThread>

namespace tp {

/// Records from a microphone into a file, on a thread of its own; lives on the page's thread and never blocks
/// it. What it says of itself comes with its signals, a moment after what was asked for.
class Recorder final : public QObject {
    Q_OBJECT
public:
    /// `make_input` is called on the recorder's thread; `system_microphone` for people, another for tests.
    explicit Recorder(MakeInput make_input, QObject* parent = nullptr);
    /// Ends; a recording that was neither finished nor discarded stays as a part, which repair_folder()
    /// finds.
    ~Recorder() override;

    RecorderState state() const { return state_; }
    double recorded_s() const { return recorded_s_; }
    /// How long can still be recorded: until the stated maximum, or until the disk is full.
    double left_s() const { return left_s_; }
    /// Of the last 50 ms; for a meter.
    double rms_dbfs() const { return rms_dbfs_; }
    double peak_dbfs() const { return peak_dbfs_; }

    /// Only while idle. A plan that does not say when it was recorded is recorded now.
    void start(const RecordingPlan& plan);
    void pause();
    void go_on();
    /// Makes the file; `done` or `failed` follows.
    void finish();
    /// Throws away what was recorded. Ask the person first: there is no way back.
    void discard();

signals:
    void state_changed();
    void level_changed();
    void time_changed();
    void said(const QString& sentence);
    void done(const tp::FinishedRecording& recording);
    void failed(const QString& sentence);

private:
    template <typename Call>
    void ask(Call call);

    QThread* thread_;
    RecorderWorker* worker_; ///< lives on thread_, whose end deletes it
    RecorderState state_ = RecorderState::idle;
    double recorded_s_ = 0.0;
    double left_s_ = 0.0;
    double rms_dbfs_ = -200.0;
    double peak_dbfs_ = -200.0;
};

/// This system's own.
std::unique_ptr<SoundInput> system_microphone();

} // namespace tp
