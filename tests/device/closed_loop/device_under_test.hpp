// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/fault.hpp"
#include "loop_bench.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

namespace tp::testing {

enum class Held { not_at_all, loosely, firmly };

/// The handle of one trial; what is left out is as the device's model has it.
struct Handle {
    Held held = Held::not_at_all;
    std::optional<double> mass = {};    ///< kg
    std::optional<double> coulomb = {}; ///< N, dry friction
    std::optional<double> damping = {}; ///< N·s/m

    /// `per_mm`: how many of the plant's units of stiffness a newton per millimetre is.
    template <typename Plant>
    Plant plant(double per_mm = 1.0) const {
        Plant plant;
        plant.mass = mass.value_or(plant.mass);
        plant.coulomb = coulomb.value_or(plant.coulomb);
        plant.damping = damping.value_or(plant.damping);
        plant.hand_stiffness = held == Held::not_at_all ? 0.0 : per_mm * (held == Held::firmly ? 0.5 : 0.3);
        plant.hand_damping = held == Held::not_at_all ? 0.0 : held == Held::firmly ? 5.0 : 3.0;
        return plant;
    }
};

/// The released handles that have to settle on a line.
struct Settling {
    std::vector<double> masses = {}; ///< kg
    std::vector<double> starts = {}; ///< mm above the line
    std::vector<std::optional<double>> coulombs{std::nullopt};
    std::optional<double> damping = {};
    double farthest = 0.0;   ///< mm from the line in the end
    double to_and_fro = 0.0; ///< mm that it still moves then
    double unjudged = 0.0;   ///< s after the handle was put there, which is no motion of its own
};

/// What takes the force away in mid-touch.
struct Interruption {
    const char* name = "";
    std::function<void(LoopBench&)> begin = {};
    double within = 0.003;  ///< s, until no force is felt and a reason is told
    const char* words = ""; ///< in the reason
    Fault fault = Fault::motors_off;
    double lasts = 0.1; ///< s more; then
    std::function<void(LoopBench&)> end = {};
    double back_after = 0.8; ///< s, until the force is felt again, which comes by the ramp; 0: it stays away
    bool keeps_its_force = false; ///< the model hears nothing meanwhile; what the servo sends is judged
};

/// One thing that may go wrong in a random schedule, for a while.
struct TroubleKind {
    std::function<void(LoopBench&, double size, bool on)> set = {};
    double slack = 0.0;   ///< N that the handle's force may be off what was sent, in a schedule that holds it
    bool late = false;    ///< a tick comes late
    bool lets_go = false; ///< the person does
};

/// What a handle feels is no matter of the program any more, such as where no command gets to a device that
/// has no watchdog: what the program sends is still judged.
constexpr double unbounded = 1000.0;

/// What a device adds to the judge of all closed loops.
struct DeviceUnderTest {
    std::vector<const char*> variants; ///< their names; each test is done with each
    std::function<std::unique_ptr<LoopBench>(std::size_t variant, const Handle&, unsigned delay_ms,
                                             std::uint32_t seed)>
        make;
    /// N that the handle's force may be off what was sent; in the random schedules more may be.
    std::function<double(LoopBench&, bool troubled)> slack;
    /// Whether one force may follow another after `dt` s; empty: as ForceJudge has it.
    std::function<bool(LoopBench&, Vec2 before, Vec2 now, double dt)> may_follow;
    /// What a hand does beside holding the handle, so that all that can pull does.
    std::function<void(LoopBench&)> lean = [](LoopBench&) {};
    double at_rest = 0.0;          ///< N that its motors leave while they are on and given no force
    std::vector<double> watchdogs; ///< s of silence after which each variant lets go; 0: it never does
    Settling settling;
    std::vector<Interruption> interruptions;
    int ticks = 1000;          ///< of a random schedule
    bool in_turn = false;      ///< one schedule tries one variant, the next another
    Held grip = Held::loosely; ///< in two of three; in the third nobody holds it
    std::vector<TroubleKind> troubles;
    std::vector<TroubleKind>
        guards; ///< one of them beside the others in every fourth schedule, the last in every 16th
    /// Where the handle is when a random schedule begins; `share` is another number of 0 to 1 at each call.
    std::function<void(LoopBench&, const std::function<double()>& share)> start = [](LoopBench& bench,
                                                                                     const auto& share) {
        bench.place(bench.middle() + Vec2(0.0, 16.0 * share() - 8.0));
    };
    /// A breach of what holds for this device alone, judged after each tick of a random schedule; null: none.
    std::function<const char*(LoopBench&, double slack)> breach = [](LoopBench&, double) { return nullptr; };
    /// Takes the troubles of the link and the model away, except an unplugged cable.
    std::function<void(LoopBench&)> heal;
};

/// The rows of a table, with the bench that they are about.
template <typename Bench>
std::function<void(LoopBench&, double, bool)> of(void (*set)(Bench&, double, bool)) {
    return [set](LoopBench& bench, double size, bool on) { set(dynamic_cast<Bench&>(bench), size, on); };
}
template <typename Bench>
std::function<void(LoopBench&)> of(void (*change)(Bench&)) {
    return [change](LoopBench& bench) { change(dynamic_cast<Bench&>(bench)); };
}

/// A trouble of a bench's link or model: for a while a share of what goes over it, `most` at the most, or all of it.
template <typename Bench, typename Part, typename Troubles, typename Value>
TroubleKind trouble(Part Bench::*part, Value Troubles::*what, double slack = 0.0, double most = 1.0) {
    return {.set =
                [part, what, most](LoopBench& bench, double size, bool on) {
                    Value& value = (dynamic_cast<Bench&>(bench).*part).troubles.*what;
                    value = on ? static_cast<Value>(most * size) : Value{};
                    if constexpr (std::is_same_v<Value, bool>)
                        value = on;
                },
            .slack = slack};
}
TroubleKind late_tick(double slack = 0.0);
/// The person lets the force go and wants it again.
TroubleKind letting_go();
TroubleKind stalled_writer(double slack = 0.0);
/// The cable is pulled, and stays so.
TroubleKind pulled_cable(double slack = 0.0);

/// `y` mm above `middle`, 80 mm across.
Contour line_at(double y, Vec2 middle = Vec2(0.0));

} // namespace tp::testing
