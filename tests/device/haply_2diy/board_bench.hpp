// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../closed_loop/loop_bench.hpp"
#include "device/guard/simulated_guard.hpp"
#include "device/haply_2diy/haply_2diy.hpp"
#include "device/haply_2diy/simulated_line.hpp"

#include <cstdint>
#include <memory>
#include <span>

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

/// A model board on a simulated line. The device is homed.
struct BoardBench : LoopBench {
    ModelBoard model;
    SimulatedLine line;
    GuardDiary guard;
    HomedNote note;
    Haply2diy device;

    explicit BoardBench(HaplyGeneration generation = HaplyGeneration::third, const HaplyPlant& plant = {},
                        unsigned later_ms = 0, std::uint32_t seed = 1)
        : model(generation, plant), line(model, later_ms, seed),
          device(generation, opener(), LatestWriter::Thread::caller),
          middle_(Pantograph(generation).middle()) {
        const Result<Capabilities> opened = device.open();
        const Result<bool> homed = device.home();
        begin(device, homed.ok() ? opened : Error{homed.error()});
    }
    ~BoardBench() override { loop.reset(); }
    Haply2diy::Opener opener() {
        return [this]() -> Result<Haply2diy::Board> {
            return Haply2diy::Board{std::make_unique<BorrowedLine>(line),
                                    std::make_unique<SimulatedGuard>(guard), note, "7523031393535120A0D1"};
        };
    }

    Vec2 felt() const override { return model.force(); }
    Vec2 middle() const override { return middle_; }
    Vec2 handle() const override { return model.handle(); }
    void place(Vec2 there) override { model.place_handle(there); }
    void move_hand(Vec2 there) override { model.move_hand(there); }
    bool& unplugged() override { return line.troubles.unplugged; }

protected:
    void deliver() override { device.deliver(); }
    void advance() override { line.advance(); }

private:
    Vec2 middle_;
};

} // namespace tp::testing
