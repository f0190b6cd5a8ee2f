// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/trimming.hpp"

#include "app/album/keeper/photo_files.hpp"
#include "app/pages/care/care_words.hpp"

#include <algorithm>
#include <cmath>

namespace tp {

namespace fs = std::filesystem;

namespace {
constexpr std::size_t drawn_parts = 400;
} // namespace

Trimming::Trimming(CaredPhoto& photo, RecordingList& list, Listening& listening, CareTeller& teller)
    : photo_(photo), list_(list), listening_(listening), teller_(teller) {
    connect(&list_, &RecordingList::chosenChanged, this, &Trimming::begin_anew);
    connect(&listening_, &Listening::changed, this, &Trimming::playingChanged);
    connect(&listening_, &Listening::moved, this, &Trimming::positionChanged);
}

fs::path Trimming::file() const {
    const Tag* const tag = list_.chosen_tag();
    return tag == nullptr ? fs::path() : tags_folder(photo_.place().photo) / tag->file;
}

void Trimming::begin_anew() {
    listening_.stop();
    const Tag* const tag = list_.chosen_tag();
    duration_s_ = end_s_ = tag == nullptr ? 0.0 : tag->duration_s;
    begin_s_ = 0.0;
    peaks_.clear();
    drawing_.cancel();
    if (tag != nullptr)
        draw(file());
    emit changed();
    emit drawn();
}

void Trimming::draw(const fs::path& sound) {
    drawing_.ask([this, sound](const std::stop_token& stop) -> LatestTask::Answer {
        const Result<SoundPeaks> result = sound_peaks(sound, drawn_parts, stop);
        if (!result)
            return {}; // a sound that cannot be read is told when it is played
        return [this, peaks = QList<float>(result->peaks.begin(), result->peaks.end())] {
            peaks_ = peaks;
            emit drawn();
        };
    });
}

QString Trimming::beginText() const { return CareWords::seconds(begin_s_); }

QString Trimming::endText() const { return CareWords::seconds(end_s_); }

QString Trimming::staysText() const {
    return cuts() ? tr("%1 of %2 stay.").arg(CareWords::seconds(end_s_ - begin_s_), CareWords::seconds(duration_s_))
                  : tr("All of it stays.");
}

void Trimming::setBegin(double seconds) {
    const double to = std::clamp(seconds, 0.0, std::max(0.0, end_s_ - shortest_s));
    if (to == begin_s_)
        return;
    begin_s_ = to;
    emit changed();
    teller_.answer(tr("From %1").arg(beginText()));
}

void Trimming::setEnd(double seconds) {
    const double to = std::clamp(seconds, std::min(duration_s_, begin_s_ + shortest_s), duration_s_);
    if (to == end_s_)
        return;
    end_s_ = to;
    emit changed();
    teller_.answer(tr("To %1").arg(endText()));
}

void Trimming::whole() {
    if (cuts()) {
        begin_s_ = 0.0;
        end_s_ = duration_s_;
        emit changed();
    }
    teller_.answer(staysText());
}

void Trimming::playOrStop() {
    if (listening_.playing())
        listening_.stop();
    else if (const Tag* const tag = list_.chosen_tag())
        listening_.play(file(), *tag);
}

void Trimming::playPartOrStop() {
    if (listening_.playing())
        listening_.stop();
    else if (const Tag* const tag = list_.chosen_tag())
        listening_.play(file(), *tag, begin_s_, end_s_);
}

void Trimming::cut() {
    const Tag* const tag = list_.chosen_tag();
    if (tag == nullptr)
        return;
    if (!cuts()) {
        teller_.problem(
            tr("All of it stays, so there is nothing to cut off. Move the start or the end first."));
        return;
    }
    listening_.stop();
    const PhotoPlace place = photo_.place();
    const auto part = std::make_shared<Tag>();
    photo_.change(
        place,
        [file = tag->file, begin = begin_s_, end = end_s_, part](AlbumKeeper& keeper, const fs::path& photo) {
            auto trimmed = keeper.trim_recording(photo, file, begin, end);
            if (trimmed)
                *part = *trimmed;
            return trimmed.error();
        },
        [this, place, part](const QString& problem) {
            if (!problem.isEmpty()) {
                teller_.problem(problem);
                return;
            }
            list_.choose_file(place, part->file);
            teller_.did(Earcon::saved, tr("Trimmed: %1 stay. Undo brings the rest back.")
                                           .arg(CareWords::seconds(part->duration_s)));
        });
}

} // namespace tp
