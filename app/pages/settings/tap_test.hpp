// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

namespace tp {

/// How late an output's ticks are felt, from a person who taps a key at each: the median of what passes from a tick that is sent
/// to its tap, less what people usually take to react to a touch. It measures the person, too: somebody who reacts 50 ms faster
/// or more slowly than most gets a latency that is 50 ms off, and it tells no more than a few hundredths of a second.
class TapTest {
public:
    static constexpr int ticks = 7;            ///< of a whole test
    static constexpr int fewest_taps = 4;      ///< with less there is no result
    static constexpr double reaction_s = 0.18; ///< to a touch; commonly given as 0.15 … 0.2 s
    static constexpr double soonest_s = 0.1;   ///< who taps sooner has guessed
    static constexpr double latest_s = 0.8;    ///< … later has missed the tick
    static constexpr double longest_latency_s = 0.15;

    /// Pause before the tick of that number, s; uneven, so that nobody taps in time with them.
    static double pause_before(int tick);
    void ticked(double time) { tick_ = time; }
    /// The first tap after each tick counts.
    void tapped(double time);
    /// s, 0 … longest_latency_s; nothing where too few taps count.
    std::optional<double> latency() const;

private:
    std::optional<double> tick_; ///< s, whose tap is awaited
    std::vector<double> delays_; ///< s
};

} // namespace tp
