// SPDX-License-Identifier: Apache-2.0
#include "app/figures/report/released_handle.hpp"

#include "core/servo/servo_loop.hpp"
#include "device/simulated/simulated_device.hpp"

#include <algorithm>
#include <utility>

namespace tp {

namespace {

constexpr double settled_below_mm = 0.1;

Scene straight_line() {
    // Vertices 1 mm apart, so that the published law has neighbours to find.
    std::vector<Vec2> points;
    for (int x = -90; x <= 90; ++x)
        points.emplace_back(x, 0.0);
    return {200.0, 150.0, {contour_through("line", points, false)}};
}

} // namespace

HandleResult release_handle(const HandleCase& handle, double seconds) {
    SimulatedPlant plant;
    plant.mass = handle.mass;
    plant.damping = handle.damping;
    plant.coulomb = handle.coulomb;
    plant.quantum = handle.quantum;
    plant.delay_ticks = handle.delay;
    plant.tick = handle.period;
    plant.hand_stiffness = 0.0;
    plant.hand_damping = handle.hand_damping;
    plant.told_delay_ticks = handle.told_delay;
    plant.told_damping = handle.told_damping;
    plant.jitter_ticks = handle.jitter;
    SimulatedDevice device(200.0, 150.0, plant);
    VirtualClock clock;
    const Capabilities can = *device.open();
    ServoSettings settings;
    settings.rate = 1.0 / handle.period;
    settings.energy_observer = handle.observer;
    settings.line_damping_ratio = handle.line_damping ? settings.line_damping_ratio : 0.0;
    settings.device_to_surface.linear = glm::dmat2(handle.stretch);
    ServoLoop loop(device, can, clock, settings);
    auto made = make_haptic_scene(straight_line(), {handle.stiffness, handle.range}, handle.law);
    loop.render(std::move(made).value());
    loop.engage();

    const auto run = [&](double time, const auto& see) {
        const double end = clock.now() + time;
        while (clock.now() < end - 1e-9) {
            clock.sleep_until(clock.now() + handle.period);
            loop.tick();
            see(loop.snapshot().y);
        }
    };
    device.place_finger(Vec2(0.3, handle.start_share * handle.range) / handle.stretch);
    device.hold(true);
    run(0.7, [](double) {}); // the ramp takes 0.5 s
    device.hold(false);
    HandleResult result;
    result.start_mm = std::abs(loop.snapshot().y);
    double before = 0.0; // amplitude, the last second but two
    run(seconds - 3.0, [&](double y) { result.farthest_mm = std::max(result.farthest_mm, std::abs(y)); });
    run(1.0, [&](double y) { before = std::max(before, std::abs(y)); });
    run(1.0, [&](double y) { result.farthest_mm = std::max(result.farthest_mm, std::abs(y)); });
    int crossings = 0;
    double last = 0.0;
    double lowest = loop.snapshot().y;
    double highest = lowest;
    run(1.0, [&](double y) {
        result.amplitude_mm = std::max(result.amplitude_mm, std::abs(y));
        crossings += (y > 0.0) != (last > 0.0) ? 1 : 0;
        last = y;
        lowest = std::min(lowest, y);
        highest = std::max(highest, y);
    });
    result.farthest_mm = std::max({result.farthest_mm, before, result.amplitude_mm});
    result.settled = std::min(result.amplitude_mm, highest - lowest) < settled_below_mm;
    result.swings = !result.settled && result.amplitude_mm > 0.98 * before;
    result.frequency_hz = result.settled ? 0.0 : 0.5 * crossings;
    return result;
}

std::vector<HandleCase> bounded_handles() {
    std::vector<HandleCase> all;
    const std::vector<std::pair<double, std::size_t>> rates{
        {0.001, 0}, {0.001, 1}, {0.001, 2}, {0.001, 4}, {0.00025, 0}, {0.00025, 16}, {0.004, 0}, {0.004, 1}};
    for (const double stiffness : {0.1, 0.2, 0.5})
        for (const double range : {2.0, 4.0, 8.0})
            for (const double mass : {0.05, 0.1, 0.2})
                for (const auto& [period, delay] : rates) {
                    HandleCase handle;
                    handle.stiffness = stiffness;
                    handle.range = range;
                    handle.mass = mass;
                    handle.period = period;
                    handle.delay = delay;
                    handle.damping = 1.2 * handle.bound();
                    all.push_back(handle);
                }
    return all;
}

std::vector<HandleCase> troubled_handles() {
    using Trouble = void (*)(HandleCase&);
    const std::vector<Trouble> troubles{
        [](HandleCase& handle) { handle.hand_damping = 1.0; },
        [](HandleCase& handle) { handle.hand_damping = 5.0; },
        [](HandleCase& handle) { handle.coulomb = 0.02; },
        [](HandleCase& handle) { handle.coulomb = 0.1; },
        [](HandleCase& handle) { handle.quantum = 0.09; },
        [](HandleCase& handle) { handle.stretch = 1.25; },
        [](HandleCase& handle) { handle.stretch = 1.5; },
        [](HandleCase& handle) { handle.told_delay = 0; },
        [](HandleCase& handle) { handle.told_delay = handle.delay + 1; },
        [](HandleCase& handle) { handle.told_delay = handle.delay > 0 ? handle.delay - 1 : 0; },
        [](HandleCase& handle) { handle.told_damping = 0.0; },
        [](HandleCase& handle) { handle.jitter = 1; },
        [](HandleCase& handle) { handle.jitter = 2; },
        [](HandleCase& handle) { handle.start_share = 0.5; },
        [](HandleCase& handle) { handle.start_share = 1.5; },
        [](HandleCase& handle) { handle.start_share = 1.95; },
    };
    std::vector<HandleCase> all;
    for (const Trouble trouble : troubles)
        for (const double stiffness : {0.1, 0.2, 0.5})
            for (const double range : {2.0, 4.0, 10.0})
                for (const double mass : {0.05, 0.2})
                    for (const std::size_t delay : {0u, 1u, 2u, 4u}) {
                        HandleCase handle;
                        handle.stiffness = stiffness;
                        handle.range = range;
                        handle.mass = mass;
                        handle.delay = delay;
                        trouble(handle);
                        handle.damping = 1.2 * handle.bound();
                        all.push_back(handle);
                    }
    return all;
}

std::vector<HandleCase> handle_grid(bool quick) {
    const std::vector<double> periods = quick ? std::vector{0.001} : std::vector{0.00025, 0.001, 0.004};
    const std::vector<std::size_t> delays =
        quick ? std::vector<std::size_t>{0, 1, 2} : std::vector<std::size_t>{0, 1, 2, 4};
    const std::vector<double> dampings =
        quick ? std::vector{0.05, 0.1, 0.3, 1.0} : std::vector{0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 1.0, 2.0};
    const std::vector<double> masses = quick ? std::vector{0.05, 0.2} : std::vector{0.05, 0.1, 0.2};
    std::vector<HandleCase> grid;
    for (const LawKind law : {LawKind::exact, LawKind::published})
        for (const double stiffness : {0.1, 0.2, 0.5})
            for (const double period : periods)
                for (const std::size_t delay : delays)
                    for (const double damping : dampings)
                        for (const double mass : masses)
                            for (const int remedies : {0, 1, 2, 3}) {
                                const bool observer = (remedies & 1) != 0;
                                if (law == LawKind::published && (quick || observer))
                                    continue; // a law without a potential has nothing to observe
                                HandleCase handle;
                                handle.law = law;
                                handle.stiffness = stiffness;
                                handle.period = period;
                                handle.delay = delay;
                                handle.damping = damping;
                                handle.mass = mass;
                                handle.observer = observer;
                                handle.line_damping = (remedies & 2) != 0;
                                grid.push_back(handle);
                            }
    const auto add = [&](const std::vector<HandleCase>& more) {
        grid.insert(grid.end(), more.begin(), more.end());
    };
    add(bounded_handles());
    if (!quick)
        add(troubled_handles());
    return grid;
}

} // namespace tp
