// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tp {

/// One handle that a hand drives to and fro across a straight line, and what the rendered force does to the hand.
struct DrivenCase {
    double frequency_hz = 10.0; ///< a whole number
    double amplitude_mm = 1.0;
    double middle_mm = 0.0;    ///< from the line
    double stiffness = 0.2;    ///< N/mm
    double range = 4.0;        ///< mm
    std::size_t delay = 0;     ///< ms, which are ticks
    double told_damping = 0.0; ///< N·s/m, what the device says of its own damping
    double quantum = 0.0;      ///< mm
    bool line_damping = true;
    bool observer = true;
};

/// Work of the rendered force into the hand in a cycle, mJ, the mean over a second after one for settling; through the
/// whole servo loop and its safety chain at 1 kHz. Positive: the hand is driven. The device's own damping is not in it.
double work_per_cycle(const DrivenCase& driven);

/// Work in a cycle of K x(t − nT) held for a period, in closed form, mJ: what the bare law leaks.
double leak_per_cycle(const DrivenCase& driven);

struct PassivityRow {
    double frequency_hz = 0.0;
    double delay_ms = 0.0;
    std::string part;     ///< law; line_damping, observer: the law with that; all: with both
    double work_mj = 0.0; ///< in a cycle, of the whole force
    double own_mj = 0.0;  ///< what the part adds to the bare law's
};

/// 1 to 100 Hz at 1 mm about the line, K = 0.2 N/mm, d = 4 mm, delays 0, 1, 2 and 4 ms, on a device that tells of no
/// damping of its own.
std::vector<PassivityRow> measure_passivity();

} // namespace tp
