// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/lab/tick_tap.hpp"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace tp {

/// The ticks of a recording, given back at the pace at which they were made.
class LabPlayback {
public:
    /// `ticks`: at least one. It begins at `now`, s.
    LabPlayback(std::vector<TickSample> ticks, double now) : ticks_(std::move(ticks)), begun_(now) {}

    /// Those that have come since the last call.
    std::span<const TickSample> due(double now) {
        const std::size_t from = next_;
        while (!over() && ticks_[next_].time - ticks_.front().time <= now - begun_)
            ++next_;
        return std::span(ticks_).subspan(from, next_ - from);
    }
    bool over() const { return next_ == ticks_.size(); }

private:
    std::vector<TickSample> ticks_;
    std::size_t next_ = 0;
    double begun_;
};

} // namespace tp
