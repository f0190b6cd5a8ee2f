// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/recording_notes.hpp"
#include "audio/recordings/wav_part.hpp"
#include "audio/sound/past_sound.hpp"
#include "audio/sound/recorder_types.hpp"
#include "audio/sound/recorder_worker.hpp"
#include "audio/sound/recording_room.hpp"
#include "audio/sound/sound_input.hpp"

#include <QDateTime>
#include <QObject>
#include <QString>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tp {

inline constexpr double moment_before_s = 5.0; ///< of sound before the shutter
inline constexpr double moment_after_s = 5.0;  ///< and after it

/// MomentRecorder's other end: listens, and keeps the sound round a shutter. Every call on the thread that it was moved to. Its time is
/// that of the sound: it has no clock.
///
/// What is heard stays in memory, and is forgotten, until a shutter's moment is kept. From then on it is as durable as a
/// recording: the part on the disk holds all that was heard so far, is synced each second, and becomes a FLAC at the end.
/// Destroyed meanwhile, it leaves the part to repair_folder().
class MomentWorker final : public QObject {
    Q_OBJECT
public:
    /// Moments that nobody has kept or dropped yet; of more, the oldest are dropped.
    static constexpr std::size_t most_open = 8;

    /// The microphone is made at the first call of `listen`.
    explicit MomentWorker(MakeInput make_input, FreeBytes free = free_bytes);
    ~MomentWorker() override;

    void listen();
    /// The microphone is off; what is being kept ends here, and what was heard is forgotten.
    void rest();
    /// The shutter acts now. Nothing is written; `keep` or `drop` of that number follows.
    void shutter(quint64 number);
    /// Keeps it among a photograph's recordings, as an ambient one; `kept` follows when it is over, or `failed`.
    void keep(quint64 number, const std::filesystem::path& folder, const QDateTime& shutter);
    void drop(quint64 number);

signals:
    /// Sound comes in from now on, or no more.
    void hearing_changed(bool hears);
    void kept(quint64 number, const tp::FinishedRecording& recording);
    /// Nothing was kept; the sentence says why, and what becomes of what was.
    void failed(quint64 number, const QString& sentence);

private:
    struct Open {
        quint64 number = 0;
        std::vector<std::int16_t> heard; ///< not written yet
        double before_s = 0.0;
        std::size_t to_come = 0; ///< samples
        std::optional<WavPart> part;
        RecordingNotes notes;
        std::string broken; ///< why nothing more could be written
    };

    void block(std::span<const std::int16_t> samples);
    void lose();
    void hears(bool hears);
    void write(Open& open);
    void finish_complete();
    void finish(Open& open);

    MakeInput make_input_;
    FreeBytes free_;
    std::unique_ptr<SoundInput> input_;
    bool listens_ = false;
    bool hears_ = false;
    PastSound past_;
    std::list<Open> open_;
};

} // namespace tp
