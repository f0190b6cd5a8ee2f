// SPDX-License-Identifier: Apache-2.0
#include "app/pages/capture/capture_moment.hpp"

#include "app/album/keeper/photo_files.hpp"

#include <string>
#include <system_error>
#include <utility>

namespace tp {

CaptureMoment::CaptureMoment(CaptureAlbum& album, CaptureChoices& choices, MomentRecorder& recorder,
                             CaptureTeller& teller)
    : album_(album), choices_(choices), recorder_(recorder), teller_(teller) {
    connect(&choices_, &CaptureChoices::changed, this, &CaptureMoment::follow_choice);
    connect(&recorder_, &MomentRecorder::hears_changed, this, &CaptureMoment::changed);
    connect(&recorder_, &MomentRecorder::kept, this, &CaptureMoment::list);
    connect(&recorder_, &MomentRecorder::failed, this, [this](quint64 number, const QString& sentence) {
        if (kept_.erase(number) == 0)
            return;
        teller_.problem(sentence);
        emit changed();
    });
}

void CaptureMoment::begin() {
    begun_ = true;
    follow_choice();
}

void CaptureMoment::end() {
    begun_ = false;
    follow_choice();
}

void CaptureMoment::follow_choice() {
    const bool wanted = begun_ && choices_.moment();
    if (std::exchange(listens_, wanted) == wanted)
        return;
    if (wanted)
        recorder_.listen();
    else
        recorder_.rest();
}

void CaptureMoment::shutter() {
    number_ = listens_ ? recorder_.shutter() : 0;
    acted_ = QDateTime::currentDateTime();
}

void CaptureMoment::keep(const std::filesystem::path& photo) {
    if (number_ == 0)
        return;
    kept_[number_] = photo;
    recorder_.keep(std::exchange(number_, 0), tags_folder(photo), acted_);
}

void CaptureMoment::drop() {
    if (number_ != 0)
        recorder_.drop(std::exchange(number_, 0));
}

void CaptureMoment::list(quint64 number, const FinishedRecording& recording) {
    const auto found = kept_.find(number);
    if (found == kept_.end())
        return;
    const std::filesystem::path photo = found->second;
    kept_.erase(found);
    album_.run(
        [photo, sound = recording.file](AlbumKeeper&, PhotographStore& store) {
            std::error_code error;
            if (!std::filesystem::exists(photo, error)) // deleted again meanwhile
                return std::string();
            return store.add_moment(photo, sound).error();
        },
        [this, photo](const QString& problem) {
            if (!problem.isEmpty())
                return teller_.problem(problem);
            emit touched(photo);
        });
}

} // namespace tp
