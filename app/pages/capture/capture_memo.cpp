// SPDX-License-Identifier: Apache-2.0
#include "app/pages/capture/capture_memo.hpp"

#include "app/album/keeper/photo_files.hpp"

#include <string>

namespace tp {

CaptureMemo::CaptureMemo(CaptureAlbum& album, Recorder& recorder, CaptureTeller& teller)
    : album_(album), teller_(teller), take_(recorder) {
    connect(&take_, &RecorderTake::heard, this, [this] { teller_.sound(Earcon::recording_started); });
    connect(&take_, &RecorderTake::said, this, [this](const QString& sentence) { teller_.tell(sentence); });
    connect(&take_, &RecorderTake::done, this, &CaptureMemo::keep);
    connect(&take_, &RecorderTake::failed, this, [this](const QString& sentence) {
        emit changed();
        teller_.problem(sentence);
    });
}

void CaptureMemo::start(const std::filesystem::path& photo, const QString& language) {
    if (!take_.can_begin())
        return teller_.problem(tr("The recorder is still busy. Try again in a moment."));
    teller_.silence(); // the microphone listens
    photo_ = photo;
    RecordingPlan plan;
    plan.folder = tags_folder(photo);
    plan.notes.label.kind = RecordingKind::memo;
    plan.notes.label.language = language.toStdString();
    take_.begin(plan);
    emit changed();
}

void CaptureMemo::keep(const FinishedRecording& recording) {
    emit changed();
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
