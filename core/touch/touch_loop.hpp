// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/friction/friction_finger.hpp"
#include "core/geometry/transform.hpp"
#include "core/servo/clock.hpp"
#include "core/servo/exit_guard.hpp"
#include "core/servo/handover.hpp"
#include "core/servo/snapshot.hpp"
#include "core/servo/timing_statistics.hpp"
#include "core/servo/velocity_filter.hpp"
#include "core/touch/tick_lead.hpp"
#include "core/touch/touch_output.hpp"
#include "core/touch/touch_scene.hpp"
#include "core/touch/touch_snapshot.hpp"

#include <atomic>
#include <memory>
#include <optional>
#include <thread>

namespace tp {

struct TouchSettings {
    static constexpr double longest_latency_s = 0.15;
    static constexpr double farthest_ahead_mm =
        10.0; ///< no finger is taken to be farther ahead of its last place

    Affine pad_to_surface;  ///< for an output that tells the place
    TickChoices choices;    ///< `strength` is that of friction, too
    double latency_s = 0.0; ///< from a call to what is felt; 0 … longest_latency_s
    double quiet_s = 0.100; ///< without a new place for so long a finger rests
};

/// Periods a second for an output that takes `rate` commands a second: 500 … 1000, so that a place waits 2 ms at most. What is
/// too much for the output its back end leaves out.
double touch_rate(double rate) noexcept;

/// Place → filter → ahead by the latency → law and events → friction and ticks, at a fixed rate.
///
/// One thread ticks (start() makes one; a test calls tick() itself in virtual time). Any one other thread hands over scenes,
/// tells places, chooses and engages. The ticking thread allocates nothing and locks nothing.
///
/// A finger that is lifted, that rests, or nobody who is engaged: nothing is felt. There is no watchdog, for what an output
/// makes ends by itself (TouchOutput).
class TouchLoop {
public:
    /// The output must be open; it and the clock must outlive the loop.
    TouchLoop(TouchOutput& output, const TouchCapabilities& can, Clock& clock, const TouchSettings& settings);
    /// Stops the thread, then the output.
    ~TouchLoop();
    TouchLoop(const TouchLoop&) = delete;
    TouchLoop& operator=(const TouchLoop&) = delete;

    /// `scene` is felt from the next period on; its number (TouchSnapshot::scene). With a tour the finger is led along it.
    /// nullptr: nothing is felt.
    std::uint64_t render(std::unique_ptr<const TouchScene> scene) { return scenes_.offer(std::move(scene)); }
    /// Where the finger is, mm, surface frame; for an output that is no pad.
    void tell(Vec2 place) noexcept;
    /// It was set down there: what lies between is not crossed.
    void tell_set_down(Vec2 place) noexcept;
    /// It is on the surface no more.
    void tell_lifted() noexcept;
    void engage() noexcept { wanted_engaged_.store(true); }
    void disengage() noexcept { wanted_engaged_.store(false); }
    void choose(const TickChoices& choices) noexcept { choices_.publish(choices); }
    /// Bounded as in TouchSettings; what is not a number is 0.
    void set_latency(double seconds) noexcept;
    /// One tick at the next period, whatever is under the finger, also where nobody is engaged.
    void feel(const Tick& tick) noexcept { asked_.publish({++asked_number_, tick}); }

    /// Ticks on a thread of its own until stop().
    void start();
    /// Ends the thread; nothing is felt and the output is stopped.
    void stop() noexcept;
    bool running() const { return thread_.joinable(); }

    /// One period; only from the ticking thread.
    void tick() noexcept;
    double period() const { return period_; }
    TouchSnapshot snapshot() const noexcept { return snapshot_.latest(); }
    /// How late periods began, and how long it took from a place to what was commanded for it. Any thread.
    const TimingStatistics& lateness() const noexcept { return lateness_; }
    const TimingStatistics& place_to_command() const noexcept { return place_to_command_; }

private:
    struct Told {
        std::uint64_t number = 0; ///< 0: nothing was told yet
        double time = 0.0;        ///< s
        bool touched = false;
        Vec2 place{0.0};
        std::uint64_t downs = 0; ///< counts tell_set_down
    };
    struct Asked {
        std::uint64_t number = 0;
        Tick tick;
    };
    void run() noexcept;
    bool take_place(double now) noexcept;
    void take_scene() noexcept;
    Vec2 ahead(Vec2 velocity) const noexcept;
    Tick tick_under(Vec2 place, Vec2 velocity, double dt) noexcept;
    void note(const Friction& friction) noexcept;
    void resist(double level) noexcept;
    void give(const Tick& tick, double now) noexcept;
    void switch_off() noexcept;

    TouchOutput& output_;
    ExitGuard guard_;
    Clock& clock_;
    const Affine pad_to_surface_;
    const double quiet_s_;
    const bool has_friction_;
    const bool is_pad_;
    const double period_;

    // Shared between the threads.
    Handover<TouchScene> scenes_;
    Published<Told> told_;
    Published<TickChoices> choices_;
    Published<Asked> asked_;
    std::atomic<double> latency_{0.0};
    std::atomic<bool> wanted_engaged_{false};
    std::atomic<bool> quit_{false};
    Published<TouchSnapshot> snapshot_;
    TimingStatistics lateness_;
    TimingStatistics place_to_command_;

    // Only the other thread.
    std::thread thread_;
    std::uint64_t asked_number_ = 0;
    Told last_told_;

    // Only the ticking thread.
    const Handover<TouchScene>::Held* current_ = nullptr;
    std::optional<FrictionFinger> finger_;
    std::optional<TickLead> lead_;
    VelocityFilter velocity_;
    Told place_; ///< the newest
    TouchSnapshot view_;
    double last_period_; ///< s, when it began
    std::uint64_t asked_done_ = 0;
    bool on_ = false; ///< something may be felt
};

} // namespace tp
