// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/servo_loop.hpp"
#include "device/force_pad/force_pad.hpp"
#include "device/force_pad/simulated_link.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace tp::testing {

/// Lets a transport that a test keeps be opened.
class BorrowedTransport final : public ReportTransport {
public:
    explicit BorrowedTransport(ReportTransport& lent) : lent_(lent) {}
    Got read(pad::Frame& frame, int wait_ms) noexcept override { return lent_.read(frame, wait_ms); }
    bool write(const pad::Frame& frame) noexcept override { return lent_.write(frame); }

private:
    ReportTransport& lent_;
};

inline ForcePad::Opener lend(ReportTransport& transport) {
    return [&transport]() -> Result<std::unique_ptr<ReportTransport>> {
        return std::unique_ptr<ReportTransport>(std::make_unique<BorrowedTransport>(transport));
    };
}

/// A model pad on a simulated cable, its back end and a servo loop with one or more lines, all in simulated
/// time.
struct PadBench {
    ModelPad model;
    SimulatedLink link;
    ForcePad device{lend(link), LatestWriter::Thread::caller};
    VirtualClock clock;
    Capabilities can;
    std::unique_ptr<ServoLoop> loop;
    bool writer_stalled = false;
    std::function<void()> after_tick = [] {};

    explicit PadBench(const pad::PadConfig& config = pad::cable_pad(), const PadPlant& plant = {},
                      unsigned delay_ms = 0, std::uint32_t seed = 1, ServoSettings settings = {})
        : model(config, plant), link(model, delay_ms, seed) {
        Result<Capabilities> opened = device.open();
        if (!opened.ok())
            return;
        can = opened.value();
        loop = std::make_unique<ServoLoop>(device, can, clock, settings);
    }
    /// The loop stops the device as it ends: before the link goes.
    ~PadBench() { loop.reset(); }
    PadBench(const PadBench&) = delete;
    PadBench& operator=(const PadBench&) = delete;

    void render(std::vector<Contour> lines) {
        auto made = make_haptic_scene(Scene{300.0, 300.0, std::move(lines)});
        loop->render(std::move(made).value());
        loop->engage();
    }
    void tick(double dt = 0.001) {
        clock.sleep_until(clock.now() + dt);
        loop->tick();
        if (!writer_stalled)
            device.deliver();
        for (double t = 0.0005; t < dt; t += 0.001)
            link.advance();
        after_tick();
    }
    void run(double seconds) {
        for (double t = 0.0005; t < seconds; t += 0.001)
            tick();
    }
};

} // namespace tp::testing
