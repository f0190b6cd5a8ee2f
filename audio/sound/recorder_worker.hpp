// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/level.hpp"
#include "audio/recordings/loudness.hpp"
#include "audio/recordings/wav_part.hpp"
#include "audio/sound/recorder_types.hpp"
#include "audio/sound/recording_room.hpp"
#include "audio/sound/sound_input.hpp"

#include <QObject>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>

namespace tp {

using MakeInput = std::function<std::unique_ptr<SoundInput>()>;

/// Recorder's other end: from a microphone to a file. Every call on the thread that it was moved to; most
/// write to the disk and may take long. Its time is that of the sound: it has no clock.
///
/// What was recorded is lost only by discard(). Destroyed meanwhile, it leaves the part to repair_folder().
class RecorderWorker final : public QObject {
    Q_OBJECT
public:
    /// The microphone is made at the first start.
    explicit RecorderWorker(MakeInput make_input, FreeBytes free = free_bytes);
    ~RecorderWorker() override;

    RecorderState state() const { return state_; }

    void start(const tp::RecordingPlan& plan);
    void pause();
    void go_on();
    void finish();
    void discard();

signals:
    void state_changed(tp::RecorderState state);
    void level_changed(double rms_dbfs, double peak_dbfs);
    /// Once for each second of sound, and at the start.
    void time_changed(double recorded_s, double left_s);
    void said(const QString& sentence);
    void done(const tp::FinishedRecording& recording);
    /// Nothing is being recorded; the sentence says why, and what became of what was.
    void failed(const QString& sentence);

private:
    void become(RecorderState state);
    void block(std::span<const std::int16_t> samples);
    void lost(SoundInput::Trouble trouble);
    void look_at_time();
    void finish_because(const QString& reason);
    double recorded_s() const;

    MakeInput make_input_;
    FreeBytes free_;
    std::unique_ptr<SoundInput> input_;
    RecorderState state_ = RecorderState::idle;
    RecordingPlan plan_;
    std::optional<WavPart> part_; ///< unless idle
    std::optional<LevelMeter> level_;
    std::optional<LoudnessMeter> loudness_;
    std::uint64_t next_look_ = 0; ///< frame at which look_at_time() is due
    bool told_silence_ = false;   ///< that the microphone hears nothing
    bool told_trouble_ = false;   ///< that it is gone, since it delivered something
    bool told_little_left_ = false;
};

} // namespace tp
