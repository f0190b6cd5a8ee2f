// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/take.hpp"

#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/read_record.hpp"
#include "app/pages/care/care_words.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr double quietest_shown_dbfs = -60.0;

/// Lists the new recording; in place of another one it takes its place in the order, and the other goes to the trash.
std::string list_take(AlbumKeeper& keeper, const fs::path& photo, const std::string& file, const std::string& instead_of) {
    const auto listed = instead_of.empty() ? keeper.list_recording(photo, file)
                                           : keeper.list_recording(photo, file, instead_of);
    if (!listed || instead_of.empty())
        return listed.error();
    const auto record = read_record(photo);
    if (!record)
        return record.error();
    std::vector<Tag> ordered;
    for (const Tag& tag : record->tags)
        if (tag.order > 0)
            ordered.push_back(tag);
    std::stable_sort(ordered.begin(), ordered.end(), [](const Tag& a, const Tag& b) { return a.order < b.order; });
    std::vector<std::string> files;
    for (const Tag& tag : ordered) {
        files.push_back(tag.file);
        if (tag.file == instead_of)
            files.push_back(file);
    }
    if (std::find(files.begin(), files.end(), file) != files.end())
        if (std::string problem = keeper.order_recordings(photo, files); !problem.empty())
            return problem;
    return keeper.delete_recording(photo, instead_of);
}

} // namespace

Take::Take(CaredPhoto& photo, RecordingList& list, Recorder& recorder, CareTeller& teller,
           std::function<QString()> language)
    : photo_(photo), list_(list), recorder_(recorder), teller_(teller), language_(std::move(language)),
      take_(recorder) {
    connect(&recorder_, &Recorder::state_changed, this, [this] {
        if (!running())
            return;
        emit changed();
        emit levelChanged();
    });
    connect(&recorder_, &Recorder::time_changed, this, [this] {
        if (running())
            emit timeChanged();
    });
    connect(&recorder_, &Recorder::level_changed, this, [this] {
        if (running())
            emit levelChanged();
    });
    connect(&take_, &RecorderTake::heard, this, [this] { teller_.sound(Earcon::recording_started); });
    connect(&take_, &RecorderTake::said, this, [this](const QString& sentence) { teller_.tell(sentence); });
    connect(&take_, &RecorderTake::done, this, &Take::keep);
    connect(&take_, &RecorderTake::failed, this, [this](const QString& sentence) {
        become(State::None);
        teller_.problem(sentence);
    });
}

void Take::setKind(int kind) {
    if (kind == kind_ || kind < 0 || kind >= CareWords::kinds().size())
        return;
    kind_ = kind;
    emit changed();
}

QString Take::stateText() const {
    if (!running())
        return {};
    switch (recorder_.state()) {
    case RecorderState::recording:
        return tr("Recording");
    case RecorderState::paused:
        return tr("Paused");
    case RecorderState::finishing:
        return tr("Saving…");
    case RecorderState::idle:
    case RecorderState::waiting:
        break;
    }
    return tr("Waiting for the microphone…");
}

QString Take::time() const { return CareWords::clock(running() ? recorder_.recorded_s() : 0.0); }

double Take::level() const {
    const bool on = running() && recorder_.state() == RecorderState::recording;
    return on ? std::clamp(1.0 - recorder_.peak_dbfs() / quietest_shown_dbfs, 0.0, 1.0) : 0.0;
}

QString Take::levelText() const {
    const double shown = level();
    return shown <= 0.0 ? tr("nothing heard") : shown < 0.5 ? tr("soft") : shown < 0.95 ? tr("good") : tr("too loud");
}

void Take::start() {
    RecordingLabel label;
    label.kind = static_cast<RecordingKind>(kind_);
    label.language = language_().toStdString();
    begin(label, {});
}

void Take::startAgain() {
    const Tag* const old = list_.chosen_tag();
    if (old == nullptr)
        return;
    RecordingLabel label = old->label;
    label.transcript.clear(); // of other words
    label.recorded.clear();   // and of another time
    begin(label, old->file);
}

void Take::begin(const RecordingLabel& label, const std::string& instead_of) {
    if (!photo_.is_open() || running())
        return;
    if (!take_.can_begin())
        return teller_.problem(tr("The recorder is still busy. Try again in a moment."));
    if (photo_.may_move())
        return teller_.problem(tr("The album is still being changed. Try again in a moment."));
    emit begins();
    teller_.silence();
    place_ = photo_.place();
    instead_of_ = instead_of;
    RecordingPlan plan;
    plan.folder = tags_folder(place_.photo);
    plan.notes.label = label;
    take_.begin(plan);
    become(State::Running);
}

void Take::pauseOrGoOn() {
    if (state_ != State::Running)
        return;
    if (recorder_.state() == RecorderState::paused) {
        teller_.silence();
        recorder_.go_on();
    } else {
        recorder_.pause();
        teller_.answer(tr("Paused."));
    }
}

void Take::finish() { take_.finish(); }

void Take::askDiscard() {
    if (state_ != State::Running)
        return;
    recorder_.pause();
    become(State::Asking);
    teller_.tell(tr("Discard what was recorded? It cannot be brought back."));
}

void Take::discard() {
    if (!asking())
        return;
    take_.discard();
    become(State::None);
    teller_.did(Earcon::deleted, tr("Discarded. Nothing was changed."));
}

void Take::keepOn() {
    if (!asking())
        return;
    become(State::Running);
    teller_.answer(tr("Kept. The recording is paused."));
}

void Take::become(State state) {
    state_ = state;
    emit changed();
    emit timeChanged();
    emit levelChanged();
}

void Take::keep(const FinishedRecording& recording) {
    teller_.sound(Earcon::recording_stopped);
    const std::string file = recording.file.filename().string();
    become(State::None);
    photo_.change(
        place_,
        [file, instead_of = instead_of_](AlbumKeeper& keeper, const fs::path& photo) {
            return list_take(keeper, photo, file, instead_of);
        },
        [this, file, sentence = recording.sentence, place = place_](const QString& problem) {
            if (!problem.isEmpty()) {
                teller_.problem(problem);
                return;
            }
            list_.choose_file(place, file);
            teller_.did(Earcon::saved, tr("%1 Saved.").arg(sentence));
        });
}

} // namespace tp
