// SPDX-License-Identifier: Apache-2.0
#include "device/force_pad/pad_frames.hpp"

#include <algorithm>
#include <cmath>

namespace tp {

namespace {

double area(const std::vector<Vec2>& outline) {
    double twice = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 a = outline[i];
        const Vec2 b = outline[(i + 1) % outline.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return 0.5 * std::abs(twice);
}

} // namespace

Result<Capabilities> capabilities_of(const pad::CapabilitiesFrame& can, const std::string& serial_number,
                                     const std::vector<Vec2>& outline) {
    const auto wrong = [&](const char* what) {
        return Error{"The force pad " + serial_number + " reports values that cannot be right: " + what +
                     ". It needs different firmware."};
    };
    constexpr double farthest = 2000.0; // mm
    for (const Vec2 corner : outline)
        if (std::abs(corner.x) > farthest || std::abs(corner.y) > farthest)
            return wrong("it reaches farther than two metres");
    if (outline.size() < 3 || area(outline) < 100.0)
        return wrong("it reaches less than a square centimetre");
    if (can.max_force_mn == 0 || can.max_force_mn > 20000)
        return wrong("its strongest force is zero or above 20 newtons");
    if (can.rate_hz < 50 || can.rate_hz > 8000)
        return wrong("its rate is below 50 or above 8000 hertz");
    if (can.delay_us > 50000)
        return wrong("it acts more than 50 milliseconds late");
    if (can.watchdog_ms < 20 || can.watchdog_ms > 50)
        return wrong("its watchdog does not wait 20 to 50 milliseconds");
    Capabilities made;
    made.name = can.kind == pad::PadKind::cables ? "force pad with cables" : "force pad with a pantograph";
    made.serial_number = serial_number;
    made.workspace = outline;
    made.max_force = 1e-3 * can.max_force_mn;
    made.continuous_force = 1e-3 * std::min(can.continuous_force_mn, can.max_force_mn);
    made.resolution = 1e-3 * can.resolution_um;
    made.rate = can.rate_hz;
    made.delay = 1e-6 * can.delay_us;
    made.calibrated = true;
    return made;
}

pad::ForceFrame force_frame(const SafeForce& force) {
    const auto thousandths = [](double newtons) {
        return static_cast<std::int16_t>(std::clamp(1000.0 * newtons, -32767.0, 32767.0));
    };
    pad::ForceFrame frame;
    frame.x_mn = thousandths(force.newtons().x);
    frame.y_mn = thousandths(force.newtons().y);
    frame.motors = true;
    return frame;
}

std::string pad_sentence(std::uint16_t status) {
    if ((status & pad::status::armed) != 0)
        return {};
    if ((status & pad::status::not_homed) != 0)
        return "The force pad does not know where its knob is. Put the knob on its mark and home the pad.";
    if ((status & pad::status::unsure) != 0)
        return "The force pad's encoders contradict each other: a cable is slack, or one has slipped. Put "
               "the knob on "
               "its mark and home the pad.";
    if ((status & pad::status::hot) != 0)
        return "The force pad's motors are too hot. It goes on by itself when they have cooled.";
    if ((status & pad::status::over_current) != 0)
        return "A motor of the force pad took too much current. Check that nothing blocks the knob.";
    if ((status & pad::status::watchdog) != 0)
        return "The force pad heard nothing from this computer for a moment and switched its motors off.";
    return "The force pad's motors are off.";
}

} // namespace tp
