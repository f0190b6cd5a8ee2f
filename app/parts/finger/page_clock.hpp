// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>

#include <functional>
#include <utility>

namespace tp {

/// The page's time in seconds: real since the clock was made, or what a test says.
class PageClock {
public:
    /// `now`: seconds; empty: real time.
    explicit PageClock(std::function<double()> now = {}) : now_(std::move(now)) { since_.start(); }

    double operator()() const { return now_ ? now_() : 1e-9 * static_cast<double>(since_.nsecsElapsed()); }

private:
    std::function<double()> now_;
    QElapsedTimer since_;
};

} // namespace tp
