// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/force_pad/firmware/pad_firmware.hpp"

#include <cmath>
#include <cstdint>

namespace tp::pad {

/// A pad with sensors that a test sets by hand.
struct FirmwareBench {
    PadConfig config;
    PadFirmware pad{config};
    Sensors sensors;
    Drive drive;
    StateFrame state;
    uint16_t sequence = 100;

    explicit FirmwareBench(const PadConfig& made = cable_pad()) : config(made) {
        step();
        pad.receive(encode(CalibrateFrame{}));
        Frame answer;
        pad.answer(answer);
    }
    void step(int milliseconds = 1) {
        for (int i = 0; i < milliseconds; ++i) {
            sensors.time_us += 1000;
            drive = pad.step(sensors);
        }
        decode(pad.state(), state);
    }
    void ask_force(int x_mn, int y_mn) {
        pad.receive(
            encode(ForceFrame{++sequence, static_cast<int16_t>(x_mn), static_cast<int16_t>(y_mn), true}));
    }
    /// Armed, and the force on it long enough to be whole.
    void pull(int x_mn, int y_mn) {
        step();
        ask_force(0, 0);
        step();
        for (int i = 0; i < 40; ++i) {
            ask_force(x_mn, y_mn);
            step();
        }
    }
    double force() const { return 1e-3 * std::hypot(state.force_x_mn, state.force_y_mn); }
    bool has(uint16_t bit) const { return (state.status & bit) != 0; }
    /// The encoders as if the knob of a cable pad were at a place.
    void move_to(double x, double y) {
        for (int i = 0; i < cable_count; ++i) {
            const Vec<float> exit = config.cables.exits[i];
            const double length = std::hypot(double(exit.x) - x, double(exit.y) - y);
            const double at_mark = std::hypot(double(exit.x), double(exit.y));
            sensors.counts[i] = static_cast<int32_t>(std::lround(
                (length - at_mark) / (2.0 * 3.14159265358979 * double(config.drum_radius)) * 4096.0));
        }
    }
};

} // namespace tp::pad
