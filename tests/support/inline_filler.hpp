// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/sound/stream_filler.hpp"

#include <memory>
#include <utility>

namespace tp::testing {

/// Fills where it is called, so that a test's time stands still meanwhile.
class InlineFiller final : public StreamFiller {
public:
    bool asleep = false; ///< the disk does not answer

    void begin(quint64 run, std::shared_ptr<PlaybackStream> stream) override {
        run_ = run;
        stream_ = std::move(stream);
        opened_ = false;
        fill();
    }
    void leave() override { stream_.reset(); }

    void fill() {
        if (stream_ == nullptr || asleep)
            return;
        if (!std::exchange(opened_, true)) {
            if (const std::string sentence = stream_->open(); !sentence.empty()) {
                stream_.reset();
                emit unreadable(run_, QString::fromStdString(sentence));
                return;
            }
            stream_->fill();
            emit ready(run_);
        } else {
            stream_->fill();
        }
    }

private:
    quint64 run_ = 0;
    std::shared_ptr<PlaybackStream> stream_;
    bool opened_ = false;
};

} // namespace tp::testing
