// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/force_device.hpp"
#include "core/servo/snapshot.hpp"
#include "device/simulated/plant_motion.hpp"

#include <array>
#include <atomic>
#include <optional>
#include <random>

namespace tp {

/// The finger that the simulated device moves, and the hand that holds it.
struct SimulatedPlant {
    double mass = 0.1;            ///< kg
    double damping = 0.3;         ///< N·s/m, of the device itself
    double coulomb = 0.0;         ///< N, dry friction
    double hand_stiffness = 0.12; ///< N/mm between pointer and finger: a light grip
    double hand_damping = 5.0;    ///< N·s/m, of the hand
    double relaxed_follow = 0.15; ///< s in which a relaxed hand's anchor follows the finger
    double quantum = 0.0;         ///< mm, encoder step; 0: none
    std::size_t delay_ticks = 0;  ///< whole ticks between a write and its acting, at most 16
    double tick = 0.001;          ///< s, for telling the delay in seconds
    std::size_t jitter_ticks = 0; ///< each write acts up to so many ticks later yet, at random
    std::optional<std::size_t> told_delay_ticks; ///< what it tells of its delay; nothing: the truth
    std::optional<double> told_damping;          ///< N·s/m, what it tells of its damping; nothing: the truth
};

/// A force device made of the mouse or the finger on a touchscreen: the drawn finger is a body with mass and
/// damping, tied to the pointer by a spring, so that the pull of a contour can be seen.
///
/// The pointer may be moved from any one thread while the servo ticks on another. Time is the servo's clock,
/// so that in simulated time everything is reproducible.
class SimulatedDevice final : public ForceDevice {
public:
    /// What the device of the published experiments gives, a PHANToM Premium 1.5 (data sheet of its maker).
    static constexpr double max_force_n = 8.5, continuous_force_n = 1.4;

    /// A rectangular workspace, mm, centred on the origin.
    SimulatedDevice(double width_mm, double height_mm, SimulatedPlant plant = {});

    /// Where the hand wants the finger, mm.
    void move_pointer(Vec2 position) noexcept;
    /// Puts the finger itself there at once, at rest, as when it is lifted and set down again.
    void place_finger(Vec2 position) noexcept;
    /// A hand holds the finger where it is, whatever pulls; let go, it begins at rest.
    void hold(bool held) noexcept { held_.store(held); }
    /// A relaxed hand lets itself be led: its anchor follows the finger. Moving the pointer does not tighten
    /// it.
    void relax(bool relaxed) noexcept { relaxed_.store(relaxed); }

    Result<Capabilities> open() override;
    std::optional<DeviceState> read(double now) noexcept override;
    bool write(const SafeForce& force) noexcept override;
    void halt() noexcept override { halted_.store(true, std::memory_order_release); }
    /// Time stands still for it until it is read again.
    void stop() noexcept override;

private:
    struct Pointer {
        double x = 0.0, y = 0.0;
        std::uint64_t placed = 0; ///< counts place_finger
        std::uint64_t moved = 0;  ///< counts every change
    };
    void step(double dt) noexcept;

    double width_;
    double height_;
    SimulatedPlant plant_;
    Published<Pointer> pointer_;
    std::atomic<bool> relaxed_{false};
    std::atomic<bool> held_{false};
    std::atomic<bool> halted_{false};
    Pointer sent_; ///< only the pointer's thread

    // Only the servo's thread.
    Pointer seen_;
    PlantState body_;
    PlantMotion motion_;
    std::minstd_rand lateness_{1};
    Vec2 force_{0.0};                     ///< N
    std::array<Vec2, 17> on_their_way_{}; ///< N, ring of written forces
    std::size_t newest_ = 0;
    double time_ = 0.0;
    bool started_ = false;
};

} // namespace tp
