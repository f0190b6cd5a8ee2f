// SPDX-License-Identifier: Apache-2.0
#include "app/pages/capture/capture_memo.hpp"

#include "app/album/keeper/photo_files.hpp"

#include <string>
#include <utility>

namespace tp {

CaptureMemo::CaptureMemo(CaptureAlbum& album, Recorder& recorder, CaptureTeller& teller)
    : album_(album), recorder_(recorder), teller_(teller) {
    connect(&recorder_, &Recorder::state_changed, this, [this] {
        if (running_ && recorder_.state() == RecorderState::recording && !std::exchange(heard_, true))
            teller_.sound(Earcon::recording_started);
    });
    connect(&recorder_, &Recorder::said, this, [this](const QString& sentence) {
        if (running_)
            teller_.tell(sentence);
    });
    connect(&recorder_, &Recorder::done, this, [this](const FinishedRecording& recording) {
        if (running_)
            keep(recording);
    });
    connect(&recorder_, &Recorder::failed, this, [this](const QString& sentence) {
        if (!running_)
            return;
        end();
        teller_.problem(sentence);
    });
}

void CaptureMemo::start(const std::filesystem::path& photo, const QString& language) {
    if (running_ || recorder_.state() != RecorderState::idle)
        return teller_.problem(tr("The recorder is still busy. Try again in a moment."));
    teller_.silence(); // the microphone listens
    running_ = true;
    heard_ = finishing_ = false;
    photo_ = photo;
    RecordingPlan plan;
    plan.folder = tags_folder(photo);
    plan.notes.label.kind = RecordingKind::memo;
    plan.notes.label.language = language.toStdString();
    recorder_.start(plan);
    emit changed();
}

bool CaptureMemo::finish() {
    if (!running_ || std::exchange(finishing_, true))
        return false;
    recorder_.finish();
    return true;
}

void CaptureMemo::end() {
    running_ = false;
    emit changed();
}

void CaptureMemo::keep(const FinishedRecording& recording) {
    end();
    teller_.sound(Earcon::recording_stopped);
    album_.run(
        [photo = photo_, file = recording.file.filename().string()](AlbumKeeper& keeper, PhotographStore&) {
            return keeper.list_recording(photo, file).error();
        },
        [this, photo = photo_, sentence = recording.sentence](const QString& problem) {
            if (!problem.isEmpty())
                return teller_.problem(problem);
            emit touched(photo);
            teller_.did(Earcon::saved, tr("%1 Saved.").arg(sentence));
        });
}

} // namespace tp
