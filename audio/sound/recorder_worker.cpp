// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/recorder_worker.hpp"

#include "audio/recordings/recording_file.hpp"
#include "audio/sentences/sentences.hpp"
#include "audio/sound/sound_format.hpp"
#include "audio/sound/sound_words.hpp"
#include "core/files/durable_file.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

namespace tp {

namespace {

using State = RecorderState;

constexpr double little_left_s = 60.0;

QString words(SoundInput::Trouble trouble, bool begun) {
    const QString kept =
        ' ' + (begun ? RecorderWorker::tr("What was recorded is kept, and it goes on as soon as there is one.")
                     : RecorderWorker::tr("The recording begins as soon as there is one."));
    switch (trouble) {
    case SoundInput::Trouble::stalled:
        return RecorderWorker::tr("The microphone delivers no sound.") + kept;
    case SoundInput::Trouble::unfit:
        return RecorderWorker::tr(
                   "This microphone cannot record 48000 samples a second; another one is needed.") +
               kept;
    case SoundInput::Trouble::none_there:
        break;
    }
    return (begun ? RecorderWorker::tr("The microphone is gone.")
                  : RecorderWorker::tr("There is no microphone.")) +
           kept;
}

} // namespace

RecorderWorker::RecorderWorker(MakeInput make_input, FreeBytes free)
    : make_input_(std::move(make_input)), free_(std::move(free)) {}

RecorderWorker::~RecorderWorker() {
    if (part_)
        static_cast<void>(
            part_->sync()); // what cannot be brought to the disk now was said to be kept by nobody
}

void RecorderWorker::start(const RecordingPlan& plan) {
    if (state_ != State::idle)
        return;
    const auto free = free_(plan.folder);
    if (free && seconds_of_room(*free, 0) <= 0.0) {
        emit failed(tr("There is not enough room on the disk for a recording."));
        return;
    }
    Result<WavPart> part = start_recording(plan.folder, plan.notes, {sound_rate, 1});
    if (!part) {
        emit failed(tr("The recording cannot be made: %1").arg(in_persons_language(part.error())));
        return;
    }
    plan_ = plan;
    part_.emplace(std::move(part).value());
    level_.emplace(part_->format());
    loudness_.emplace(part_->format());
    next_look_ = 0;
    told_silence_ = told_trouble_ = told_little_left_ = false;
    if (input_ == nullptr) {
        input_ = make_input_();
        connect(input_.get(), &SoundInput::block, this, &RecorderWorker::block);
        connect(input_.get(), &SoundInput::lost, this, &RecorderWorker::lost);
        connect(input_.get(), &SoundInput::came, this, [this] {
            if (state_ == State::waiting)
                input_->start();
        });
    }
    become(State::waiting);
    look_at_time();
    if (state_ == State::waiting) // not over already
        input_->start();
}

void RecorderWorker::pause() {
    if (state_ != State::recording && state_ != State::waiting)
        return;
    input_->stop();
    become(State::paused);
}

void RecorderWorker::go_on() {
    if (state_ != State::paused)
        return;
    become(State::waiting);
    input_->start();
}

void RecorderWorker::finish() {
    if (part_)
        finish_because({});
}

void RecorderWorker::discard() {
    if (!part_)
        return;
    input_->stop();
    std::error_code ignored; // one that stays is found by repair_folder() and can be deleted there
    std::filesystem::remove(part_->place(), ignored);
    static_cast<void>(sync_folder(part_->place().parent_path()));
    part_.reset();
    become(State::idle);
}

void RecorderWorker::become(State state) {
    if (std::exchange(state_, state) != state)
        emit state_changed(state);
}

double RecorderWorker::recorded_s() const { return static_cast<double>(part_->frames()) / sound_rate; }

void RecorderWorker::block(std::span<const std::int16_t> samples) {
    if (state_ != State::recording && state_ != State::waiting)
        return;
    if (std::exchange(told_trouble_, false))
        emit said(part_->frames() > 0 ? tr("The microphone is there again. The recording goes on.")
                                      : tr("The recording begins."));
    become(State::recording);

    const auto longest = static_cast<std::uint64_t>(plan_.longest_s * sound_rate);
    const std::uint64_t room = longest - std::min(longest, part_->frames());
    const std::uint64_t before = part_->frames();
    const std::string reason = part_->append(samples.first(std::min<std::size_t>(samples.size(), room)));
    const std::span<const std::int16_t> kept = samples.first(part_->frames() - before);
    level_->add(kept);
    loudness_->add(kept);
    if (!reason.empty()) {
        finish_because(tr("The recording has ended, because %1").arg(in_persons_language(reason)));
        return;
    }
    emit level_changed(level_->level().rms_dbfs, level_->level().peak_dbfs);
    if (level_->hears_nothing() && !std::exchange(told_silence_, true))
        emit said(tr("The microphone picks up nothing. It may be switched off or covered."));
    if (part_->frames() >= next_look_ || kept.size() < samples.size())
        look_at_time();
}

void RecorderWorker::look_at_time() {
    next_look_ = (part_->frames() / sound_rate + 1) * sound_rate;
    const auto free = free_(plan_.folder);
    const double by_plan = plan_.longest_s - recorded_s();
    const double by_disk = free ? seconds_of_room(*free, part_->frames()) : by_plan;
    const double left = std::max(0.0, std::min(by_plan, by_disk));
    emit time_changed(recorded_s(), left);
    if (left <= 0.0)
        finish_because(
            by_disk < by_plan
                ? tr("The disk is almost full, so the recording has ended.")
                : tr("A recording lasts %1 at most, so it has ended.").arg(duration_words(plan_.longest_s)));
    else if (left <= little_left_s && plan_.longest_s > little_left_s &&
             !std::exchange(told_little_left_, true))
        emit said(by_disk < by_plan
                      ? tr("The disk is almost full: %1 can still be recorded.").arg(duration_words(left))
                      : tr("%1 can still be recorded.").arg(duration_words(left)));
}

void RecorderWorker::lost(SoundInput::Trouble trouble) {
    if (state_ != State::recording && state_ != State::waiting)
        return;
    become(State::waiting);
    if (const std::string reason = part_->sync(); !reason.empty()) {
        finish_because(tr("The recording has ended, because %1").arg(in_persons_language(reason)));
        return;
    }
    if (!std::exchange(told_trouble_, true))
        emit said(words(trouble, part_->frames() > 0));
}

/// `reason` empty: because it was asked for.
void RecorderWorker::finish_because(const QString& reason) {
    input_->stop();
    become(State::finishing);
    FinishedRecording result;
    result.duration_s = recorded_s();
    result.gain_db = loudness_->loudness().gain_db();
    const QString name = QString::fromStdString(part_->place().filename().string());
    const auto file = finish_recording(std::move(*part_), plan_.notes);
    part_.reset();
    become(State::idle);
    const QString begin = reason.isEmpty() ? QString() : reason + ' ';
    if (!file) {
        emit failed(begin + tr("What was recorded is kept as \"%1\" and will be saved later, because %2")
                                .arg(name, in_persons_language(file.error())));
    } else if (!*file) {
        emit failed(begin + tr("Nothing was recorded."));
    } else {
        result.file = **file;
        result.sentence = begin + tr("Recorded: %1.").arg(duration_words(result.duration_s));
        emit done(result);
    }
}

} // namespace tp
