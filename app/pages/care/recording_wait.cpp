// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/recording_wait.hpp"

#include <utility>

namespace tp {

RecordingWait::RecordingWait(Take& take, Listening& listening, CareTeller& teller)
    : take_(take), listening_(listening), teller_(teller) {
    connect(&take_, &Take::begins, &listening_, &Listening::stop);
    // Queued: the take has asked for its own step by then.
    connect(&take_, &Take::changed, this, &RecordingWait::go_on, Qt::QueuedConnection);
}

bool RecordingWait::stop() {
    const bool sounding = listening_.playing();
    const bool recording = take_.running();
    listening_.stop();
    take_.finish();
    return sounding || recording;
}

void RecordingWait::after(std::function<void()> step) {
    stop();
    if (take_.running())
        waiting_.push_back(std::move(step));
    else
        step();
}

void RecordingWait::go_on() {
    if (!take_.running())
        for (const auto& step : std::exchange(waiting_, {}))
            step();
}

bool RecordingWait::refused() {
    if (take_.running())
        teller_.problem(tr("A recording is being made. Finish it first."));
    return take_.running();
}

} // namespace tp
