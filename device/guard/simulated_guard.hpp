// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/guard/force_guard.hpp"

#include <deque>

namespace tp {

/// What a simulated guard answers, and what it was told.
struct GuardDiary {
    ForceGuard::Word word = ForceGuard::Word::here; ///< to each sign of life
    std::deque<ForceGuard::Word> before_that;       ///< to the next ones, each once
    bool pulls = false;
    int beats = 0;
    int dismissals = 0;
    int ends = 0; ///< of guards that were there
};

/// A guard of a simulated device, which takes no force away. The diary must outlive it.
class SimulatedGuard final : public ForceGuard {
public:
    explicit SimulatedGuard(GuardDiary& diary) : diary_(diary) {}
    ~SimulatedGuard() override { ++diary_.ends; }
    Word beat(bool pulls) noexcept override {
        diary_.pulls = pulls;
        ++diary_.beats;
        if (diary_.before_that.empty())
            return diary_.word;
        const Word word = diary_.before_that.front();
        diary_.before_that.pop_front();
        return word;
    }
    void dismiss() noexcept override { ++diary_.dismissals; }

private:
    GuardDiary& diary_;
};

} // namespace tp
