// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../closed_loop/fault_schedules.hpp"
#include "core/touch/tick.hpp"

#include <cmath>

/// What the closed loops of touch pads share: what goes wrong between program and pad, and a finger that walks. A bench has a
/// model pad, a cable to it (`link`) and its back end (`pad`), in simulated time.
namespace tp::testing {

enum TouchTrouble { drop, garble, cut, refuse, mute, deaf, unplugged, stalled, halted, trouble_kinds };

template <typename Bench>
void set_trouble(Bench& bench, const Trouble& trouble, bool on) {
    const double share = on ? trouble.size : 0.0;
    switch (trouble.kind) {
    case drop:
        bench.link.troubles.drop = share;
        break;
    case garble:
        bench.link.troubles.garble = share;
        break;
    case cut:
        bench.link.troubles.cut = share;
        break;
    case refuse:
        bench.link.troubles.refuse = share;
        break;
    case mute:
        bench.link.troubles.mute = on;
        break;
    case deaf:
        bench.link.troubles.deaf = on;
        break;
    case unplugged:
        bench.link.troubles.unplugged = on;
        break;
    case stalled:
        bench.writer_stalled = on;
        break;
    case halted:
        if (on)
            bench.pad.halt();
        break;
    default:
        break;
    }
}

/// Walks to and fro on a pad; a line every 3 mm.
template <typename Bench>
struct Walker {
    Bench& bench;
    int last = 0;
    unsigned long asked = 0;
    unsigned long delivered = 0;

    void tick() {
        const double x = 12.0 * std::sin(4.0 * bench.now);
        bench.put_finger({x, 3.0});
        const unsigned long before = bench.link.sends();
        const bool stalled = bench.writer_stalled;
        bench.writer_stalled = true; // delivered below, so that whoever else sends is seen
        bench.tick();
        bench.writer_stalled = stalled;
        if (bench.touch && bench.touch->touched) {
            const int line = static_cast<int>(std::floor(bench.touch->place.x / 3.0));
            if (line != last) {
                ++asked;
                delivered += bench.pad.tick(Tick(0.7, 0.5, 0.02)) ? 1 : 0;
            }
            last = line;
        }
        sends_outside_the_writer += bench.link.sends() - before;
        if (!stalled)
            bench.pad.deliver();
    }
    unsigned long sends_outside_the_writer = 0;
};

} // namespace tp::testing
