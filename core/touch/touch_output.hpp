// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/geometry/vec.hpp"
#include "core/servo/haltable.hpp"
#include "core/touch/tick.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace tp {

/// What a touch output can make a bare finger feel.
enum class TouchMeans {
    friction, ///< a surface that holds a moving finger back, as strongly as it is told
    ticks,    ///< short pushes under the finger
    rumble    ///< a motor that shakes the whole machine: it starts and stops slowly
};

struct TouchCapabilities {
    std::string name;          ///< as a person is told
    std::string serial_number; ///< keeps its choices; empty where it has none
    TouchMeans means = TouchMeans::ticks;
    double delay = 0.0; ///< s, estimate from a call to what is felt
    double rate =
        0.0; ///< commands a second that it takes; more are left out by the back end, the newest wins
    double shortest_s = 0.0; ///< of its ticks; a shorter one lasts as long
    /// Where the finger can be on a pad that tells its place, mm, x right, y up, origin in the middle; empty where the screen, the
    /// mouse or another device tells it.
    std::optional<Rect> pad;
};

/// One reading of a pad.
struct PadTouch {
    double time = 0.0;         ///< s, of the caller's clock, when the place was taken
    bool touched = false;      ///< a finger lies on it
    Vec2 place{0.0};           ///< mm, in the pad's frame; the last one where none lies on it
    std::uint32_t buttons = 0; ///< bit 0 = the main button
};

/// The port that every output for a bare finger implements. It can resist or tick; it can push nobody anywhere. Called by one
/// thread at a time, `halt` excepted. No call but open() and stop() may block for longer than a tick of the caller (a slow
/// transport keeps a writer thread of its own behind this port).
///
/// Whatever is felt ends by itself when nothing more comes: a tick after its duration, friction within `friction_lasts_s`. So it
/// is over, too, where the program has died.
class TouchOutput : public Haltable {
public:
    static constexpr double friction_lasts_s = 0.1;

    virtual ~TouchOutput() = default;
    /// Makes it ready; nothing is felt afterwards. The error is a sentence with what to do.
    virtual Result<TouchCapabilities> open() = 0;
    /// The newest reading of a pad at `now`; nothing where there is no newer one, or no pad.
    virtual std::optional<PadTouch> read(double /*now*/) noexcept { return std::nullopt; }
    /// From now on, for friction_lasts_s, this much friction: 0 … 1; what is not a number is 0. Nothing where it has only ticks.
    /// False where it could not be delivered.
    virtual bool resist(double level) noexcept = 0;
    /// One tick, in place of one that is under way. Nothing where it has only friction. False where it could not be delivered.
    virtual bool tick(const Tick& tick) noexcept = 0;
    /// Nothing is felt, at once; it stays open. Any thread, at any moment, and from a signal handler (signal-safety(7)).
    void halt() noexcept override = 0;
    /// Nothing is felt; released. May be called twice.
    virtual void stop() noexcept = 0;
    virtual bool lost() const noexcept { return false; }
    /// Why it does not do as it was told and what to do, for a person; empty where there is nothing to say. Any thread.
    virtual std::string complaint() const { return {}; }
};

} // namespace tp
