// SPDX-License-Identifier: Apache-2.0
#include "app/figures/report/delivered_force.hpp"

#include "app/figures/report/driven_device.hpp"
#include "app/figures/report/hand_path.hpp"
#include "app/figures/report/test_scenes.hpp"
#include "core/guidance/exact_law.hpp"
#include "core/guidance/haptic_scene.hpp"
#include "core/servo/servo_loop.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tp {

namespace {

constexpr double engaging = 1.0; // s, until all of the force is let in

struct Errors {
    std::vector<double> newtons;

    double mean() const {
        double sum = 0.0;
        for (const double error : newtons)
            sum += error;
        return newtons.empty() ? 0.0 : sum / static_cast<double>(newtons.size());
    }
    double p99() {
        if (newtons.empty())
            return 0.0;
        const auto at =
            newtons.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(newtons.size() - 1));
        std::nth_element(newtons.begin(), at, newtons.end());
        return *at;
    }
};

} // namespace

std::vector<DeliveredRow> measure_delivered(const std::vector<double>& speeds_mm_s, double damping_ns_per_m,
                                            double length_mm) {
    const std::vector<Vec2> path = hand_path(static_cast<std::size_t>(length_mm / hand_path_step_mm) + 2);
    const TentProfile profile;
    const ExactLaw truth(flatten(reference_face(), {1e-6, 90.0, 24}), profile);
    const ExactLaw law(flatten(reference_face()), profile);
    std::vector<DeliveredRow> rows;
    for (const double speed : speeds_mm_s) {
        const auto place = [&](double time) {
            const double way = std::max(0.0, time - engaging) * speed / hand_path_step_mm;
            const std::size_t before = std::min(static_cast<std::size_t>(way), path.size() - 2);
            return path[before] + (way - static_cast<double>(before)) * (path[before + 1] - path[before]);
        };
        Capabilities can;
        can.workspace = {{-200, -200}, {200, -200}, {200, 200}, {-200, 200}};
        can.max_force = 3.0;
        can.damping = damping_ns_per_m;
        DrivenDevice device(can, place);
        VirtualClock clock;
        ServoLoop loop(device, can, clock, ServoSettings{});
        loop.render(std::move(make_haptic_scene(reference_face(), profile)).value());
        loop.engage();
        Errors delivered;
        Errors all;
        Errors own;
        const double rate = SafetyLimits{}.max_force_rate;
        double slowed_until = 0.0; // s
        Vec2 last_finger = place(0.0);
        Vec2 last_force = truth.at(last_finger).force;
        const long ticks = std::lround(1e3 * (engaging + length_mm / speed));
        for (long tick = 0; tick < ticks; ++tick) {
            const double now = 1e-3 * static_cast<double>(tick);
            clock.sleep_until(now);
            loop.tick();
            const Vec2 finger = place(now);
            const Guidance there = truth.at(finger);
            const double change = length(there.force - last_force);
            if (change > 1.01 * profile.stiffness * length(finger - last_finger) + 1e-6)
                slowed_until = std::max(now, slowed_until) + change / rate + 0.002;
            last_finger = finger;
            last_force = there.force;
            if (now < engaging || !(there.distance < profile.band()))
                continue;
            const double error = length(device.written() - there.force);
            all.newtons.push_back(error);
            if (now < slowed_until)
                continue;
            delivered.newtons.push_back(error);
            own.newtons.push_back(length(law.at(finger).force - there.force));
        }
        const double count = static_cast<double>(std::max<std::size_t>(1, all.newtons.size()));
        rows.push_back({speed, delivered.mean(), delivered.p99(), own.mean(), own.p99(), all.mean(),
                        all.p99(), 1.0 - static_cast<double>(delivered.newtons.size()) / count,
                        damping_ns_per_m});
    }
    return rows;
}

std::vector<double> delivered_speeds() { return {5.0, 25.0, 50.0, 100.0, 200.0, 300.0}; }

} // namespace tp
