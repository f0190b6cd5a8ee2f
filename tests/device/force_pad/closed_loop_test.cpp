// SPDX-License-Identifier: Apache-2.0
#include "../closed_loop/closed_loop_test.hpp"

#include "pad_bench.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>

namespace closed_loop_test {

using namespace tp;
using namespace tp::testing;

namespace {

/// A slip below what the residual shows puts the pad's idea of its cables' directions off by some degrees.
constexpr double slack_of_a_slip = 0.15;

DeviceUnderTest force_pad() {
    DeviceUnderTest device;
    device.variants = {"cables", "pantograph"};
    device.make = [](std::size_t variant, const Handle& handle, unsigned delay_ms, std::uint32_t seed) {
        return std::make_unique<PadBench>(variant == 1 ? pad::pantograph_pad() : pad::cable_pad(),
                                          handle.plant<PadPlant>(), delay_ms, seed);
    };
    device.slack = [](LoopBench&, bool) { return 0.02; };
    device.at_rest = 0.001; // its cables are kept tight
    device.watchdogs = {0.032, 0.032};
    device.settling = {.masses = {0.05, 0.2},
                       .starts = {2.0, 4.0, 6.0, 7.5},
                       .coulombs = {0.0},
                       .damping = 0.1,
                       .farthest = 0.1,
                       .to_and_fro = 0.2};
    device.interruptions = {
        {.name = "a writer hangs, which the pad notices",
         .begin = [](LoopBench& bench) { bench.writer_stalled = true; },
         .within = 0.040,
         .words = "heard nothing",
         .end = [](LoopBench& bench) { bench.writer_stalled = false; }},
        {.name = "its last state comes over and over",
         .begin = of<PadBench>([](PadBench& bench) { bench.link.troubles.repeats = true; }),
         .within = 0.045,
         .fault = Fault::stale_input,
         .end = of<PadBench>([](PadBench& bench) { bench.link.troubles.repeats = false; }),
         .keeps_its_force = true}, // its motors stay on, and are given none
    };
    device.troubles = {
        trouble(&PadBench::link, &LinkTroubles::drop),
        trouble(&PadBench::link, &LinkTroubles::garble),
        trouble(&PadBench::link, &LinkTroubles::odd),
        trouble(&PadBench::link, &LinkTroubles::mute),
        trouble(&PadBench::link, &LinkTroubles::repeats),
        trouble(&PadBench::link, &LinkTroubles::deaf),
        pulled_cable(),
        stalled_writer(),
        {.set = of<PadBench>(
             [](PadBench& bench, double, bool on) { bench.model.troubles.celsius = on ? 80 : 25; })},
        {.set = of<PadBench>(
             [](PadBench& bench, double, bool on) { bench.model.troubles.current_ma = on ? 2000 : 100; })},
        {.set = of<PadBench>([](PadBench& bench, double size, bool on) {
             bench.model.troubles.slip_mm[static_cast<std::size_t>(4.0 * size) % 4] =
                 on ? 6.0 * size - 3.0 : 0.0;
         }),
         .slack = slack_of_a_slip},
        {.set = of<PadBench>([](PadBench& bench, double, bool on) {
             if (on)
                 bench.model.restart();
         })},
        {.set = of<PadBench>([](PadBench& bench, double size, bool on) {
             if (on)
                 bench.place(glm::mix(bench.can.workspace[0], bench.can.workspace[2],
                                      Vec2(size, std::fmod(7.0 * size, 1.0))));
         })},
        letting_go(),
        late_tick(),
    };
    device.heal = of<PadBench>([](PadBench& bench) {
        const bool out = bench.unplugged();
        bench.link.troubles = {};
        bench.model.troubles = {};
        bench.unplugged() = out;
    });
    return device;
}

} // namespace

class ForcePadClosedLoopTest : public ClosedLoopTest {
    Q_OBJECT
public:
    ForcePadClosedLoopTest() : ClosedLoopTest(force_pad()) {}
};

} // namespace closed_loop_test

TP_TEST(closed_loop_test, ForcePadClosedLoopTest, nothing)
#include "closed_loop_test.moc"
