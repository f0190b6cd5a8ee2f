// SPDX-License-Identifier: Apache-2.0
#include "app/figures/report/passivity.hpp"

#include "app/figures/report/driven_device.hpp"
#include "core/guidance/haptic_scene.hpp"
#include "core/servo/servo_loop.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

namespace tp {

namespace {

constexpr double period = 0.001;      // s
constexpr long settling_ticks = 1000; // whole cycles of any whole frequency
constexpr long measured_ticks = 1000;

} // namespace

double work_per_cycle(const DrivenCase& driven) {
    const auto place = [&](double time) {
        const double grown = std::min(1.0, time / 0.2);
        const double phase = 2.0 * std::numbers::pi * driven.frequency_hz * time;
        return driven.middle_mm + grown * driven.amplitude_mm * std::sin(phase);
    };
    const auto read = [&](double time) {
        const Vec2 at(0.3, place(time));
        return driven.quantum > 0.0 ? driven.quantum * glm::round(at / driven.quantum) : at;
    };
    Capabilities can;
    can.workspace = {{-100, -75}, {100, -75}, {100, 75}, {-100, 75}};
    can.max_force = 3.0;
    can.resolution = driven.quantum;
    can.delay = period * static_cast<double>(driven.delay);
    can.damping = driven.told_damping;
    DrivenDevice device(can, read);
    VirtualClock clock;
    ServoSettings settings;
    settings.line_damping_ratio = driven.line_damping ? settings.line_damping_ratio : 0.0;
    settings.energy_observer = driven.observer;
    ServoLoop loop(device, can, clock, settings);
    const Scene line{200.0, 150.0, {contour_through("line", {{-90.0, 0.0}, {90.0, 0.0}}, false)}};
    loop.render(std::move(make_haptic_scene(line, {driven.stiffness, driven.range})).value());
    loop.engage();
    std::vector<double> written; // N, by tick
    double work = 0.0;
    for (long tick = 0; tick < settling_ticks + measured_ticks; ++tick) {
        const double now = period * static_cast<double>(tick);
        clock.sleep_until(now);
        loop.tick();
        written.push_back(device.written().y);
        if (tick < settling_ticks)
            continue;
        const double acting = written[written.size() - 1 - driven.delay]; // until the next tick
        work += acting * (place(now + period) - place(now));
    }
    return work / (driven.frequency_hz * period * static_cast<double>(measured_ticks));
}

double leak_per_cycle(const DrivenCase& driven) {
    // Σ −K x(t − nT) (x(t + T) − x(t)) over the 1/(fT) ticks of a cycle.
    const double angle = 2.0 * std::numbers::pi * driven.frequency_hz * period;
    return driven.stiffness * driven.amplitude_mm * driven.amplitude_mm / (driven.frequency_hz * period) *
           std::sin((static_cast<double>(driven.delay) + 0.5) * angle) * std::sin(0.5 * angle);
}

std::vector<PassivityRow> measure_passivity() {
    std::vector<PassivityRow> rows;
    for (const std::size_t delay : {0u, 1u, 2u, 4u})
        for (const double hz :
             {1.0,  2.0,  3.0,  4.0,  5.0,  6.0,  8.0,  10.0, 12.0, 16.0, 20.0, 24.0, 28.0, 32.0, 36.0,
              40.0, 45.0, 50.0, 55.0, 60.0, 64.0, 68.0, 72.0, 76.0, 80.0, 85.0, 90.0, 95.0, 100.0}) {
            DrivenCase driven;
            driven.frequency_hz = hz;
            driven.delay = delay;
            double bare = 0.0;
            for (const auto& [part, line_damping, observer] :
                 {std::tuple{"law", false, false}, std::tuple{"line_damping", true, false},
                  std::tuple{"observer", false, true}, std::tuple{"all", true, true}}) {
                driven.line_damping = line_damping;
                driven.observer = observer;
                const double work = work_per_cycle(driven);
                if (!line_damping && !observer)
                    bare = work;
                rows.push_back({hz, 1e3 * period * static_cast<double>(delay), part, work, work - bare});
            }
        }
    return rows;
}

} // namespace tp
