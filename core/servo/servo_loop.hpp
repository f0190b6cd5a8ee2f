// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/transform.hpp"
#include "core/guidance/branch_hold.hpp"
#include "core/guidance/guided_tour.hpp"
#include "core/guidance/haptic_scene.hpp"
#include "core/servo/clock.hpp"
#include "core/servo/energy_observer.hpp"
#include "core/servo/exit_guard.hpp"
#include "core/servo/far_look.hpp"
#include "core/servo/force_device.hpp"
#include "core/servo/fresh_readings.hpp"
#include "core/servo/handover.hpp"
#include "core/servo/safety_chain.hpp"
#include "core/servo/snapshot.hpp"
#include "core/servo/timing_statistics.hpp"
#include "core/servo/velocity_filter.hpp"
#include "core/servo/velocity_forecast.hpp"
#include "core/servo/watchdog.hpp"

#include <atomic>
#include <memory>
#include <optional>
#include <thread>

namespace tp {

struct ServoSettings {
    double rate = 1000.0; ///< Hz
    SafetyLimits limits;
    Affine device_to_surface; ///< the calibration
    /// Damping across a contour, within its range d. What sampling and delay leak beyond the device's own damping, about
    /// 1.25 K (T/2 + nT) − b, so that none is added to a device that needs none; of a device that tells of no damping
    /// 4 ms more delay are reckoned. And for swings slower than `settling_speed` 2ζ√(mK)·(1 − r/d) more, with ζ this
    /// ratio, so that a released handle comes to rest; above that speed this part stays as large as at it, so that a
    /// finger that follows a line feels the line. 0: off.
    double line_damping_ratio = 0.1;
    double settling_speed = 20.0; ///< mm/s
    double handle_mass = 0.1;     ///< m, kg, what the damping reckons with
    bool energy_observer = true; ///< pays back what sampling and delay give the hand beyond the potential
    double scene_fade = 0.080;   ///< s over which a new scene's force replaces the old one's
};

/// Read → filter → calibrate → law → damping → safety chain → watchdog → write, at a fixed rate.
///
/// One thread ticks (start() makes one, and a second one for the watchdog; a test or a trace calls tick()
/// itself in virtual time). Any one other thread hands over scenes and engages. The ticking thread allocates
/// nothing and locks nothing: a scene is handed over by an atomic swap and freed by the thread that handed it
/// over, once the servo has left it.
class ServoLoop {
public:
    /// The device must be open; it and the clock must outlive the loop.
    ServoLoop(ForceDevice& device, const Capabilities& capabilities, Clock& clock, ServoSettings settings);
    /// Stops the thread, then the device.
    ~ServoLoop();
    ServoLoop(const ServoLoop&) = delete;
    ServoLoop& operator=(const ServoLoop&) = delete;

    /// Renders `scene` from the next tick on, fading over; returns its number (see ServoSnapshot::scene).
    /// A scene with a tour leads the finger from there on. nullptr: nothing is rendered.
    std::uint64_t render(std::unique_ptr<const HapticScene> scene);
    void engage() { wanted_engaged_.store(true); }
    void disengage() { wanted_engaged_.store(false); }
    /// The user's own limit, N.
    void set_max_force(double newtons) { max_force_.store(newtons); }

    /// Ticks on a thread of its own until stop(). Where the device can be written to after its own stop, it may
    /// be started again, and lets the force in by a ramp as at first: the scene and who wants the force are kept.
    void start();
    /// Ends the threads; zero force is written and the device stopped. Nothing wakes up after it. A fault that
    /// disables stays until a person engages again.
    void stop() noexcept;
    bool running() const { return thread_.joinable(); }

    /// One period; only from the ticking thread.
    void tick() noexcept;
    /// The watchdog's period; start() calls it from a thread of its own.
    void check() noexcept { watchdog_.check(clock_.now()); }
    ServoSnapshot snapshot() const noexcept { return snapshot_.latest(); }

    /// How late ticks began, how long they took, how many periods had no tick, and whether the system gave
    /// the thread real-time priority and let what it touches be locked in memory. Of the thread that start()
    /// makes; readable at any moment.
    const TimingStatistics& lateness() const noexcept { return lateness_; }
    const TimingStatistics& compute() const noexcept { return compute_; }
    std::uint64_t missed_periods() const noexcept { return missed_periods_.load(std::memory_order_relaxed); }
    bool real_time() const noexcept { return real_time_.load(std::memory_order_relaxed); }
    bool memory_locked() const noexcept { return memory_locked_.load(std::memory_order_relaxed); }

private:
    void run() noexcept;
    void watch() noexcept;
    void forget_force() noexcept;
    void take_new_scene(Vec2 finger) noexcept;
    Guidance wanted(Vec2 finger, double dt) noexcept;
    double stiffness() const noexcept;
    Vec2 velocity_ahead() const noexcept;
    Vec2 damping(const Guidance& guidance, Vec2 finger) const noexcept;
    Vec2 paid_back(const Guidance& guidance, Vec2 finger, double dt) noexcept;

    ForceDevice& device_;
    ExitGuard guard_;
    Clock& clock_;
    ServoSettings settings_;
    double period_;
    double stretch_;        ///< largest factor from the device's to the surface's millimetres
    double lag_;            ///< s by which a force is late on average: half a period and the device's delay
    double device_damping_; ///< N·s/m, surface frame
    double most_damping_;   ///< N·s/m; more would come too late to damp

    // Shared between the threads.
    Handover<HapticScene> scenes_;
    std::atomic<bool> wanted_engaged_{false};
    std::atomic<bool> quit_{false};
    std::atomic<double> max_force_;
    Published<ServoSnapshot> snapshot_;
    Watchdog watchdog_;
    TimingStatistics lateness_;
    TimingStatistics compute_;
    std::atomic<std::uint64_t> missed_periods_{0};
    std::atomic<bool> real_time_{false};
    std::atomic<bool> memory_locked_{false};

    // Only the thread that hands over scenes.
    std::thread thread_;
    std::thread watch_thread_;

    // Only the ticking thread.
    SafetyChain chain_;
    FreshReadings readings_;
    VelocityFilter velocity_;
    VelocityForecast forecast_;
    EnergyObserver observer_;
    std::optional<DeviceState> state_;
    double reference_ = 0.0; ///< mJ, what the observer holds the force against; only its differences count
    double last_energy_ = 0.0;
    Vec2 last_felt_{0.0};
    Vec2 last_finger_{0.0};
    bool was_cut_ = false;
    const Handover<HapticScene>::Held* current_ = nullptr;
    FarLook far_look_;
    std::optional<GuidedTour> tour_;
    std::optional<BranchHold> hold_;
    Vec2 fade_from_{0.0}; ///< N, the force that was rendered when the scene changed
    double fade_left_ = 0.0;
    Vec2 rendered_{0.0}; ///< N, surface frame, before the chain
    double last_tick_ = 0.0;
    std::uint64_t ticks_ = 0;
    bool engaged_before_ = false;
};

} // namespace tp
