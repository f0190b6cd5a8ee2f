// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_replayer.hpp"

#include "app/pages/lab/lab_words.hpp"
#include "audio/sentences/sentences.hpp"

#include <QStringList>

#include <memory>
#include <span>
#include <stop_token>
#include <utility>

namespace tp {

LabReplayer::LabReplayer(const LabArchive& archive, LabActivity& activity, LabHand& hand,
                         LabMeasurements& measurements, Clock& clock, LabTeller& teller)
    : archive_(archive), activity_(activity), hand_(hand), measurements_(measurements), clock_(clock),
      teller_(teller) {}

void LabReplayer::replay(int index) {
    const QStringList names = archive_.recordings();
    if (index < 0 || index >= names.size())
        return;
    activity_.stop();
    const QString& name = names[index];
    teller_.say(tr("Reading %1.").arg(name));
    reading_.ask(
        [this, name, file = archive_.recording(name)](const std::stop_token& stop) -> LatestTask::Answer {
            auto read = std::make_shared<Result<LabReplay>>(read_replay(file, stop));
            return [this, name, read] {
                if (!read->ok())
                    teller_.say(in_persons_language(read->error()));
                else if (activity_.stopped())
                    play(std::move(*read).value(), name);
            };
        });
}

void LabReplayer::play(LabReplay replay, const QString& name) {
    if (replay.ticks.empty())
        return teller_.say(tr("%1 is empty.").arg(name));
    words_ = replay_words(replay);
    measurements_.begin(replay.rate, replay.delay_ticks);
    playback_.emplace(std::move(replay.ticks), clock_.now());
    activity_.become(LabActivity::Replaying);
    teller_.say(tr("Replaying %1. Escape ends it.").arg(name));
}

void LabReplayer::poll() {
    if (!playback_)
        return;
    const std::span<const TickSample> due = playback_->due(clock_.now());
    for (const TickSample& tick : due)
        measurements_.add(tick);
    if (!due.empty())
        hand_.replay(due.back().place, due.back().force);
    if (!playback_->over())
        return;
    playback_.reset();
    measurements_.renew();
    activity_.become(LabActivity::Stopped);
    teller_.say(tr("The replay has ended. %1").arg(words_));
}

void LabReplayer::end() {
    reading_.cancel();
    playback_.reset();
}

} // namespace tp
