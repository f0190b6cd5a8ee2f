// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/filling_worker.hpp"

#include "audio/sentences/sentences.hpp"

#include <utility>

namespace tp {

namespace {
constexpr int refill_ms = 100; // of a buffer of 2 s
} // namespace

FillingWorker::FillingWorker() : refill_(this) {
    refill_.setInterval(refill_ms);
    connect(&refill_, &QTimer::timeout, this, &FillingWorker::refill);
}

void FillingWorker::begin(quint64 run, std::shared_ptr<PlaybackStream> stream) {
    leave();
    if (const std::string sentence = stream->open(); !sentence.empty()) {
        emit unreadable(run, in_persons_language(sentence));
        return;
    }
    stream_ = std::move(stream);
    refill_.start();
    refill();
    emit ready(run);
}

void FillingWorker::leave() {
    refill_.stop();
    stream_.reset();
}

void FillingWorker::refill() {
    if (!stream_->fill())
        leave();
}

} // namespace tp
