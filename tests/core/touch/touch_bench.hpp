// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/touch/touch_loop.hpp"
#include "touch_output_double.hpp"

#include <cstddef>
#include <memory>

namespace tp::testing {

inline FlatScene upright_line(double x) {
    FlatScene flat;
    flat.names = {"line"};
    flat.lines = {Polyline{{{x, -80.0}, {x, 80.0}}, false}};
    return flat;
}

inline std::unique_ptr<const TouchScene> line_at(double x, bool tour = false) {
    auto scene = make_touch_scene(upright_line(x)).value();
    if (tour)
        scene->tour = scene->flat.lines.front();
    return scene;
}

/// A loop that is engaged over an upright line through the origin, in virtual time.
struct TouchBench {
    TouchOutputDouble output;
    VirtualClock clock;
    std::unique_ptr<TouchLoop> loop;

    explicit TouchBench(const TouchSettings& settings = {}, TouchMeans means = TouchMeans::ticks) {
        output.means = means;
        loop = std::make_unique<TouchLoop>(output, output.capabilities(), clock, settings);
        loop->engage();
        loop->render(line_at(0.0));
    }
    void pass() {
        clock.sleep_until(clock.now() + loop->period());
        loop->tick();
    }
    void rest(double seconds) {
        for (const double end = clock.now() + seconds; clock.now() < end;)
            pass();
    }
    /// The finger goes to the right along y = 0 at `speed` mm/s; where it is when the first tick comes, or where it ends.
    double go(double from, double to, double speed) {
        const std::size_t before = output.tick_count;
        double first = to;
        for (double x = from; x < to; x += speed * loop->period()) {
            loop->tell({x, 0.0});
            pass();
            if (output.tick_count > before && first == to)
                first = x;
        }
        return first;
    }
};

} // namespace tp::testing
