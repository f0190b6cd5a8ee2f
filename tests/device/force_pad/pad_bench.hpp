// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../closed_loop/loop_bench.hpp"
#include "device/force_pad/force_pad.hpp"
#include "device/force_pad/simulated_link.hpp"

#include <cstdint>
#include <memory>
#include <utility>

namespace tp::testing {

/// Lets a transport that a test keeps be opened, and counts those who have it open.
class BorrowedTransport final : public ReportTransport {
public:
    BorrowedTransport(ReportTransport& lent, std::shared_ptr<int> users)
        : lent_(lent), users_(std::move(users)) {
        ++*users_;
    }
    ~BorrowedTransport() override { --*users_; }
    BorrowedTransport(const BorrowedTransport&) = delete;
    BorrowedTransport& operator=(const BorrowedTransport&) = delete;
    Got read(pad::Frame& frame, int wait_ms) noexcept override { return lent_.read(frame, wait_ms); }
    bool write(const pad::Frame& frame) noexcept override { return lent_.write(frame); }

private:
    ReportTransport& lent_;
    std::shared_ptr<int> users_;
};

inline ForcePad::Opener lend(ReportTransport& transport,
                             std::shared_ptr<int> users = std::make_shared<int>(0)) {
    return [&transport, users]() -> Result<std::unique_ptr<ReportTransport>> {
        return std::unique_ptr<ReportTransport>(std::make_unique<BorrowedTransport>(transport, users));
    };
}

/// A model pad on a simulated cable.
struct PadBench : LoopBench {
    ModelPad model;
    SimulatedLink link;
    ForcePad device{lend(link), LatestWriter::Thread::caller};

    explicit PadBench(const pad::PadConfig& config = pad::cable_pad(), const PadPlant& plant = {},
                      unsigned delay_ms = 0, std::uint32_t seed = 1, ServoSettings settings = {})
        : model(config, plant), link(model, delay_ms, seed) {
        begin(device, device.open(), settings);
    }
    ~PadBench() override { loop.reset(); }

    Vec2 felt() const override { return model.force(); }
    Vec2 middle() const override { return middle_; }
    Vec2 handle() const override { return model.knob(); }
    void place(Vec2 there) override { model.place_knob(there); }
    void move_hand(Vec2 there) override { model.move_hand(there); }
    bool& unplugged() override { return link.troubles.unplugged; }

protected:
    void deliver() override { device.deliver(); }
    void advance() override { link.advance(); }

private:
    Vec2 middle_ = model.knob();
};

} // namespace tp::testing
