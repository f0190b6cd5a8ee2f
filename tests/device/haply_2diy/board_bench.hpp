// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/servo_loop.hpp"
#include "device/guard/simulated_guard.hpp"
#include "device/haply_2diy/haply_2diy.hpp"
#include "device/haply_2diy/simulated_line.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace tp::testing {

/// Lets a line that a test keeps be opened.
class BorrowedLine final : public SerialLine {
public:
    explicit BorrowedLine(SerialLine& lent) : lent_(lent) {}
    int read(std::span<std::uint8_t> into, int wait_ms) noexcept override {
        return lent_.read(into, wait_ms);
    }
    bool write(std::span<const std::uint8_t> bytes) noexcept override { return lent_.write(bytes); }

private:
    SerialLine& lent_;
};

/// A model board on a simulated line, its back end and a servo loop with one or more lines, all in simulated
/// time. The device is homed.
struct BoardBench {
    ModelBoard model;
    SimulatedLine line;
    GuardDiary guard;
    HomedNote note;
    Haply2diy device;
    VirtualClock clock;
    Capabilities can;
    std::unique_ptr<ServoLoop> loop;
    bool writer_stalled = false;
    std::function<void()> after_tick = [] {};

    explicit BoardBench(HaplyGeneration generation = HaplyGeneration::third, const HaplyPlant& plant = {},
                        unsigned later_ms = 0, std::uint32_t seed = 1)
        : model(generation, plant), line(model, later_ms, seed),
          device(generation, opener(), LatestWriter::Thread::caller) {
        Result<Capabilities> opened = device.open();
        if (!opened.ok() || !device.home().ok())
            return;
        can = opened.value();
        loop = std::make_unique<ServoLoop>(device, can, clock, ServoSettings{});
    }
    /// The loop stops the device as it ends: before the line goes.
    ~BoardBench() { loop.reset(); }
    BoardBench(const BoardBench&) = delete;
    BoardBench& operator=(const BoardBench&) = delete;

    Haply2diy::Opener opener() {
        return [this]() -> Result<Haply2diy::Board> {
            return Haply2diy::Board{std::make_unique<BorrowedLine>(line),
                                    std::make_unique<SimulatedGuard>(guard), note, "7523031393535120A0D1"};
        };
    }
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
            line.advance();
        after_tick();
    }
    void run(double seconds) {
        for (double t = 0.0005; t < seconds; t += 0.001)
            tick();
    }
};

} // namespace tp::testing
