// SPDX-License-Identifier: Apache-2.0
#include "app/figures/report/released_handle.hpp"

#include "core/servo/servo_loop.hpp"
#include "device/simulated/simulated_device.hpp"

#include <algorithm>

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

HandleResult release_at(const HandleCase& handle, double start_mm, double seconds) {
    SimulatedPlant plant;
    plant.mass = handle.mass;
    plant.damping = handle.damping;
    plant.coulomb = handle.coulomb;
    plant.quantum = handle.quantum;
    plant.delay_ticks = handle.delay;
    plant.tick = handle.period;
    plant.hand_stiffness = 0.0;
    plant.hand_damping = 0.0;
    SimulatedDevice device(200.0, 150.0, plant);
    VirtualClock clock;
    const Capabilities can = *device.open();
    ServoSettings settings;
    settings.rate = 1.0 / handle.period;
    settings.energy_observer = handle.observer;
    settings.line_damping_ratio = handle.line_damping ? settings.line_damping_ratio : 0.0;
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
    device.place_finger({0.3, 40.0}); // out of reach until the whole force is let in
    run(0.7, [](double) {});
    device.place_finger({0.3, start_mm});
    run(seconds - 1.0, [](double) {});
    HandleResult result;
    int crossings = 0;
    double last = 0.0;
    run(1.0, [&](double y) {
        result.amplitude_mm = std::max(result.amplitude_mm, std::abs(y));
        crossings += (y > 0.0) != (last > 0.0) ? 1 : 0;
        last = y;
    });
    result.settled = result.amplitude_mm < settled_below_mm;
    result.frequency_hz = result.settled ? 0.0 : 0.5 * crossings;
    return result;
}

} // namespace

HandleResult release_handle(const HandleCase& handle, double seconds) {
    HandleResult worst{0.0, 0.0, true};
    for (const double share : {0.5, 1.0, 1.5, 1.95}) {
        const HandleResult result = release_at(handle, share * handle.range, seconds);
        if (result.amplitude_mm >= worst.amplitude_mm)
            worst = result;
    }
    return worst;
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
    return grid;
}

} // namespace tp
