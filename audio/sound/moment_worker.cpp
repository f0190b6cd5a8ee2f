// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/moment_worker.hpp"

#include "audio/recordings/loudness.hpp"
#include "audio/recordings/recording_file.hpp"
#include "audio/sentences/sentences.hpp"
#include "audio/sound/sound_format.hpp"
#include "audio/sound/sound_words.hpp"

#include <algorithm>
#include <iterator>
#include <list>
#include <string>
#include <utility>

namespace tp {

namespace {

constexpr std::size_t frames_in(double seconds) { return static_cast<std::size_t>(seconds * sound_rate); }

} // namespace

MomentWorker::MomentWorker(MakeInput make_input, FreeBytes free)
    : make_input_(std::move(make_input)), free_(std::move(free)), past_(frames_in(moment_before_s)) {}

MomentWorker::~MomentWorker() {
    for (Open& open : open_)
        if (open.part)
            static_cast<void>(open.part->sync()); // as the recorder leaves it
}

void MomentWorker::listen() {
    if (std::exchange(listens_, true))
        return;
    if (input_ == nullptr) {
        input_ = make_input_();
        connect(input_.get(), &SoundInput::block, this, &MomentWorker::block);
        connect(input_.get(), &SoundInput::lost, this, &MomentWorker::lose);
        connect(input_.get(), &SoundInput::came, this, [this] {
            if (listens_)
                input_->start();
        });
    }
    input_->start();
}

void MomentWorker::rest() {
    if (!std::exchange(listens_, false))
        return;
    input_->stop();
    lose();
}

/// What comes later is no part of what was.
void MomentWorker::lose() {
    hears(false);
    past_.forget();
    for (Open& open : open_)
        open.to_come = 0;
    finish_complete();
}

void MomentWorker::hears(bool hears) {
    if (std::exchange(hears_, hears) != hears)
        emit hearing_changed(hears);
}

void MomentWorker::shutter(quint64 number) {
    Open open;
    open.number = number;
    open.heard = past_.all();
    open.before_s = static_cast<double>(open.heard.size()) / sound_rate;
    open.to_come = hears_ ? frames_in(moment_after_s) : 0;
    open_.push_back(std::move(open));
    const auto unwanted = [](const Open& one) { return !one.part; };
    if (static_cast<std::size_t>(std::count_if(open_.begin(), open_.end(), unwanted)) > most_open)
        open_.erase(std::find_if(open_.begin(), open_.end(), unwanted));
}

void MomentWorker::drop(quint64 number) {
    std::erase_if(open_, [number](const Open& one) { return one.number == number && !one.part; });
}

void MomentWorker::keep(quint64 number, const std::filesystem::path& folder, const QDateTime& shutter) {
    const auto open = std::find_if(open_.begin(), open_.end(),
                                   [number](const Open& one) { return one.number == number && !one.part; });
    if (open == open_.end())
        return;
    QString problem;
    const auto free = free_(folder);
    if (open->heard.empty() && open->to_come == 0)
        problem = RecorderWorker::tr("Nothing was recorded.");
    else if (free && seconds_of_room(*free, 0) < moment_before_s + moment_after_s)
        problem = RecorderWorker::tr("There is not enough room on the disk for a recording.");
    if (problem.isEmpty()) {
        open->notes.label.kind = RecordingKind::ambient;
        open->notes.label.recorded = time_text(shutter.addMSecs(-static_cast<qint64>(1e3 * open->before_s)));
        auto part = start_recording(folder, open->notes, {sound_rate, 1});
        if (part)
            open->part.emplace(std::move(part).value());
        else
            problem =
                RecorderWorker::tr("The recording cannot be made: %1").arg(in_persons_language(part.error()));
    }
    if (!problem.isEmpty()) {
        open_.erase(open);
        emit failed(number, problem);
        return;
    }
    write(*open);
    finish_complete();
}

void MomentWorker::block(std::span<const std::int16_t> samples) {
    if (!listens_)
        return;
    hears(true);
    for (Open& open : open_) {
        const auto wanted = samples.first(std::min(samples.size(), open.to_come));
        open.heard.insert(open.heard.end(), wanted.begin(), wanted.end());
        open.to_come -= wanted.size();
        if (open.part)
            write(open);
    }
    past_.add(samples);
    finish_complete();
}

void MomentWorker::write(Open& open) {
    open.broken = open.part->append(open.heard);
    open.heard.clear();
    if (!open.broken.empty())
        open.to_come = 0;
}

/// Those that are to be kept and of which nothing more comes. Taken out first: whoever is told may ask for the next one.
void MomentWorker::finish_complete() {
    std::list<Open> over;
    for (auto open = open_.begin(); open != open_.end();) {
        const auto next = std::next(open);
        if (open->part && open->to_come == 0)
            over.splice(over.end(), open_, open);
        open = next;
    }
    for (Open& open : over)
        finish(open);
}

void MomentWorker::finish(Open& open) {
    FinishedRecording result;
    result.duration_s = static_cast<double>(open.part->frames()) / sound_rate;
    const QString name = QString::fromStdString(open.part->place().filename().string());
    const auto file = finish_recording(std::move(*open.part), open.notes);
    if (!file) {
        emit failed(
            open.number,
            RecorderWorker::tr("What was recorded is kept as \"%1\" and will be saved later, because %2")
                .arg(name, in_persons_language(file.error())));
    } else if (!*file) {
        emit failed(open.number, RecorderWorker::tr("Nothing was recorded."));
    } else {
        result.file = **file;
        if (const auto loudness = loudness_of(result.file))
            result.gain_db = loudness->gain_db();
        const QString begin = open.broken.empty() ? QString()
                                                  : RecorderWorker::tr("The recording has ended, because %1")
                                                            .arg(in_persons_language(open.broken)) +
                                                        ' ';
        result.sentence = begin + RecorderWorker::tr("Recorded: %1.").arg(duration_words(result.duration_s));
        emit kept(open.number, result);
    }
}

} // namespace tp
